#include "modeling/exchange/surface_vertices.h"

#include <map>

namespace modeling {

SurfaceVertices verticesOf(const sim::SurfaceMesh& mesh) {
  SurfaceVertices made;
  std::map<SurfaceVertex, std::uint32_t> known;
  for (const auto& face : mesh.faces) {
    for (unsigned c = 0; c < face.cornerCount; ++c) {
      const SurfaceVertex vertex{face.points[c], face.normals[c], face.fragment, face.material, face.inside};
      const auto [at, isNew] = known.try_emplace(vertex, static_cast<std::uint32_t>(made.vertices.size()));
      if (isNew) made.vertices.push_back(vertex);
      made.corners.push_back(at->second);
    }
  }
  return made;
}

}  // namespace modeling
