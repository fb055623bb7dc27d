#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "ui/picture/environment_file.h"

/// Radiance's .hdr: a text, the size, and rows of pixels of four bytes, three shares and the power of two
/// they have in common, mostly run by run (G. Ward, "Real Pixels", Graphics Gems II, 1991; the files' page of
/// Radiance's manual).
///
/// Read by ourselves because the format is small, and the library that Debian has of it does not end with
/// every file. Each step here takes a byte of the file at least, so that the time it takes is bounded by the
/// file's length.
namespace ui {

struct RadianceSize {
  int width = 0;
  int height = 0;
};
/// What the head says; nothing where this is no such image, or one that is not as rows from the top, left to
/// right, of red, green and blue.
std::optional<RadianceSize> radianceSize(std::span<const std::byte> file);

/// The pixels; nothing where the file is damaged or cut off. The size must be one that can be held.
std::optional<EnvironmentImage> readRadiance(std::span<const std::byte> file);

}  // namespace ui
