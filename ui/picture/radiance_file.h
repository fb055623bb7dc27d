#pragma once

#include <cstddef>
#include <span>

#include "sim/base/result.h"
#include "ui/picture/environment_file.h"

namespace ui {

/// Reads a Radiance picture (.hdr, .pic), as G. Ward's "Real Pixels" (Graphics Gems II) and the Radiance file
/// formats have it: flat scanlines, those of old and of new run lengths, mixed or not; all eight orders that
/// the resolution line may state; EXPOSURE and COLORCORR, by which radiance is divided; GAMMA, which is
/// undone. Pixels of 32-bit_rle_xyze are refused by name.
///
/// The time is in proportion to the bytes and the pixels, whatever they say, and nothing is set aside before
/// the size is known to be one of an environment. What follows the last pixel is not looked at. The Problem
/// has no place. Numbers are as stored: mantissa / 256 * 2^(exponent - 128), not cleaned.
sim::Result<EnvironmentImage> readRadiance(std::span<const std::byte> bytes);

}  // namespace ui
