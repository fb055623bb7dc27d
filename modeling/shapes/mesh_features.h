#pragma once

#include <optional>
#include <vector>

#include "sim/collider/triangle_mesh.h"

namespace modeling {

/// The edges of a mesh at which it is bent sharply, and the points where such edges end, or meet, or turn.
class MeshFeatures {
 public:
  /// Degrees between the normals of two faces from which on their edge is sharp.
  static constexpr double kSharpAngle = 40.0;

  explicit MeshFeatures(const sim::TriangleMesh& mesh);

  const std::vector<sim::Vec3>& corners() const { return corners_; }
  bool hasEdges() const { return edges_.has_value(); }
  /// There must be edges.
  sim::TriangleMesh::Nearest nearestOnEdges(const sim::Vec3& point) const { return edges_->nearest(point); }

 private:
  std::vector<sim::Vec3> corners_;
  std::optional<sim::TriangleMesh> edges_;  ///< as triangles of no width
};

}  // namespace modeling
