#pragma once

#include <span>
#include <vector>

#include "sim/collider/collider.h"
#include "sim/kernel/bond_kernel.h"
#include "sim/network/network.h"
#include "sim/state/settings.h"

namespace sim {

/// One direction of a pair of nodes that may push each other. Its other constants follow from the two nodes,
/// or from the broken bond.
struct ContactEntry {
  double rho = 0.0;  ///< cm: present natural length; rest length of a broken bond
  NodeIndex other = kNone;
  BondIndex brokenBond = kNone;  ///< kNone for a contact
};

/// The spring and the damper of a pair.
struct PairConstants {
  double stiffness = 0.0;  ///< dyn/cm
  double damping = 0.0;    ///< g/s
};

/// What the constants of contacts follow from: the network and the settings. docs/numerics.md, "Contact and
/// friction".
class ContactModel {
 public:
  /// The network must outlive this.
  ContactModel(const Network& network, const ContactSettings& settings);

  const Network& network() const { return *network_; }
  const ContactSettings& settings() const { return settings_; }
  /// The longest that rho gets for two nodes, cm.
  double naturalLength(NodeIndex i, NodeIndex j) const;
  /// No pair of nodes has a longer one, cm.
  double largestNatural() const { return largestNatural_; }
  /// How far beyond the natural length the rows cover pairs, cm.
  double pairSkin() const { return pairSkin_; }
  /// How far outside colliders the rows cover nodes, cm.
  double colliderSkin() const { return colliderSkin_; }
  /// False where one of the nodes has no bonds, and so no stiffness to push with.
  bool maySpring(NodeIndex i, NodeIndex j) const;

  /// Where no track scales anything.
  PairConstants constantsOf(NodeIndex node, const ContactEntry& entry) const;
  /// Tracks that soften a material soften its contacts too, so that they stay no stiffer than its bonds. A
  /// broken bond keeps to its own material, or its energy would change as it breaks.
  PairConstants scaled(const PairConstants& constants, NodeIndex node, const ContactEntry& entry,
                       std::span<const MaterialNow> materials) const;
  /// dyn/cm, where no track scales anything
  double unscaledStiffness(NodeIndex node, const Collider& collider) const;
  /// dyn/cm
  double colliderStiffness(NodeIndex node, const Collider& collider,
                           std::span<const MaterialNow> materials) const;
  std::size_t memoryBytes() const { return nodeStiffness_.capacity() * sizeof(float); }

 private:
  const Network* network_;
  ContactSettings settings_;
  std::vector<float> nodeStiffness_;  ///< dyn/cm: of each node's weakest bond, since contact is never stiffer
  double largestNatural_ = 0.0;       ///< cm
  double pairSkin_ = 0.0;             ///< cm
  double colliderSkin_ = 0.0;         ///< cm
};

}  // namespace sim
