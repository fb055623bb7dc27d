#pragma once

#include <array>
#include <vector>

#include "sim/surface/surface_topology.h"

namespace sim {

/// Curved patches over the faces of a surface, without gaps: neighbours share the curve of their common edge.
///
/// An edge's curve starts and ends along the surface: perpendicular to the normal of an end where it is
/// smooth, along both planes where it is sharp; edges between broken faces are straight. A patch is the Coons
/// patch of its four curves (the idea of PN triangles, Vlachos et al. 2001, on quadrilaterals).
class CurvedFaces {
 public:
  /// Keeps a reference to the surface.
  explicit CurvedFaces(const SurfaceMesh& surface);

  /// The point of a face at (u, v) in [0, 1]^2; corners 0, 1, 2, 3 are at (0,0), (1,0), (1,1), (0,1), where a
  /// triangle's third is the fourth too. Not for triangles of broken ground, which are flat.
  Vec3 point(std::size_t face, double u, double v) const;

 private:
  struct Edge {
    std::uint32_t low = 0;  ///< points, low < high; the curve runs from low to high
    std::uint32_t high = 0;
    Vec3 lowTangent = Vec3::Zero();
    Vec3 highTangent = Vec3::Zero();
  };
  struct Side;

  Vec3 tangent(std::uint32_t at, std::uint32_t to, const std::vector<std::uint32_t>& normals) const;
  /// On side s of the face, from its corner s to its corner s + 1.
  Vec3 sidePoint(std::size_t face, std::uint32_t side, double share) const;

  const SurfaceMesh& surface_;
  std::vector<Edge> edges_;
  std::vector<std::array<std::uint32_t, 4>> edgesOfFace_;
};

}  // namespace sim
