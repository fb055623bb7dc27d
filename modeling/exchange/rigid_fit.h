#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "sim/network/network.h"
#include "sim/state/snapshot.h"

namespace modeling {

using sim::Vec3;

/// Where a rigid piece is: worldFromPiece, which takes a piece's own point p to position + rotation p. cm.
struct Pose {
  Vec3 position = Vec3::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

/// A rotation that moves `from` to `to` about the origin as nearly as one can, in the sum of squares (Kabsch
/// 1976, by singular values, reflections excluded). What the points leave open (they are on a line, or one)
/// is as in `before`.
Eigen::Quaterniond bestRotation(const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                                const Eigen::Quaterniond& before);

/// The fragments that a take ends in, from its first frame on: before it breaks off, a fragment is the nodes
/// that will be it.
struct FinalFragment {
  sim::Fragment fragment;             ///< as in the last frame
  sim::MovingFragment moving;         ///< as in the last frame
  std::vector<sim::NodeIndex> nodes;  ///< ascending
  Vec3 origin = Vec3::Zero();         ///< mean of its nodes in the first frame, world, cm
  double radius = 0.0;                ///< of its nodes about the origin in the first frame, cm
};

/// By id. Nodes whose fragment is not among the last frame's are left out.
std::vector<FinalFragment> finalFragments(const sim::Snapshot& first, const sim::Snapshot& last);

/// How far the nodes of a fragment were from where its rigid motion has them, cm, over all frames.
struct FitResidual {
  double sumOfSquares = 0.0;
  double largest = 0.0;
  std::uint64_t count = 0;

  double rootMeanSquare() const;
  void add(double distance);
  void add(const FitResidual& other);
};

/// The rigid motion that fits a fragment's nodes best. In the first frame, with which it begins, the pose is
/// the origin, unrotated.
class RigidMotion {
 public:
  RigidMotion(const FinalFragment& fragment, const sim::Snapshot& first);

  /// Fits the next frame, starting from the pose before.
  void follow(const sim::Snapshot& frame);

  const std::vector<Pose>& poses() const { return poses_; }  ///< one a frame
  const FitResidual& residual() const { return residual_; }

 private:
  const FinalFragment* fragment_;
  std::vector<Vec3> local_;  ///< the nodes about the origin in the first frame
  std::vector<Pose> poses_;
  FitResidual residual_;
};

}  // namespace modeling
