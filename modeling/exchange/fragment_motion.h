#pragma once

#include <map>
#include <vector>

#include "modeling/exchange/export.h"
#include "modeling/exchange/rigid_fit.h"

namespace modeling {

/// How a fragment moves, as a rigid piece, from the frame in which it is first seen to the last in which it
/// is.
struct FragmentMotion {
  sim::Fragment fragment;      ///< as in the last of its frames
  sim::NodeIndex node = 0;     ///< one that it began with
  std::size_t firstFrame = 0;  ///< counted from the first exported one
  double radius = 0.0;         ///< of any of its nodes about the origin, cm
  Vec3 origin = Vec3::Zero();  ///< mean of its first nodes where they are in the first exported frame, cm
  std::vector<Pose> poses;     ///< one a frame from `firstFrame`: where it takes what was about the origin
  FitResidual residual;
};

/// Follows all fragments from frame to frame.
class FragmentFollower {
 public:
  /// Of the first exported frame, which is kept.
  explicit FragmentFollower(sim::SnapshotPointer first);

  /// The next frame, beginning with the first.
  void follow(const sim::Snapshot& frame);
  bool has(sim::FragmentId id) const { return followed_.contains(id); }
  /// Where a fragment that has been followed is about, in the first frame, cm.
  const Vec3& originOf(sim::FragmentId id) const { return followed_.at(id).rigid.origin(); }
  /// That it has in the last frame followed, ascending.
  const std::vector<sim::NodeIndex>& nodesOf(sim::FragmentId id) const { return followed_.at(id).nodes; }

  /// By id.
  std::vector<FragmentMotion> motions() const;

 private:
  struct Followed {
    sim::Fragment fragment;
    sim::NodeIndex node;
    std::size_t firstFrame;
    double radius;
    std::vector<sim::NodeIndex> nodes;  ///< that it has now
    RigidMotion rigid;
  };
  void regroup(const sim::Broken& broken);

  sim::SnapshotPointer first_;
  std::size_t frames_ = 0;
  std::uint64_t version_ = 0;  ///< of what was broken when they were told apart
  std::map<sim::FragmentId, Followed> followed_;
};

/// The times of the exported frames, s from the first: as whole frames where none is off by half of one,
/// since a frame is recorded at the first step behind its time.
std::vector<double> frameTimes(const sim::TakeReader& take, const ExportRequest& request);

}  // namespace modeling
