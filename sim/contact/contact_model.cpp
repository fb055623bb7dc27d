#include "sim/contact/contact_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {
namespace {

/// Skins relative to the largest radius: wider ones mean fewer rebuilds and more pairs looked at in vain.
constexpr double kPairSkinShare = 0.6;
constexpr double kColliderSkinShare = 1.0;

}  // namespace

ContactModel::ContactModel(const Network& network, const ContactSettings& settings)
    : network_(&network),
      settings_(settings),
      nodeStiffness_(network.nodeCount(), std::numeric_limits<float>::max()) {
  for (NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
      const auto stiffness = static_cast<float>(network.bond(b).stiffness);
      nodeStiffness_[a] = std::min(nodeStiffness_[a], stiffness);
      nodeStiffness_[network.bondEnds[b]] = std::min(nodeStiffness_[network.bondEnds[b]], stiffness);
    }
  }
  float largestRadius = 0.0F;
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    if (nodeStiffness_[node] == std::numeric_limits<float>::max()) nodeStiffness_[node] = 0.0F;
    largestRadius = std::max(largestRadius, network.radii[node]);
  }
  largestNatural_ = static_cast<double>(largestRadius) * (settings.length == ContactLength::sum ? 2.0 : 1.0);
  pairSkin_ = kPairSkinShare * static_cast<double>(largestRadius);
  colliderSkin_ = kColliderSkinShare * static_cast<double>(largestRadius);
}

double ContactModel::naturalLength(NodeIndex i, NodeIndex j) const {
  const double first = network_->radii[i];
  const double second = network_->radii[j];
  return settings_.length == ContactLength::sum ? first + second : std::min(first, second);
}

bool ContactModel::maySpring(NodeIndex i, NodeIndex j) const {
  return std::min(nodeStiffness_[i], nodeStiffness_[j]) > 0.0F;
}

PairConstants ContactModel::constantsOf(NodeIndex node, const ContactEntry& entry) const {
  if (entry.brokenBond != kNone) {
    const BondClass& bond = network_->bond(entry.brokenBond);
    return {bond.stiffness, bond.damping};
  }
  const double stiffness = settings_.stiffnessScale *
                           static_cast<double>(std::min(nodeStiffness_[node], nodeStiffness_[entry.other]));
  const double reduced = 1.0 / (1.0 / network_->masses[node] + 1.0 / network_->masses[entry.other]);
  return {stiffness,
          std::isfinite(reduced) ? 2.0 * settings_.dampingRatio * std::sqrt(stiffness * reduced) : 0.0};
}

PairConstants ContactModel::scaled(const PairConstants& constants, NodeIndex node, const ContactEntry& entry,
                                   std::span<const MaterialNow> materials) const {
  const double scale = entry.brokenBond != kNone
                           ? materials[network_->bond(entry.brokenBond).material].stiffnessScale
                           : std::min(materials[network_->nodeMaterials[node]].stiffnessScale,
                                      materials[network_->nodeMaterials[entry.other]].stiffnessScale);
  return {scale * constants.stiffness, std::sqrt(scale) * constants.damping};
}

double ContactModel::unscaledStiffness(NodeIndex node, const Collider& collider) const {
  return collider.stiffness ? *collider.stiffness
                            : settings_.stiffnessScale * static_cast<double>(nodeStiffness_[node]);
}

double ContactModel::colliderStiffness(NodeIndex node, const Collider& collider,
                                       std::span<const MaterialNow> materials) const {
  const double unscaled = unscaledStiffness(node, collider);
  return collider.stiffness ? unscaled : unscaled * materials[network_->nodeMaterials[node]].stiffnessScale;
}

}  // namespace sim
