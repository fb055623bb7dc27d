#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "sim/network/network.h"

namespace modeling {

/// Points by nearness (a balanced k-d tree), some of which may be taken out of the running.
class NearestPoints {
 public:
  struct Found {
    sim::NodeIndex point = 0;
    double distance = 0.0;
  };

  /// The points must stay where they are as long as this lives.
  explicit NearestPoints(const std::vector<sim::Vec3>& points);

  /// The point nearest to `place` and no farther than `reach`; of points equally near the one of lowest
  /// index.
  std::optional<Found> nearest(const sim::Vec3& place, double reach) const {
    return search(place, reach, false);
  }
  /// Likewise, of those not taken.
  std::optional<Found> nearestFree(const sim::Vec3& place, double reach) const {
    return search(place, reach, true);
  }
  void take(sim::NodeIndex point);
  bool taken(sim::NodeIndex point) const { return taken_[point]; }

 private:
  struct Branch {
    std::uint32_t begin = 0, end = 0;                     ///< in order_
    std::uint32_t left = sim::kNone, right = sim::kNone;  ///< branches; kNone in a leaf
    std::uint32_t parent = sim::kNone;
    std::uint32_t free = 0;  ///< points below that are not taken
    sim::Vec3 low, high;
  };
  std::uint32_t grow(std::uint32_t begin, std::uint32_t end, std::uint32_t parent);
  std::optional<Found> search(const sim::Vec3& place, double reach, bool freeOnly) const;
  void searchBranch(std::uint32_t branch, const sim::Vec3& place, bool freeOnly, Found& best) const;

  const std::vector<sim::Vec3>& points_;
  std::vector<sim::NodeIndex> order_;
  std::vector<Branch> branches_;
  std::vector<std::uint32_t> leafOf_;
  std::vector<bool> taken_;
};

}  // namespace modeling
