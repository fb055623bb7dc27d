#include "sim/contact/shared_motion.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "sim/base/parallel.h"

namespace sim {
namespace {

/// Any map will do, the nearest is but the best: about so many nodes are enough to find one.
constexpr std::size_t kSamples = 4096;
/// Where nodes are in one plane, across it the map is what this share of their extent makes of it: nothing.
constexpr double kNoExtent = 1e-6;
constexpr std::size_t kNodesPerTask = 4096;

/// The two largest of what was seen, and the largest of something else.
struct Extremes {
  double first = 0.0;
  double second = 0.0;
  double moved = 0.0;

  void add(double apart, double way) {
    second = std::max(second, std::min(first, apart));
    first = std::max(first, apart);
    moved = std::max(moved, way);
  }
  void merge(const Extremes& other) {
    second = std::max({second, std::min(first, other.first), other.second});
    first = std::max(first, other.first);
    moved = std::max(moved, other.moved);
  }
};

}  // namespace

SharedMotion::SharedMotion(const NodeVectors& from, const NodeVectors& to) {
  fit(from, to);
  measure(from, to);
}

void SharedMotion::fit(const NodeVectors& from, const NodeVectors& to) {
  const std::size_t stride = 1 + from.size() / kSamples;
  double count = 0.0;
  for (std::size_t node = 0; node < from.size(); node += stride, count += 1.0) {
    centre_ += from.get(node);
    shift_ += to.get(node) - from.get(node);
  }
  centre_ /= count;
  shift_ /= count;
  // Sums of outer products, column by column: those of a matrix would wait for memory at every node.
  Vec3 extents[3] = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  Vec3 products[3] = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  for (std::size_t node = 0; node < from.size(); node += stride) {
    const Vec3 start = from.get(node);
    const Vec3 arm = start - centre_;
    const Vec3 way = to.get(node) - start - shift_;
    for (int column = 0; column < 3; ++column) {
      extents[column] += arm[column] * arm;
      products[column] += arm[column] * way;
    }
  }
  Eigen::Matrix3d extent;
  Eigen::Matrix3d product;
  extent << extents[0], extents[1], extents[2];
  product << products[0], products[1], products[2];
  const double size = extent.trace();
  if (!(size > 0.0) || !std::isfinite(product.norm())) return;
  stretch_ = product * (extent + kNoExtent * size * Eigen::Matrix3d::Identity()).inverse();
  const Eigen::Matrix3d map = Eigen::Matrix3d::Identity() + stretch_;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(map.transpose() * map, Eigen::EigenvaluesOnly);
  shrinking_ = std::sqrt(std::clamp(axes.eigenvalues()[0], 0.0, 1.0));
}

void SharedMotion::measure(const NodeVectors& from, const NodeVectors& to) {
  const std::size_t tasks = (from.size() + kNodesPerTask - 1) / kNodesPerTask;
  std::vector<Extremes> found(tasks);
  parallelFor(tasks, [&](std::size_t task) {
    const std::size_t end = std::min(from.size(), (task + 1) * kNodesPerTask);
    for (std::size_t node = task * kNodesPerTask; node < end; ++node) {
      const Vec3 start = from.get(node);
      const Vec3 way = to.get(node) - start;
      const Vec3 apart = way - shift_ - stretch_ * (start - centre_);
      found[task].add(apart.squaredNorm(), way.squaredNorm());
    }
  });
  Extremes all;
  for (const Extremes& one : found) all.merge(one);
  largestPair_ = std::sqrt(all.first) + std::sqrt(all.second);
  furthest_ = std::sqrt(all.moved);
}

}  // namespace sim
