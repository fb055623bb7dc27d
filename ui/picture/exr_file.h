#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "sim/base/result.h"
#include "ui/picture/linear.h"

namespace ui {

/// Who takes the picture of an OpenEXR file.
struct ExrTaker {
  /// Told the size before anything large is read; a Problem refuses it.
  std::function<std::optional<sim::Problem>(std::int64_t width, std::int64_t height)> start;
  /// The next row, from the top; as read, whatever its numbers are.
  std::function<void(const std::vector<Light>& row)> row;
};

/// Reads the colours of an OpenEXR file. Where there are no plain R, G and B (or luminance and chroma), those
/// of a layer are taken ("NAME.R"), in whatever part of the file it stands: of several the one that a
/// renderer calls combined, beauty or rgba, else the first by name. A Problem without a place, which names
/// what channels there are where none are colours.
sim::Status readExrColours(const std::filesystem::path& path, const ExrTaker& taker);

}  // namespace ui
