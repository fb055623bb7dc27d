#include "modeling/exchange/fragment_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/base/parallel.h"

namespace modeling {

FragmentFollower::FragmentFollower(sim::SnapshotPointer first) : first_(std::move(first)) {}

void FragmentFollower::follow(const sim::Snapshot& frame) {
  if (frames_ == 0 || frame.broken->version != version_) regroup(*frame.broken);
  version_ = frame.broken->version;
  std::vector<Followed*> present;
  for (auto& [id, followed] : followed_) {
    if (!followed.nodes.empty()) present.push_back(&followed);
  }
  sim::parallelFor(present.size(),
                   [&](std::size_t i) { present[i]->rigid.follow(present[i]->nodes, frame.positions); });
  ++frames_;
}

void FragmentFollower::regroup(const sim::Broken& broken) {
  std::map<sim::FragmentId, std::vector<sim::NodeIndex>> nodes;
  for (const sim::Fragment& fragment : broken.fragments) nodes[fragment.id];
  for (sim::NodeIndex node = 0; node < broken.fragmentOfNode.size(); ++node) {
    const auto found = nodes.find(broken.fragmentOfNode[node]);
    if (found != nodes.end()) found->second.push_back(node);
  }
  for (auto& [id, followed] : followed_) {
    if (!nodes.contains(id)) followed.nodes.clear();
  }
  for (const sim::Fragment& fragment : broken.fragments) {
    std::vector<sim::NodeIndex>& own = nodes[fragment.id];
    if (own.empty()) continue;
    const auto known = followed_.find(fragment.id);
    if (known != followed_.end()) {
      known->second.fragment = fragment;
      known->second.nodes = std::move(own);
      continue;
    }
    const Vec3 origin = meanOf(own, first_->positions);
    double radius = 0.0;
    for (const sim::NodeIndex node : own)
      radius = std::max(radius, (first_->positions[node] - origin).norm());
    // Until now it moved with what it came off.
    const auto parent = followed_.find(fragment.parent);
    const Eigen::Quaterniond before =
        parent == followed_.end() ? Eigen::Quaterniond::Identity() : parent->second.rigid.rotation();
    const sim::NodeIndex node = own.front();
    followed_.emplace(fragment.id, Followed{fragment, node, frames_, radius, std::move(own),
                                            RigidMotion(first_->positions, origin, before)});
  }
}

std::vector<FragmentMotion> FragmentFollower::motions() const {
  std::vector<FragmentMotion> motions;
  for (const auto& [id, followed] : followed_) {
    motions.push_back({.fragment = followed.fragment,
                       .node = followed.node,
                       .firstFrame = followed.firstFrame,
                       .radius = followed.radius,
                       .origin = followed.rigid.origin(),
                       .poses = followed.rigid.poses(),
                       .residual = followed.rigid.residual()});
  }
  return motions;
}

std::vector<double> frameTimes(const sim::TakeReader& take, const ExportRequest& request) {
  const double rate = take.header().framesPerSecond;
  const double start = take.frameTime(request.firstFrame);
  std::vector<double> exact, whole;
  bool regular = true;
  for (std::size_t frame = request.firstFrame; frame <= request.lastFrame; ++frame) {
    exact.push_back(take.frameTime(frame) - start);
    whole.push_back(static_cast<double>(frame - request.firstFrame) / rate);
    regular = regular && std::abs(exact.back() - whole.back()) < 0.5 / rate;
  }
  return regular ? whole : exact;
}

}  // namespace modeling
