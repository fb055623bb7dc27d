#pragma once

#include "sim/dynamics/snapshot.h"
#include "sim/network/surface.h"

namespace sim {

/// The polygons of one moment with vertex normals (paper, "Rendering"): what pictures draw and exports write.
/// Faces index points and normals separately, so that a point on a sharp edge has one position and several
/// normals. Faces are ordered by fragment, then by cell; the shards of isolated nodes come last in theirs.
struct SurfaceMesh {
  struct Face {
    std::array<std::uint32_t, 4> points;   ///< counter-clockwise seen from outside; a triangle uses three
    std::array<std::uint32_t, 4> normals;  ///< one a corner
    std::uint8_t cornerCount = 4;          ///< 4, or 3 for the shards
    bool inside = false;                   ///< a broken face: the inside of the material shows
    MaterialIndex material = 0;
    PartIndex part = 0;
    FragmentId fragment = kNone;
    CellIndex cell = kNone;  ///< whose face it is; kNone for the shards
  };
  std::vector<Vec3> points;            ///< cm
  std::vector<Vec3> restPoints;        ///< where each point is in the network at rest: what grain sticks to
  std::vector<Vec3> normals;           ///< unit, outward
  std::vector<NodeIndex> nodeOfPoint;  ///< the node a point is at, or for a shard's points, belongs to
  std::vector<Face> faces;
};

/// Makes the surface of any moment of one network.
///
/// Faces that meet at an edge share normals (weighted by the corner angles) where both are outside or both
/// are broken, and where they met at less than the crease angle in the network at rest: judged at rest, an
/// edge does not flicker between smooth and sharp while the body bends.
///
/// A node without an unbroken cell and without an intact bond is a tetrahedron of its own, slightly
/// irregular, turned at random by its index, inside the sphere of kShardReach times the node's radius.
class SurfaceBuilder {
 public:
  /// Degrees between face normals. A cylinder needs at least ten faces around to be smooth; the rim of a slab
  /// (90) stays sharp.
  static constexpr double kCreaseAngle = 40.0;
  /// Two shards that touch are one radius apart: 0.75 lets irregular ones nearly meet and rarely overlap.
  static constexpr double kShardReach = 0.75;

  /// Keeps a reference to the network.
  explicit SurfaceBuilder(const Network& network);

  SurfaceMesh build(const Snapshot& moment) const;

 private:
  const Network& network_;
  CellFaces cellFaces_;
};

/// The network before anything moved, as a moment: positions at rest, nothing broken, one fragment a
/// connected component, numbered in order of their first nodes. For drawing what has not been simulated.
Snapshot momentAtRest(const Network& network);

}  // namespace sim
