#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "sim/network/network.h"
#include "sim/state/snapshot.h"

namespace modeling {

using sim::Vec3;

Vec3 meanOf(const std::vector<sim::NodeIndex>& nodes, const std::vector<Vec3>& positions);

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

/// A fragment of a frame, and where its nodes were in the first one.
struct FinalFragment {
  sim::Fragment fragment;             ///< as in the frame
  sim::MovingFragment moving;         ///< likewise
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

/// The rigid motion that fits a fragment's nodes best, which may become fewer: where it takes what was about
/// its origin in the first frame.
class RigidMotion {
 public:
  /// `first`: of all nodes, cm; kept a reference to. `before`: how it is turned before the first that it
  /// follows, as far as the nodes do not say.
  RigidMotion(const std::vector<Vec3>& first, Vec3 origin,
              Eigen::Quaterniond before = Eigen::Quaterniond::Identity());

  /// Fits these nodes of the next frame, starting from the pose before. Where they are still as in the first
  /// frame, the pose is the origin, unrotated.
  void follow(const std::vector<sim::NodeIndex>& nodes, const std::vector<Vec3>& now);

  const Vec3& origin() const { return origin_; }
  const Eigen::Quaterniond& rotation() const { return rotation_; }  ///< of the last pose
  const std::vector<Pose>& poses() const { return poses_; }         ///< one a frame followed
  const FitResidual& residual() const { return residual_; }

 private:
  const std::vector<Vec3>* first_;
  Vec3 origin_;
  Eigen::Quaterniond rotation_;
  std::vector<Pose> poses_;
  FitResidual residual_;
};

}  // namespace modeling
