#pragma once

#include <string>

#include "sim/take/take.h"

namespace app {

/// Frames [first, last] of a take, both counted from 0.
struct FrameRange {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// "A:B" (either may be left out: from the first, to the last), or "A" for one. A Problem when it is no such
/// text or the take has no such frames.
sim::Result<FrameRange> parseFrameRange(const std::string& text, const sim::TakeReader& take);

/// The frame nearest in time. The take must have one.
std::size_t frameNearest(double time, const sim::TakeReader& take);

/// A Problem when the take has no frame at all.
sim::Status needFrames(const sim::TakeReader& take, const std::string& path);

}  // namespace app
