#include "sim/network/thresholds.h"

#include <algorithm>
#include <cmath>

#include "sim/base/random.h"

namespace sim {

float variedThreshold(const Material& material, std::uint64_t seed, BondIndex bond) {
  if (!std::isfinite(material.thresholdMean)) return std::numeric_limits<float>::infinity();
  constexpr double kCut = 3.0;
  constexpr double kSmallestShare = 0.05;
  const double deviation = std::clamp(normalAt(seed, bond), -kCut, kCut);
  const double share = std::max(kSmallestShare, 1.0 + material.thresholdSpread * deviation);
  return static_cast<float>(material.thresholdMean * share);
}

}  // namespace sim
