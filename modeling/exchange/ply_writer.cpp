#include <map>
#include <utility>

#include "modeling/exchange/damage.h"
#include "modeling/exchange/export.h"
#include "modeling/exchange/frame_loop.h"
#include "modeling/exchange/obj_surface.h"
#include "modeling/text/text_output.h"
#include "sim/base/bytes.h"

namespace modeling {

namespace {

/// PLY has one index a corner: a vertex is a point with one of its normals.
struct PlyBody {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
  sim::ByteWriter vertices, faces;
};

std::uint32_t vertex(const sim::SurfaceMesh& mesh, const std::vector<double>& damage, std::uint32_t point,
                     std::uint32_t normal, PlyBody& body) {
  const auto [at, isNew] =
      body.known.try_emplace({point, normal}, static_cast<std::uint32_t>(body.known.size()));
  if (!isNew) return at->second;
  for (const double number : mesh.points[point]) body.vertices.put(static_cast<float>(number));
  for (const double number : mesh.normals[normal]) body.vertices.put(static_cast<float>(number));
  body.vertices.put(static_cast<float>(damage[mesh.nodeOfPoint[point]]));
  return at->second;
}

PlyBody bodyOf(const sim::SurfaceMesh& mesh, const std::vector<double>& damage) {
  PlyBody body;
  for (const auto& face : mesh.faces) {
    body.faces.put(face.cornerCount);
    for (unsigned c = 0; c < face.cornerCount; ++c)
      body.faces.put(vertex(mesh, damage, face.points[c], face.normals[c], body));
    body.faces.put(face.fragment);
    body.faces.put(std::uint32_t{face.material});
    body.faces.put(static_cast<std::uint8_t>(face.inside ? 1 : 0));
  }
  return body;
}

void writeBytes(const sim::ByteWriter& bytes, TextOutput& out) {
  out << std::string_view(reinterpret_cast<const char*>(bytes.bytes().data()), bytes.size());
}

sim::Status writeSurface(const std::filesystem::path& path, const sim::TakeReader& take,
                         const sim::SurfaceMesh& mesh, const sim::Snapshot& frame) {
  const PlyBody body = bodyOf(mesh, damageOfNodes(take.network(), frame));
  TextOutput out(path);
  out << "ply\nformat binary_little_endian 1.0\ncomment Smithereens surface, cm, z up, time " << frame.time
      << " s\n";
  const std::vector<std::string> names = materialNames(take.network());
  for (std::size_t i = 0; i < names.size(); ++i)
    out << "comment material " << std::uint64_t{i} << " is " << names[i] << "\n";
  out << "element vertex " << std::uint64_t{body.known.size()}
      << "\nproperty float x\nproperty float y\nproperty float z"
         "\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float damage"
         "\nelement face "
      << std::uint64_t{mesh.faces.size()}
      << "\nproperty list uchar uint vertex_indices\nproperty uint fragment\nproperty uint material"
         "\nproperty uchar inside\nend_header\n";
  writeBytes(body.vertices, out);
  writeBytes(body.faces, out);
  return out.finish();
}

}  // namespace

sim::Status writePly(const sim::TakeReader& take, const ExportRequest& request) {
  sim::SurfaceBuilder builder(take.network(), request.looseNodes);
  return forEachFrame(take, request, [&](std::size_t index, const sim::Snapshot& frame) {
    return writeSurface(framePath(request, index), take, surfaceOf(take, frame, request, builder), frame);
  });
}

}  // namespace modeling
