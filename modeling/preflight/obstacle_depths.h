#pragma once

#include <vector>

#include "modeling/preflight/part_solid.h"
#include "sim/collider/collider.h"

namespace modeling {

/// A node inside an obstacle.
struct NodeInside {
  double depth = 0.0;  ///< cm; 0: none is
  sim::NodeIndex node = sim::kNone;
  Vec3 wayOut = Vec3::UnitZ();  ///< unit
};

/// Which nodes are looked at, and where.
struct NodeLook {
  Vec3 move = Vec3::Zero();        ///< by which they are moved, cm
  std::vector<std::uint8_t> only;  ///< by part: zero, its nodes are passed over; empty: none is
  bool any = false;                ///< whether the first that is found will do, whichever it is
};

/// The deepest free node of each part (by nodeParts) inside the obstacle. Held ones do not count, nor depths
/// of less than a thousandth of the node's radius.
std::vector<NodeInside> deepestNodes(const sim::Network& network, const sim::Collider& obstacle,
                                     const NodeLook& look = {});

/// The deepest point of an obstacle's surface within a part, of points no further apart than about the part's
/// cells are wide.
PartSolid::Inside deepestPoint(const sim::Collider& obstacle, const PartSolid& part, double tolerance);

}  // namespace modeling
