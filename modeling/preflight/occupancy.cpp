#include "modeling/preflight/occupancy.h"

#include <algorithm>
#include <cmath>

namespace modeling {

Occupancy::Occupancy(const Eigen::AlignedBox3d& whole, double edge) : whole_(whole) {
  if (whole.isEmpty()) return;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double size = whole.sizes()[axis];
    if (!(size > 0.0) || !(edge > 0.0)) continue;
    const double steps = std::clamp(std::ceil(size / edge), 1.0, 1.0 * kMostAlong);
    count_[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(steps);
    stepsPerCm_[axis] = steps / size;
  }
  taken_.assign(count_[0] * count_[1] * count_[2], false);
}

Occupancy::Steps Occupancy::stepsOf(const sim::Vec3& point) const {
  const sim::Vec3 steps = (point - whole_.min()).cwiseProduct(stepsPerCm_);
  Steps at{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double step = std::max(0.0, steps[static_cast<Eigen::Index>(axis)]);
    at[axis] = std::min(static_cast<std::size_t>(step), count_[axis] - 1);
  }
  return at;
}

void Occupancy::add(const Eigen::AlignedBox3d& box) {
  const Steps low = stepsOf(box.min()), high = stepsOf(box.max());
  for (std::size_t i = low[0]; i <= high[0]; ++i) {
    for (std::size_t j = low[1]; j <= high[1]; ++j) {
      for (std::size_t k = low[2]; k <= high[2]; ++k) taken_[placeOf({i, j, k})] = true;
    }
  }
}

}  // namespace modeling
