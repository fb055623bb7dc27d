#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "sim/base/bytes.h"
#include "sim/contact/contact_model.h"
#include "sim/fracture/components.h"
#include "sim/state/motion.h"

namespace sim {

/// A node and all that may push it.
struct ContactRow {
  NodeIndex node = kNone;
  std::uint32_t firstEntry = 0, lastEntry = 0;        ///< of ContactRows::entries
  std::uint32_t firstCollider = 0, lastCollider = 0;  ///< of ContactRows::nearColliders
  float reach = 0.0F;                                 ///< cm: no natural length in the row is longer
};

/// A bond that broke and still repels by itself.
struct BrokenPair {
  BondIndex bond = kNone;
  NodeIndex a = kNone;
  NodeIndex b = kNone;
  double restLength = 0.0;  ///< cm
};

/// Two nodes that may push each other, i before j.
struct ContactCandidate {
  NodeIndex i, j;
  ContactEntry entry;  ///< as seen from i
};

/// A node that a collider may push.
struct NodeAtCollider {
  NodeIndex node;
  std::uint32_t collider;
};

/// What the stable step must know of contacts (docs/numerics.md, "Methods").
struct Stiffest {
  double rateSquared = 0.0;  ///< 1/s^2: largest over nodes of the sum of (2 k_pair + k_collider) / m
  double damping = 0.0;      ///< 1/s: the same of 2 d / m

  void raise(const Stiffest& other) {
    rateSquared = std::max(rateSquared, other.rateSquared);
    damping = std::max(damping, other.damping);
  }
  bool covers(const Stiffest& other) const {
    return other.rateSquared <= rateSquared && other.damping <= damping;
  }
};

/// Where friction holds a node at a collider.
struct ColliderHold {
  Vec3 anchor = Vec3::Zero();     ///< in the collider's coordinates, cm
  double stretch = 0.0;           ///< cm, along the surface, when it was last looked at
  std::uint32_t nearest = kNone;  ///< as in Intrusion
  std::uint32_t held = 0;         ///< 1: it is
};

struct ColliderHolds {
  std::vector<ColliderHold> byCollider;  ///< as ContactRows::nearColliders
  std::vector<std::uint32_t> rows;       ///< those with a node that is held, ascending
};

/// All that may push nodes until something has moved by a skin's width, one row a touched node. Pairs stand
/// in it both ways round: each node gathers its own force in a fixed order.
struct ContactRows {
  std::vector<ContactRow> rows;  ///< by node
  std::vector<ContactEntry> entries;
  std::vector<std::uint32_t> nearColliders;  ///< indices of colliders
  ColliderHolds holds;                       ///< of friction, at those
  std::vector<BrokenPair> broken;            ///< by bond: in rows where the two are near
  std::vector<BrokenPair> fresh;             ///< broken since the rows were filled, in order of breaking

  // What follows from the above.
  std::vector<std::uint32_t> rowOfNode;  ///< kNone where a node has none; empty where there are no rows
  std::vector<PairConstants> constants;  ///< by entry: square roots are not for every step
  std::vector<Stiffest> mostOfRow;       ///< by row: if all its pairs touched, not yet over the node's mass
  struct Growing {
    std::uint32_t row, entry;
  };
  std::vector<Growing> growing;  ///< entries whose rho is not yet their natural length
  double longest = 0.0;          ///< cm: no natural or rest length is longer

  /// No row can push.
  bool quiet() const { return rows.empty() && fresh.empty(); }
  std::size_t pairCount() const { return entries.size() / 2 + fresh.size(); }
  /// The bond repels by itself, as found when the rows were filled.
  bool isBrokenPair(BondIndex bond) const;
  /// The contact of two nodes in these rows, or null.
  const ContactEntry* contactOf(NodeIndex i, NodeIndex j) const;

  /// A bond that broke at this rest length (cm) goes on repelling.
  void addBroken(const Network& network, BondIndex bond, double restLength);
  /// Contact takes over from broken bonds whose ends are in different fragments and apart, so that no energy
  /// is lost on the way. Gives the pairs of the others that are near.
  std::vector<ContactCandidate> settleBroken(const ContactModel& model, const Motion& motion,
                                             const Components& components);
  /// Makes the rows anew. `near` is sorted by node.
  void fill(const ContactModel& model, std::span<const ContactCandidate> pairs,
            std::span<const NodeAtCollider> near);
  /// Lets rho grow where pairs are apart. Once a step; forces of the same moment do not depend on it.
  void growApart(const ContactModel& model, const Motion& motion);
  /// Keeps the pairs that another's rows of the same network remember, without its colliders.
  void takeOver(const ContactModel& model, const ContactRows& other);

  void save(ByteWriter& writer) const;
  /// False where the bytes cannot have come from save() of such a network among so many colliders.
  bool load(const ContactModel& model, ByteReader& reader, std::size_t colliderCount);
  std::size_t memoryBytes() const;

 private:
  struct HeldNode {
    NodeIndex node;
    std::uint32_t collider;
    ColliderHold hold;
  };
  std::vector<HeldNode> heldNodes() const;
  void holdAgain(std::span<const HeldNode> held);
  std::vector<std::uint32_t> fillEntries(std::size_t nodeCount, std::span<const ContactCandidate> pairs);
  bool isProper(const Network& network, std::size_t colliderCount) const;
  void deduce(const ContactModel& model);
};

}  // namespace sim
