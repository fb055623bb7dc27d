#pragma once

#include "sim/state/motion.h"

namespace sim {

/// How nodes went from where they were to where they are: the affine map that comes nearest to all of them,
/// and how far they are from it. Rows of contacts hold while nodes move with the map: a piece that falls,
/// spins, or whose shards fly apart, each on its own tangent, needs no new ones, however far it goes.
class SharedMotion {
 public:
  SharedMotion(const NodeVectors& from, const NodeVectors& to);

  /// No two nodes that were `distance` (cm) apart are nearer to each other than this now, cm; below zero
  /// where nothing can be said. Nor are any that were further apart, by as much.
  double nearest(double distance) const { return shrinking_ * distance - largestPair_; }
  /// cm: how far a node went at most, all in all.
  double furthest() const { return furthest_; }

 private:
  void fit(const NodeVectors& from, const NodeVectors& to);
  void measure(const NodeVectors& from, const NodeVectors& to);

  Vec3 centre_ = Vec3::Zero();  ///< of `from`, cm
  Vec3 shift_ = Vec3::Zero();   ///< of the centre, cm
  Eigen::Matrix3d stretch_ = Eigen::Matrix3d::Zero();
  double shrinking_ = 1.0;    ///< of the direction that the map shortens most, never above one
  double largestPair_ = 0.0;  ///< cm: sum of the two largest distances from the map
  double furthest_ = 0.0;
};

}  // namespace sim
