#include "modeling/exchange/fragment_motion.h"

#include <cmath>

#include "modeling/exchange/frame_loop.h"
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
  ExportRequest partly = request;
  if (request.progress) partly.progress = [&](double done) { return request.progress(share * done); };
  const auto status = forEachFrame(take, partly, [&](std::size_t, const sim::Snapshot& frame) -> sim::Status {
    sim::parallelFor(fits.size(), [&](std::size_t i) { fits[i].follow(frame); });
    return sim::Done{};
  });
  if (!status) return status.problem();
  for (const RigidMotion& fit : fits) {
    motion.poses.push_back(fit.poses());
    motion.residuals.push_back(fit.residual());
  }
  return motion;
}

}  // namespace modeling
