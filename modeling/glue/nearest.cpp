#include "modeling/glue/nearest.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace modeling {

using sim::kNone;
using sim::NodeIndex;
using sim::Vec3;

namespace {

constexpr std::uint32_t kLeafSize = 8;

double squaredDistanceToBox(const Vec3& place, const Vec3& low, const Vec3& high) {
  return (place - place.cwiseMax(low).cwiseMin(high)).squaredNorm();
}

}  // namespace

NearestPoints::NearestPoints(const std::vector<Vec3>& points)
    : points_(points), order_(points.size()), leafOf_(points.size()), taken_(points.size(), false) {
  std::iota(order_.begin(), order_.end(), NodeIndex{0});
  if (!points.empty()) grow(0, static_cast<std::uint32_t>(points.size()), kNone);
}

std::uint32_t NearestPoints::grow(std::uint32_t begin, std::uint32_t end, std::uint32_t parent) {
  const auto id = static_cast<std::uint32_t>(branches_.size());
  Branch branch;
  branch.begin = begin;
  branch.end = end;
  branch.parent = parent;
  branch.free = end - begin;
  branch.low = branch.high = points_[order_[begin]];
  for (std::uint32_t i = begin; i < end; ++i) {
    branch.low = branch.low.cwiseMin(points_[order_[i]]);
    branch.high = branch.high.cwiseMax(points_[order_[i]]);
  }
  branches_.push_back(branch);
  if (end - begin <= kLeafSize) {
    for (std::uint32_t i = begin; i < end; ++i) leafOf_[order_[i]] = id;
    return id;
  }
  Eigen::Index axis = 0;
  (branch.high - branch.low).maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(
      order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](NodeIndex p, NodeIndex q) {
        return points_[p][axis] != points_[q][axis] ? points_[p][axis] < points_[q][axis] : p < q;
      });
  const std::uint32_t left = grow(begin, middle, id), right = grow(middle, end, id);
  branches_[id].left = left;
  branches_[id].right = right;
  return id;
}

void NearestPoints::take(NodeIndex point) {
  if (taken_[point]) return;
  taken_[point] = true;
  for (std::uint32_t branch = leafOf_[point]; branch != kNone; branch = branches_[branch].parent)
    --branches_[branch].free;
}

std::optional<NearestPoints::Found> NearestPoints::search(const Vec3& place, double reach,
                                                          bool freeOnly) const {
  if (branches_.empty()) return std::nullopt;
  Found best{kNone, std::isfinite(reach) ? reach * reach : std::numeric_limits<double>::infinity()};
  searchBranch(0, place, freeOnly, best);
  if (best.point == kNone) return std::nullopt;
  best.distance = std::sqrt(best.distance);
  return best;
}

void NearestPoints::searchBranch(std::uint32_t id, const Vec3& place, bool freeOnly, Found& best) const {
  const Branch& branch = branches_[id];
  if (freeOnly && branch.free == 0) return;
  if (squaredDistanceToBox(place, branch.low, branch.high) > best.distance) return;
  if (branch.left == kNone) {
    for (std::uint32_t i = branch.begin; i < branch.end; ++i) {
      const NodeIndex point = order_[i];
      if (freeOnly && taken_[point]) continue;
      const double squared = (points_[point] - place).squaredNorm();
      if (squared < best.distance || (squared == best.distance && point < best.point))
        best = {point, squared};
    }
    return;
  }
  const auto distanceTo = [&](std::uint32_t child) {
    return squaredDistanceToBox(place, branches_[child].low, branches_[child].high);
  };
  const bool leftFirst = distanceTo(branch.left) <= distanceTo(branch.right);
  searchBranch(leftFirst ? branch.left : branch.right, place, freeOnly, best);
  searchBranch(leftFirst ? branch.right : branch.left, place, freeOnly, best);
}

}  // namespace modeling
