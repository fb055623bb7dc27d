#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "modeling/import/reading_apart.h"
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

/// Reads OpenEXR, Radiance .hdr, or PNG (whose white is 1), told apart by their first bytes. A Problem, with
/// little memory taken, for what cannot be read, is damaged or cut off, too large, or not twice as wide as
/// high. What is no number or below zero in it is black.
///
/// Reading is done in a process of its own (modeling/import/reading_apart.h), in bounded time; it is given up
/// where `keepGoing`, asked ten times a second, says no.
sim::Result<EnvironmentImage> readEnvironment(const std::filesystem::path& path,
                                              const std::function<bool()>& keepGoing = {});

/// The same by any reader of the file at `path`, within these limits.
using EnvironmentReader = std::function<sim::Result<EnvironmentImage>()>;
sim::Result<EnvironmentImage> readEnvironmentBy(const EnvironmentReader& reader,
                                                const std::filesystem::path& path,
                                                const std::function<bool()>& keepGoing,
                                                const modeling::ReadingLimits& limits);

}  // namespace ui
