#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/state/motion.h"

namespace sim {

/// Boxes of fragments along the axes, in which whatever may touch is looked for first: nodes are
/// compared only where boxes come near each other. Made anew in one pass over the nodes, cheaper than looking
/// who moved.
class FragmentBoxes {
 public:
  using Box = Eigen::AlignedBox3d;

  FragmentBoxes(const NodeVectors& positions, std::span<const FragmentId> fragmentOfNode,
                std::size_t fragmentCount);

  const Box& of(FragmentId fragment) const { return boxes_[fragment]; }
  /// For each fragment a box that holds all its nodes nearer than `distance` (cm) to a node of another; empty
  /// where there is none. Sweeps along the longest axis of all.
  std::vector<Box> meetings(double distance) const;

 private:
  std::vector<Box> boxes_;  ///< by fragment; empty where all nodes were given away
};

}  // namespace sim
