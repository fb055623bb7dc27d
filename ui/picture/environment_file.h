#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "modeling/import/reading_process.h"
#include "sim/base/result.h"
#include "ui/picture/linear.h"

namespace ui {

/// All that is around, as radiance by longitude (across) and latitude (down, from the zenith).
struct EnvironmentImage {
  int width = 0;
  int height = 0;
  std::vector<Light> pixels;  ///< rows from the top
};

/// The largest image: 200 MB once read.
inline constexpr int kLargestEnvironmentSide = 8192;
inline constexpr int kMostEnvironmentPixels = 4096 * 2048 * 2;

/// Why an image of this size lights nothing: it must be twice as wide as high, and not too large. Its Problem
/// has no place.
std::optional<sim::Problem> wrongEnvironmentSize(std::int64_t width, std::int64_t height);

/// Reads OpenEXR (in layers too, exr_file.h), Radiance .hdr, or PNG (whose white is 1), told apart by their
/// first bytes, in a process of its own (modeling/import/reading_process.h): within the limits, whatever the
/// file does to its reader, and no longer than someone waits. A Problem for what cannot be read, is damaged
/// or cut off, too large, or not twice as wide as high, and where the reader itself failed or was too slow.
/// What is no number or below zero in it is black.
sim::Result<EnvironmentImage> readEnvironment(const std::filesystem::path& path,
                                              const modeling::ReadingLimits& limits = {},
                                              const modeling::Attendance& attendance = {});

/// How an image is read: by readEnvironment, or likewise.
using EnvironmentReader = std::function<sim::Result<EnvironmentImage>(
    const std::filesystem::path& path, const modeling::Attendance& attendance)>;

}  // namespace ui
