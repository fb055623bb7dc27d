#include <array>
#include <charconv>

#include "modeling/exchange/export.h"
#include "modeling/exchange/frame_loop.h"
#include "modeling/exchange/obj_surface.h"
#include "modeling/exchange/surface_vertices.h"
#include "modeling/text/text_output.h"
#include "sim/base/bytes.h"

namespace modeling {

namespace {

std::string_view asText(const sim::ByteWriter& bytes) {
  return {reinterpret_cast<const char*>(bytes.bytes().data()), bytes.size()};
}

/// "POINTCACHE2", version, points, first frame, frames between samples, samples.
sim::ByteWriter head(std::size_t points, std::size_t frames) {
  static constexpr std::array<char, 12> kMagic{'P', 'O', 'I', 'N', 'T', 'C', 'A', 'C', 'H', 'E', '2', '\0'};
  sim::ByteWriter bytes;
  bytes.put(kMagic);
  bytes.put(std::int32_t{1});
  bytes.put(static_cast<std::int32_t>(points));
  bytes.put(0.0F);
  bytes.put(1.0F);
  bytes.put(static_cast<std::int32_t>(frames));
  return bytes;
}

std::string remarkOf(const sim::TakeReader& take, std::size_t frames) {
  std::array<char, 32> digits;
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), take.header().framesPerSecond).ptr;
  return "# frames_per_second " + std::string(digits.data(), end) + "\n# frames " + std::to_string(frames) +
         "\n";
}

sim::Status writeCache(const sim::TakeReader& take, const ExportRequest& request, const sim::Snapshot& split,
                       sim::SurfaceBuilder& builder, const SurfaceVertices& made) {
  TextOutput out(request.path);
  out << asText(head(made.vertices.size(), request.lastFrame - request.firstFrame + 1));
  sim::Snapshot moment = split;
  const auto status =
      forEachFrame(take, request, [&](std::size_t, const sim::Snapshot& frame) -> sim::Status {
        moment.positions = frame.positions;
        const sim::SurfaceMesh mesh = builder.build(moment);
        sim::ByteWriter bytes;
        for (const SurfaceVertex& vertex : made.vertices) {
          for (const double number : mesh.points[vertex.point]) bytes.put(static_cast<float>(number));
        }
        out << asText(bytes);
        return out.good() ? sim::Status(sim::Done{}) : out.finish();
      });
  return status ? out.finish() : status;
}

}  // namespace

sim::Status writePc2(const sim::TakeReader& take, const ExportRequest& request) {
  const auto scene = sceneOf(take);
  if (!scene) return scene.problem();
  const auto first = take.frame(request.firstFrame);
  if (!first) return first.problem();
  const auto last = take.frame(request.lastFrame);
  if (!last) return last.problem();
  const sim::Snapshot split = splitAtStart(**first, **last);
  sim::SurfaceBuilder builder(take.network(), request.looseNodes);
  const sim::SurfaceMesh mesh = builder.build(split);
  std::filesystem::path object = request.path;
  object.replace_extension(".obj");
  const auto status = writeObjSurface(object, materialNames(take.network()), looksOf(*scene, take.network()),
                                      mesh, remarkOf(take, request.lastFrame - request.firstFrame + 1));
  return status ? writeCache(take, request, split, builder, verticesOf(mesh)) : status;
}

}  // namespace modeling
