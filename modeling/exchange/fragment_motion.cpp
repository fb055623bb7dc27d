#include "modeling/exchange/fragment_motion.h"

#include <cmath>

#include "sim/base/parallel.h"

namespace modeling {

namespace {

/// The times of the frames (s, from the first), as whole frames where none is off by half of one.
std::vector<double> frameTimes(const sim::TakeReader& take, const ExportRequest& request) {
  const double rate = take.header().framesPerSecond;
  const double start = take.frameTime(request.firstFrame);
  std::vector<double> exact, whole;
  bool regular = true;
  for (std::size_t frame = request.firstFrame; frame <= request.lastFrame; ++frame) {
    exact.push_back(take.frameTime(frame) - start);
    whole.push_back(static_cast<double>(frame - request.firstFrame) / rate);
    regular = regular && std::abs(exact.back() - whole.back()) < 0.5 / rate;
  }
  return regular ? whole : exact;
}

sim::Snapshot splitAtStart(const sim::Snapshot& first, const sim::Snapshot& last) {
  sim::Snapshot split = last;
  split.time = first.time;
  split.stepCount = first.stepCount;
  split.positions = first.positions;
  split.velocities = first.velocities;
  return split;
}

}  // namespace

sim::Result<FragmentMotion> fragmentMotion(const sim::TakeReader& take, const ExportRequest& request,
                                           double share) {
  const auto first = take.frame(request.firstFrame);
  if (!first) return first.problem();
  const auto last = take.frame(request.lastFrame);
  if (!last) return last.problem();
  FragmentMotion motion;
  motion.framesPerSecond = take.header().framesPerSecond;
  motion.times = frameTimes(take, request);
  motion.fragments = finalFragments(**first, **last);
  motion.split = splitAtStart(**first, **last);
  std::vector<RigidMotion> fits;
  for (const FinalFragment& fragment : motion.fragments) fits.emplace_back(fragment, **first);
  for (std::size_t index = request.firstFrame; index <= request.lastFrame; ++index) {
    const auto frame = take.frame(index);
    if (!frame) return frame.problem();
    sim::parallelFor(fits.size(), [&](std::size_t i) { fits[i].follow(**frame); });
    const double done = static_cast<double>(index - request.firstFrame + 1);
    if (request.progress && !request.progress(share * done / static_cast<double>(motion.times.size())))
      return sim::Problem{request.path.string(), "the export was cancelled", ""};
  }
  for (const RigidMotion& fit : fits) {
    motion.poses.push_back(fit.poses());
    motion.residuals.push_back(fit.residual());
  }
  return motion;
}

}  // namespace modeling
