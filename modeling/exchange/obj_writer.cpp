#include <array>
#include <charconv>

#include "modeling/exchange/export.h"
#include "modeling/exchange/frame_loop.h"
#include "modeling/exchange/obj_surface.h"

namespace modeling {

namespace {

std::string timeRemark(double seconds) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), seconds).ptr;
  return "# time " + std::string(digits.data(), end) + " s\n";
}

}  // namespace

sim::Status writeObj(const sim::TakeReader& take, const ExportRequest& request) {
  const auto scene = sceneOf(take);
  if (!scene) return scene.problem();
  const std::vector<std::string> names = materialNames(take.network());
  const std::vector<Look> looks = looksOf(*scene, take.network());
  sim::SurfaceBuilder builder(take.network(), request.looseNodes);
  return forEachFrame(take, request, [&](std::size_t index, const sim::Snapshot& frame) {
    return writeObjSurface(framePath(request, index), names, looks, surfaceOf(take, frame, request, builder),
                           timeRemark(frame.time));
  });
}

}  // namespace modeling
