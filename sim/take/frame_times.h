#pragma once

#include <cmath>
#include <cstdint>

namespace sim {

/// When frames are due: at the first step at or after k / framesPerSecond. Follows from the simulation's time
/// alone, so that a run that was interrupted goes on with the frames it would have had.
///
/// A step counts as at a moment within this share of itself, because sums of steps are rounded. A little more
/// than what the simulation itself allows, so that a frame it has reached is never asked for again.
inline constexpr double kFrameSlack = 2e-6;

/// s: of the first frame after `time`.
inline double nextFrameTime(double time, double step, double framesPerSecond) {
  return (std::floor((time + kFrameSlack * step) * framesPerSecond) + 1.0) / framesPerSecond;
}

/// A run that goes on repeats at most this many frames; a checkpoint is about as large as a frame in double
/// precision.
inline constexpr std::uint64_t kFramesPerCheckpoint = 12;

inline bool hasReached(double time, double step, double moment) {
  return time >= moment - kFrameSlack * step;
}

}  // namespace sim
