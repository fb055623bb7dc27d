#include "modeling/exchange/damage.h"
#include "modeling/exchange/export.h"
#include "modeling/exchange/frame_loop.h"
#include "modeling/exchange/obj_surface.h"
#include "modeling/exchange/surface_vertices.h"
#include "modeling/text/text_output.h"
#include "sim/base/bytes.h"

namespace modeling {

namespace {

/// All that is said of a face stands at its vertices, which no other kind of face shares: readers that take
/// faces for lists of vertices only (meshio) would lose their place at more.
sim::ByteWriter verticesIn(const sim::SurfaceMesh& mesh, const SurfaceVertices& made,
                           const std::vector<double>& damage) {
  sim::ByteWriter bytes;
  for (const SurfaceVertex& vertex : made.vertices) {
    for (const double number : mesh.points[vertex.point]) bytes.put(static_cast<float>(number));
    for (const double number : mesh.normals[vertex.normal]) bytes.put(static_cast<float>(number));
    bytes.put(static_cast<float>(damage[mesh.nodeOfPoint[vertex.point]]));
    bytes.put(vertex.fragment);
    bytes.put(std::uint32_t{vertex.material});
    bytes.put(static_cast<std::uint8_t>(vertex.inside ? 1 : 0));
  }
  return bytes;
}

sim::ByteWriter facesIn(const sim::SurfaceMesh& mesh, const SurfaceVertices& made) {
  sim::ByteWriter bytes;
  auto corner = made.corners.begin();
  for (const auto& face : mesh.faces) {
    bytes.put(face.cornerCount);
    for (unsigned c = 0; c < face.cornerCount; ++c) bytes.put(*corner++);
  }
  return bytes;
}

void writeBytes(const sim::ByteWriter& bytes, TextOutput& out) {
  out << std::string_view(reinterpret_cast<const char*>(bytes.bytes().data()), bytes.size());
}

sim::Status writeSurface(const std::filesystem::path& path, const sim::TakeReader& take,
                         const sim::SurfaceMesh& mesh, const sim::Snapshot& frame) {
  const SurfaceVertices made = verticesOf(mesh);
  TextOutput out(path);
  out << "ply\nformat binary_little_endian 1.0\ncomment Smithereens surface, cm, z up, time " << frame.time
      << " s\n";
  const std::vector<std::string> names = materialNames(take.network());
  for (std::size_t i = 0; i < names.size(); ++i)
    out << "comment material " << std::uint64_t{i} << " is " << names[i] << "\n";
  out << "element vertex " << std::uint64_t{made.vertices.size()}
      << "\nproperty float x\nproperty float y\nproperty float z"
         "\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float damage"
         "\nproperty uint fragment\nproperty uint material\nproperty uchar inside\nelement face "
      << std::uint64_t{mesh.faces.size()} << "\nproperty list uchar uint vertex_indices\nend_header\n";
  writeBytes(verticesIn(mesh, made, damageOfNodes(take.network(), frame)), out);
  writeBytes(facesIn(mesh, made), out);
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
