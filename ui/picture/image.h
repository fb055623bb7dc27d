#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "sim/base/result.h"

namespace ui {

/// A picture as it is shown: sRGB, 16 bit a channel, rows from the top, red, green, blue.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> samples;  ///< 3 width height

  bool operator==(const Image&) const = default;
};

enum class PngDepth { eightBit, sixteenBit };

/// The bytes an 8-bit file holds. Rounding is dithered by less than one level, the same in every run: the
/// long gradient of a backdrop would show its steps otherwise.
std::vector<std::uint8_t> toEightBit(const Image& image);

/// Writes a PNG with the sRGB chunk. The file appears whole or not at all. A Problem names the file.
sim::Status writePng(const std::filesystem::path& path, const Image& image,
                     PngDepth depth = PngDepth::eightBit);

}  // namespace ui
