#pragma once

#include <cstddef>

#include "sim/base/types.h"

namespace sim {

class TriangleMesh;

/// Where a surface passes through itself. Triangles that have a corner in common, or that lie in one plane,
/// do not count.
struct MeshCrossings {
  std::size_t triangles = 0;  ///< that another one passes through
  Vec3 first = Vec3::Zero();  ///< cm, on the first of them
};

/// Takes about as long as reading the mesh.
MeshCrossings crossingsOf(const TriangleMesh& mesh);

}  // namespace sim
