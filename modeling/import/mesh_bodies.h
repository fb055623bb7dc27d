#pragma once

#include <cstddef>
#include <vector>

#include "sim/collider/triangle_mesh.h"

namespace modeling {

/// What a mesh consists of: what hangs together by edges is a body.
struct MeshBodies {
  std::size_t closed = 0;  ///< bodies without a gap
  std::size_t turned = 0;  ///< of these, that were inside out and were turned
  std::size_t filled = 0;  ///< of these, within another one and facing the same way: no hollow
};

/// Of more bodies, those within others are not looked for.
inline constexpr std::size_t kMostNestedBodies = 2000;

/// Turns closed bodies that are inside out. Of one within another, what counts is how it faces against that:
/// the other way makes a hollow, which stays one when both are turned.
MeshBodies turnOutwards(const std::vector<sim::Vec3>& points,
                        std::vector<sim::TriangleMesh::Triangle>& triangles);

}  // namespace modeling
