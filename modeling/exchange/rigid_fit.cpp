#include "modeling/exchange/rigid_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/SVD>

namespace modeling {

namespace {

/// Share of the moments that the pose before weighs: turns what the points leave open, and turns what they
/// determine by less than a billionth of the step between two frames.
constexpr double kMemory = 1e-9;

}  // namespace

Vec3 meanOf(const std::vector<sim::NodeIndex>& nodes, const std::vector<Vec3>& positions) {
  Vec3 sum = Vec3::Zero();
  for (const sim::NodeIndex node : nodes) sum += positions[node];
  return sum / static_cast<double>(nodes.size());
}

Eigen::Quaterniond bestRotation(const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                                const Eigen::Quaterniond& before) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  double size = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    moments += to[i] * from[i].transpose();
    size += to[i].norm() * from[i].norm();
  }
  if (!(size > 0.0)) return before;
  moments += kMemory * size * before.toRotationMatrix();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moments, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d handed = Eigen::Matrix3d::Identity();
  handed(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  Eigen::Quaterniond rotation(Eigen::Matrix3d(svd.matrixU() * handed * svd.matrixV().transpose()));
  rotation.normalize();
  // The same rotation by its other sign would look like a turn by 360 degrees to who interpolates.
  if (rotation.dot(before) < 0.0) rotation.coeffs() = -rotation.coeffs();
  return rotation;
}

std::vector<FinalFragment> finalFragments(const sim::Snapshot& first, const sim::Snapshot& last) {
  std::vector<FinalFragment> result;
  for (std::size_t i = 0; i < last.fragments.size(); ++i) {
    FinalFragment& made = result.emplace_back();
    made.fragment = last.broken->fragments[i];
    made.moving = last.fragments[i];
  }
  std::sort(result.begin(), result.end(), [](const FinalFragment& left, const FinalFragment& right) {
    return left.fragment.id < right.fragment.id;
  });
  for (sim::NodeIndex node = 0; node < last.broken->fragmentOfNode.size(); ++node) {
    const auto found = std::lower_bound(
        result.begin(), result.end(), last.broken->fragmentOfNode[node],
        [](const FinalFragment& fragment, sim::FragmentId id) { return fragment.fragment.id < id; });
    if (found != result.end() && found->fragment.id == last.broken->fragmentOfNode[node])
      found->nodes.push_back(node);
  }
  std::erase_if(result, [](const FinalFragment& fragment) { return fragment.nodes.empty(); });
  for (FinalFragment& fragment : result) {
    fragment.origin = meanOf(fragment.nodes, first.positions);
    for (const sim::NodeIndex node : fragment.nodes)
      fragment.radius = std::max(fragment.radius, (first.positions[node] - fragment.origin).norm());
  }
  return result;
}

double FitResidual::rootMeanSquare() const {
  return count == 0 ? 0.0 : std::sqrt(sumOfSquares / static_cast<double>(count));
}

void FitResidual::add(double distance) {
  sumOfSquares += distance * distance;
  largest = std::max(largest, distance);
  ++count;
}

void FitResidual::add(const FitResidual& other) {
  sumOfSquares += other.sumOfSquares;
  largest = std::max(largest, other.largest);
  count += other.count;
}

RigidMotion::RigidMotion(const std::vector<Vec3>& first, Vec3 origin, Eigen::Quaterniond before)
    : first_(&first), origin_(std::move(origin)), rotation_(std::move(before)) {}

void RigidMotion::follow(const std::vector<sim::NodeIndex>& nodes, const std::vector<Vec3>& now) {
  const Vec3 middle = meanOf(nodes, *first_);
  const Vec3 middleNow = meanOf(nodes, now);
  std::vector<Vec3> from, to;
  from.reserve(nodes.size());
  to.reserve(nodes.size());
  for (const sim::NodeIndex node : nodes) {
    from.push_back((*first_)[node] - middle);
    to.push_back(now[node] - middleNow);
  }
  const auto isStill = [&](sim::NodeIndex node) { return now[node] == (*first_)[node]; };
  if (std::all_of(nodes.begin(), nodes.end(), isStill)) {
    // The first frame itself says nothing.
    for (std::size_t i = 0; i < nodes.size() && !poses_.empty(); ++i) residual_.add(0.0);
    poses_.push_back({origin_, rotation_ = Eigen::Quaterniond::Identity()});
    return;
  }
  rotation_ = bestRotation(from, to, rotation_);
  for (std::size_t i = 0; i < to.size(); ++i) residual_.add((to[i] - rotation_ * from[i]).norm());
  poses_.push_back({middleNow + rotation_ * (origin_ - middle), rotation_});
}

}  // namespace modeling
