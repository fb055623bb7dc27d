#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "sim/network/network.h"

namespace sim {

/// A face of the surface, with three or four corners, counter-clockwise seen from outside.
struct SurfaceMeshFace {
  std::array<std::uint32_t, 4> points{};   ///< a triangle repeats its third
  std::array<std::uint32_t, 4> normals{};  ///< one a corner
  std::uint8_t cornerCount = 4;
  bool inside = false;   ///< broken: the inside of the material shows
  bool covered = false;  ///< of a glued part, on or in the part it is glued to: closes it, but is not seen
  MaterialIndex material = 0;
  PartIndex part = 0;
  FragmentId fragment = kNone;
  CellIndex cell = kNone;  ///< in whose material it lies; kNone for bodies drawn in place of loose nodes
};

/// The surface of one state of breaking, wherever its nodes are: how points follow nodes, what faces they
/// span, and which corners of faces share a normal. placeSurface() puts it where the nodes of a moment are;
/// the same topology, placed at several moments, has the same points and faces throughout.
///
/// A point at a node goes with it. Any other hangs on anchors: it is the mean of where each of them would
/// carry it, anchor position + fit (rest offset). The fit is how the material about the anchor is turned and
/// stretched, so that in fragments which have only moved rigidly all points fit together as they did at rest.
struct SurfaceTopology {
  using Face = SurfaceMeshFace;

  struct Anchor {
    NodeIndex node = kNone;
    std::uint32_t fit = 0;
    Vec3 offset = Vec3::Zero();  ///< cm, from the node to the point, at rest
  };
  /// How the surroundings of a node are turned and stretched, from where the supports are. Of material that
  /// holds together: the sum of (support - node) gradient^T, exact for any affine motion. Rigid, for loose
  /// nodes and what is given to others: the rotation nearest to that of the supports which are still near.
  struct Fit {
    NodeIndex node = kNone;
    bool rigid = false;
    std::uint32_t firstSupport = 0;
    std::uint32_t lastSupport = 0;  ///< one past
  };
  struct Support {
    NodeIndex node = kNone;
    Vec3 vector = Vec3::Zero();  ///< gradient, 1/cm; of a rigid fit: offset at rest, cm
  };

  // Points, one entry each.
  std::vector<Vec3> restPoints;               ///< cm: where the point is in the network at rest
  std::vector<NodeIndex> nodeOfPoint;         ///< the node it is at, or the first it hangs on
  std::vector<float> damage;                  ///< share of the bonds of the nodes it hangs on that are broken
  std::vector<std::uint32_t> firstAnchor{0};  ///< one more; a point at its node has none

  std::vector<Anchor> anchors;
  std::vector<Fit> fits;
  std::vector<Support> supports;

  /// Those of a fragment stand together, and in it those of a cell.
  std::vector<Face> faces;

  // Normals: the corners that share one, each 4 face + place.
  std::vector<std::uint32_t> firstCorner{0};
  std::vector<std::uint32_t> corners;

  std::size_t pointCount() const { return restPoints.size(); }
  std::size_t normalCount() const { return firstCorner.size() - 1; }
};

/// The polygons of one moment with vertex normals (paper, "Rendering"): what pictures draw and exports write.
/// Faces index points and normals separately, so that a point on a sharp edge has one position and several
/// normals.
struct SurfaceMesh {
  using Face = SurfaceMeshFace;
  std::vector<Vec3> points;      ///< cm
  std::vector<Vec3> restPoints;  ///< where each point is in the network at rest: what grain sticks to
  std::vector<Vec3> normals;     ///< unit, outward
  std::vector<NodeIndex> nodeOfPoint;
  std::vector<float> damage;  ///< one a point, 0 to 1
  std::vector<Face> faces;
};

/// Where the points are when the nodes are at `positions`. Loops run in parallel; results do not depend on
/// it.
std::vector<Vec3> placePoints(const SurfaceTopology& topology, const std::vector<Vec3>& positions);

/// The mean of the normals of the faces that share each, weighted by the angles at their corners.
std::vector<Vec3> placeNormals(const SurfaceTopology& topology, const std::vector<Vec3>& points);

SurfaceMesh placeSurface(const SurfaceTopology& topology, const std::vector<Vec3>& positions);

/// Joins corners of faces that meet at an edge into common normals where both faces are outside or both are
/// broken, and where they met at less than the crease angle at rest: judged at rest, an edge does not flicker
/// between smooth and sharp while the body bends. Fills in the normals of faces, firstCorner and corners.
void groupNormals(SurfaceTopology& topology);

/// Appends all of `added`, renumbered.
void appendTopology(SurfaceTopology& topology, const SurfaceTopology& added);

}  // namespace sim
