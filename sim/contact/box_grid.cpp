#include "sim/contact/box_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {
namespace {

constexpr std::int64_t kMostCubes = 64;  // a side

float below(double value) {
  return std::nextafter(static_cast<float>(value), -std::numeric_limits<float>::infinity());
}

float above(double value) {
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

/// Calls each(first, last) for the places of a run of `count` from `from` on a ring of `side`.
template <class Each>
void forRing(std::int64_t from, std::int64_t count, std::int64_t side, const Each& each) {
  if (count >= side) return each(std::int64_t{0}, side - 1);
  const std::int64_t first = from & (side - 1);
  const std::int64_t last = first + count - 1;
  each(first, std::min(last, side - 1));
  if (last >= side) each(std::int64_t{0}, last - side);
}

}  // namespace

void BoxGrid::add(std::uint32_t index, FragmentId fragment, const Eigen::AlignedBox3d& box) {
  Entry entry;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    entry.low[k] = below(box.min()[axis]);
    entry.high[k] = above(box.max()[axis]);
    const double half = 0.5 * (static_cast<double>(entry.high[k]) - static_cast<double>(entry.low[k]));
    largestHalf_[k] = std::max(largestHalf_[k], half);
  }
  entry.index = index;
  entry.fragment = fragment;
  entries_.push_back(entry);
}

std::int64_t BoxGrid::cubeAt(double coordinate) const {
  return static_cast<std::int64_t>(std::floor(coordinate / edge_));
}

std::size_t BoxGrid::slotOf(const Entry& entry) const {
  std::size_t slot = 0;
  for (std::size_t k = 3; k-- > 0;) {
    const double middle = 0.5 * (static_cast<double>(entry.low[k]) + static_cast<double>(entry.high[k]));
    slot = slot * static_cast<std::size_t>(side_) + static_cast<std::size_t>(cubeAt(middle) & (side_ - 1));
  }
  return slot;
}

void BoxGrid::sort() {
  const auto count = static_cast<std::int64_t>(entries_.size());
  while (side_ < kMostCubes && side_ * side_ * side_ < count) side_ *= 2;
  first_.assign(static_cast<std::size_t>(side_ * side_ * side_) + 1, 0);
  std::vector<std::size_t> slots;
  slots.reserve(entries_.size());
  for (const Entry& entry : entries_) {
    slots.push_back(slotOf(entry));
    ++first_[slots.back() + 1];
  }
  for (std::size_t slot = 1; slot < first_.size(); ++slot) first_[slot] += first_[slot - 1];
  std::vector<Entry> sorted(entries_.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t e = 0; e < entries_.size(); ++e) sorted[next[slots[e]]++] = entries_[e];
  entries_ = std::move(sorted);
  only_.assign(next.size(), kNone);
  for (std::size_t slot = 0; slot < next.size(); ++slot) {
    if (first_[slot] == first_[slot + 1]) continue;
    const FragmentId one = entries_[first_[slot]].fragment;
    const auto isOfIt = [one](const Entry& entry) { return entry.fragment == one; };
    if (std::all_of(entries_.begin() + first_[slot], entries_.begin() + first_[slot + 1], isOfIt))
      only_[slot] = one;
  }
}

void BoxGrid::find(FragmentId fragment, const Eigen::AlignedBox3d& box, std::uint32_t least,
                   std::vector<std::uint32_t>& found) const {
  found.clear();
  std::array<float, 3> low{}, high{};
  std::array<std::int64_t, 3> from{}, count{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    low[k] = below(box.min()[axis]);
    high[k] = above(box.max()[axis]);
    from[k] = cubeAt(static_cast<double>(low[k]) - largestHalf_[k]);
    count[k] = cubeAt(static_cast<double>(high[k]) + largestHalf_[k]) - from[k] + 1;
  }
  const auto look = [&](const Entry& entry) {
    // All at once: which of them fails cannot be foreseen.
    const bool apart = (entry.low[0] > high[0]) | (entry.low[1] > high[1]) | (entry.low[2] > high[2]) |
                       (entry.high[0] < low[0]) | (entry.high[1] < low[1]) | (entry.high[2] < low[2]) |
                       (entry.fragment == fragment);
    if (!apart) found.push_back(entry.index);
  };
  forRing(from[2], count[2], side_, [&](std::int64_t firstZ, std::int64_t lastZ) {
    for (std::int64_t z = firstZ; z <= lastZ; ++z) {
      forRing(from[1], count[1], side_, [&](std::int64_t firstY, std::int64_t lastY) {
        for (std::int64_t y = firstY; y <= lastY; ++y) {
          forRing(from[0], count[0], side_, [&](std::int64_t firstX, std::int64_t lastX) {
            const auto row = static_cast<std::size_t>((z * side_ + y) * side_);
            for (std::size_t slot = row + static_cast<std::size_t>(firstX);
                 slot <= row + static_cast<std::size_t>(lastX); ++slot) {
              if (only_[slot] == fragment) continue;
              for (std::uint32_t e = first_[slot + 1]; e-- > first_[slot] && entries_[e].index >= least;)
                look(entries_[e]);
            }
          });
        }
      });
    }
  });
  std::ranges::sort(found);
}

}  // namespace sim
