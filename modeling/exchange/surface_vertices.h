#pragma once

#include <cstdint>
#include <vector>

#include "sim/surface/surface_mesh.h"

namespace modeling {

/// A point of a surface with one of its normals, as files need it that have one number a corner: readers that
/// know no other (meshio) take them too.
struct SurfaceVertex {
  std::uint32_t point = 0;
  std::uint32_t normal = 0;
  sim::FragmentId fragment = 0;
  sim::MaterialIndex material = 0;
  bool inside = false;

  auto operator<=>(const SurfaceVertex&) const = default;
};

struct SurfaceVertices {
  std::vector<SurfaceVertex> vertices;  ///< in the order in which faces ask for them
  std::vector<std::uint32_t> corners;   ///< of all faces, one after the other
};

/// The vertices of a surface. Surfaces that differ in nothing but where points and normals are have the same.
SurfaceVertices verticesOf(const sim::SurfaceMesh& mesh);

}  // namespace modeling
