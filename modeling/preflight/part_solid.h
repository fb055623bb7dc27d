#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "modeling/preflight/occupancy.h"
#include "sim/collider/triangle_mesh.h"
#include "sim/network/network.h"

namespace modeling {

using sim::Vec3;

/// What of a part is looked at: its nodes and its cells, both of the network.
struct PartCells {
  std::vector<sim::NodeIndex> nodes;  ///< ascending: all that its cells name; of a raw network, all it has
  std::span<const sim::CellCorners> cells;  ///< none: a raw network
  Eigen::AlignedBox3d box;
};

/// A part as a solid: the volume its cells fill before anything moves.
class PartSolid {
 public:
  /// The network must outlive it.
  PartSolid(const sim::Network& network, PartCells part);

  const Eigen::AlignedBox3d& box() const { return part_.box; }
  /// Mean over its cells of the shortest edge, cm; of a raw network, the mean radius of its nodes.
  double edge() const { return edge_; }

  /// A point that stands inside another thing.
  struct Inside {
    double depth = 0.0;  ///< cm to the surface; 0: none is inside
    Vec3 at = Vec3::Zero();
    Vec3 wayOut = Vec3::UnitZ();  ///< unit, to the nearest point of the surface
  };
  /// Makes the surface, which takes about as long as building the network, where there is none yet.
  void prepare();
  /// How deep a point is inside; prepare() comes first. Nothing outside, and where it is no deeper than a
  /// curved surface is cut off by its flat facets and `tolerance` (cm) say. `near`: a triangle that may be
  /// the nearest; becomes the one that was.
  std::optional<Inside> inside(const Vec3& point, double tolerance, std::uint32_t& near) const;

  /// How `others` points are looked at.
  struct Look {
    Vec3 move = Vec3::Zero();  ///< by which they are moved, cm
    double tolerance = 0.0;    ///< cm
    bool any = false;          ///< whether the first that is found will do, whichever it is
  };
  /// The deepest inside of the other's nodes and of points within its cells, which stand no further apart
  /// than the smaller cells of the two are wide, but at most kMostAlong along a cell's edge. Time: in
  /// proportion to the other's cells, with the logarithm of this one's.
  Inside deepestOf(const PartSolid& other, const Look& look);
  static constexpr int kMostAlong = 6;

 private:
  struct Deepest;

  bool mayHold(const PartSolid& other, const Look& look) const;
  void measureFacets(const std::vector<Vec3>& points,
                     const std::vector<sim::TriangleMesh::Triangle>& triangles);
  std::size_t sampleCount() const { return part_.nodes.size() + part_.cells.size(); }
  template <class Visit>
  void visitSamples(std::size_t index, double spacing, const Eigen::AlignedBox3d& within,
                    const Visit& visit) const;
  template <class Visit>
  void visitCell(std::size_t cell, double spacing, const Eigen::AlignedBox3d& within,
                 const Visit& visit) const;

  const sim::Network& network_;
  PartCells part_;
  double edge_ = 0.0;
  Occupancy occupancy_;                       ///< by the boxes of cells
  std::optional<sim::TriangleMesh> surface_;  ///< absent: not prepared, or without cells
  std::vector<float>
      cutOff_;  ///< by triangle: cm by which a smooth surface through its corners bulges over it
};

/// The parts of a network. `cellCounts`: how many cells each has in it, in order.
std::vector<PartCells> partsOf(const sim::Network& network, const std::vector<std::size_t>& cellCounts);

}  // namespace modeling
