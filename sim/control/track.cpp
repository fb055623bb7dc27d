#include "sim/control/track.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace sim {
namespace {

/// Index of the last key at or before `time`; the caller has made sure that there is one.
std::size_t keyBefore(const std::vector<Track::Key>& keys, double time) {
  const auto after = std::upper_bound(keys.begin(), keys.end(), time,
                                      [](double moment, const Track::Key& key) { return moment < key.time; });
  return static_cast<std::size_t>(after - keys.begin()) - 1;
}

}  // namespace

Vec3 Track::valueAt(double time) const {
  assert(!keys.empty());
  if (time < keys.front().time) return keys.front().value;
  const std::size_t before = keyBefore(keys, time);
  if (before + 1 == keys.size() || interpolation == Interpolation::step) return keys[before].value;
  const Key& from = keys[before];
  const Key& to = keys[before + 1];
  double share = (time - from.time) / (to.time - from.time);
  if (interpolation == Interpolation::smooth) share *= share * (3.0 - 2.0 * share);
  return from.value + share * (to.value - from.value);
}

Vec3 Track::slopeAt(double time) const {
  assert(!keys.empty());
  if (interpolation == Interpolation::step || time < keys.front().time) return Vec3::Zero();
  const std::size_t before = keyBefore(keys, time);
  if (before + 1 == keys.size()) return Vec3::Zero();
  const Key& from = keys[before];
  const Key& to = keys[before + 1];
  const double span = to.time - from.time;
  const double share = (time - from.time) / span;
  const double ease = interpolation == Interpolation::smooth ? 6.0 * share * (1.0 - share) : 1.0;
  return ease / span * (to.value - from.value);
}

double Track::constantUntil(double time) const {
  assert(!keys.empty());
  if (time < keys.front().time) return keys.front().time;
  const std::size_t before = keyBefore(keys, time);
  if (before + 1 == keys.size()) return std::numeric_limits<double>::infinity();
  const bool holds = interpolation == Interpolation::step || keys[before].value == keys[before + 1].value;
  return holds ? keys[before + 1].time : time;
}

}  // namespace sim
