#include "modeling/exchange/frame_loop.h"

#include <cassert>

namespace modeling {

sim::Status forEachFrame(
    const sim::TakeReader& take, const ExportRequest& request,
    const std::function<sim::Status(std::size_t index, const sim::Snapshot& frame)>& write) {
  assert(request.firstFrame <= request.lastFrame && request.lastFrame < take.frameCount());
  const double count = static_cast<double>(request.lastFrame - request.firstFrame + 1);
  for (std::size_t index = request.firstFrame; index <= request.lastFrame; ++index) {
    const auto frame = take.frame(index);
    if (!frame) return frame.problem();
    if (auto status = write(index, **frame); !status) return status;
    if (request.progress && !request.progress(static_cast<double>(index - request.firstFrame + 1) / count))
      return sim::Problem{request.path.string(), "the export was cancelled", ""};
  }
  return sim::Done{};
}

std::filesystem::path framePath(const ExportRequest& request, std::size_t frame) {
  return request.firstFrame == request.lastFrame ? request.path : numberedPath(request.path, frame);
}

std::filesystem::path sideTable(const std::filesystem::path& path, const std::string& name) {
  std::filesystem::path side = path;
  return side.replace_extension("." + name + path.extension().string());
}

sim::Snapshot splitAtStart(const sim::Snapshot& first, const sim::Snapshot& last) {
  sim::Snapshot split = last;
  split.time = first.time;
  split.stepCount = first.stepCount;
  split.positions = first.positions;
  split.velocities = first.velocities;
  return split;
}

}  // namespace modeling
