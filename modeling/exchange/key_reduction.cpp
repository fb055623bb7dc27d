#include "modeling/exchange/key_reduction.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace modeling {

namespace {

/// How far frame `at` is off when frames `from` and `to` are keys and it is not, cm.
using Deviation = std::function<double(std::size_t from, std::size_t at, std::size_t to)>;

double shareOf(std::size_t from, std::size_t at, std::size_t to) {
  return from == to ? 0.0 : static_cast<double>(at - from) / static_cast<double>(to - from);
}

/// Keys are added where the deviation is largest, until it is small enough everywhere.
std::vector<std::size_t> reduce(std::size_t count, double tolerance, const Deviation& deviation) {
  std::vector<std::size_t> keys{0};
  bool still = true;
  for (std::size_t at = 1; at < count && still; ++at) still = deviation(0, at, 0) <= tolerance;
  if (still) return keys;
  keys.push_back(count - 1);
  std::vector<std::pair<std::size_t, std::size_t>> spans{{0, count - 1}};
  while (!spans.empty()) {
    const auto [from, to] = spans.back();
    spans.pop_back();
    double largest = tolerance;
    std::size_t worst = from;
    for (std::size_t at = from + 1; at < to; ++at) {
      const double here = deviation(from, at, to);
      if (here > largest) std::tie(largest, worst) = std::pair(here, at);
    }
    if (worst == from) continue;
    keys.push_back(worst);
    spans.emplace_back(from, worst);
    spans.emplace_back(worst, to);
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// Largest distance between where two rotations have a point at the radius: 2 r sin(angle / 2).
double apart(const Eigen::Quaterniond& left, const Eigen::Quaterniond& right, double radius) {
  return 2.0 * radius * (left.conjugate() * right).vec().norm();
}

}  // namespace

std::vector<std::size_t> positionKeys(const std::vector<Pose>& poses, double tolerance) {
  return reduce(poses.size(), tolerance, [&](std::size_t from, std::size_t at, std::size_t to) {
    const double share = shareOf(from, at, to);
    const Vec3 between = (1.0 - share) * poses[from].position + share * poses[to].position;
    return (poses[at].position - between).norm();
  });
}

std::vector<std::size_t> rotationKeys(const std::vector<Pose>& poses, double radius, double tolerance) {
  return reduce(poses.size(), tolerance, [&](std::size_t from, std::size_t at, std::size_t to) {
    const double share = shareOf(from, at, to);
    const Eigen::Quaterniond& start = poses[from].rotation;
    const Eigen::Quaterniond& end = poses[to].rotation;
    Eigen::Quaterniond mixed((1.0 - share) * start.coeffs() + share * end.coeffs());
    mixed.normalize();
    return std::max(apart(poses[at].rotation, start.slerp(share, end), radius),
                    apart(poses[at].rotation, mixed, radius));
  });
}

}  // namespace modeling
