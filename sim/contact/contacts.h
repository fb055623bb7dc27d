#pragma once

#include <span>
#include <vector>

#include "sim/base/bytes.h"
#include "sim/contact/hash_grid.h"
#include "sim/dynamics/bond_layout.h"
#include "sim/dynamics/settings.h"
#include "sim/fracture/breakage.h"
#include "sim/fracture/components.h"

namespace sim {

/// A collider as it is at one moment, moved by its tracks.
struct MovingCollider {
  Collider shape;
  Vec3 velocity = Vec3::Zero();         ///< of its origin, cm/s
  Vec3 angularVelocity = Vec3::Zero();  ///< rad/s

  Vec3 velocityAt(const Vec3& point) const { return velocity + angularVelocity.cross(point - shape.position); }
};

/// What pushes on nodes from outside the lattice: nodes of other fragments, broken bonds in compression, colliders.
///
/// Contact of two nodes (P9, docs/numerics.md): force max(0, k (rho - x) - d v_n) along the line between them, rho at most the
/// natural length; a pair that becomes eligible closer than that starts with rho its present distance, and rho grows only
/// while the two are apart, so that switching a contact on never adds energy. A pair whose bond broke repels by that bond's
/// own k and l until it was once apart, then contact takes over if they are in different fragments (P4).
/// Friction (P10) opposes sliding by friction * k * intrusion, and never reverses it within a step.
///
/// Pairs stand in rows, one row a touched node, both ways round: each node gathers its own force in a fixed order.
class Contacts {
 public:
  Contacts(const Network& network, const ContactSettings& settings);

  /// Everything forces depend on at one moment.
  struct Moment {
    const Motion& motion;
    const NodeVectors& velocityNow;
    std::span<const MovingCollider> colliders;
    std::span<const MaterialNow> materials;
    double step;  ///< s, for the clamp of friction
  };

  /// A bond just broke at this length: it goes on repelling.
  void addBroken(BondIndex bond, double restLength);

  /// True when the rows no longer cover all that may touch: something moved too far, or fragments were born.
  bool stale() const { return stale_; }
  /// Tells how far anything can have moved in a step (largest speed times step), and lets list age.
  void noteTravel(const Motion& motion, double travel, double colliderTravel);
  /// Fragments were born: the rows must be rebuilt soon, but a burst of breaks may share one rebuild.
  void noteBirths();

  /// Rebuilds the rows.
  void rebuild(const Motion& motion, const Components& components, std::span<const MovingCollider> colliders);

  /// True when no row can push: nothing to do this step.
  bool quiet() const { return rows_.empty() && fresh_.empty(); }

  /// Forces of all rows on their nodes into `force` (dyn), the lossy part also into `lossy`. Sets touchedBlocks[b] for blocks
  /// of touched nodes (and zeroes those blocks' forces first). Returns work done by moving colliders and energy dissipated
  /// relative to them in this step.
  struct StepWork {
    double outside = 0.0;     ///< erg, done on the network by colliders that move
    double dissipated = 0.0;  ///< erg, correction of the kernel's account for moving colliders
  };
  StepWork addForces(const Moment& moment, NodeVectors& force, NodeVectors& lossy, std::vector<std::uint8_t>& touchedBlocks);

  /// Energy in compressed contacts, colliders and broken bonds, erg.
  double energy(const Motion& motion, std::span<const MovingCollider> colliders, std::span<const MaterialNow> materials) const;

  /// The largest sum over a node's rows of (2 k_pair + k_collider) / m, 1/s^2, for the stable step, and the matching damping.
  struct Stiffest {
    double rateSquared = 0.0;  ///< 1/s^2
    double damping = 0.0;      ///< 1/s
  };
  Stiffest stiffest(std::span<const MovingCollider> colliders, std::span<const MaterialNow> materials) const;

  std::size_t pairCount() const { return entries_.size() / 2 + fresh_.size(); }
  std::uint64_t rebuilds() const { return rebuilds_; }

  void save(ByteWriter& writer) const;
  bool load(ByteReader& reader);
  std::size_t memoryBytes() const;

 private:
  /// One direction of a pair.
  struct Entry {
    NodeIndex other;
    float natural;        ///< cm: rho grows no further
    double rho;           ///< cm: present natural length; rest length for a broken bond
    double stiffness;     ///< dyn/cm
    BondIndex brokenBond; ///< kNone for a contact
    bool apart;           ///< a broken bond that was once longer than its rest length
  };
  struct Row {
    NodeIndex node;
    std::uint32_t first, last;          ///< entries_
    std::uint32_t firstCollider, lastCollider;  ///< nearColliders_
    std::uint32_t active = 0;           ///< entries pushing in this step, which share the node's mass in the clamp of friction
  };
  /// A bond that broke. It is in the rows (or fresh) while near; afterwards its pair is contact's.
  struct BrokenPair {
    BondIndex bond;
    NodeIndex a, b;
    double restLength;
    double stiffness;
    bool apart;
  };
  struct Push {
    Vec3 force = Vec3::Zero();
    Vec3 lossy = Vec3::Zero();
  };

  double contactStiffness(NodeIndex i, NodeIndex j) const;
  double nodeShare(NodeIndex node) const;
  double materialScale(NodeIndex i, NodeIndex j, std::span<const MaterialNow> materials) const;
  bool activate(Row& row, const NodeVectors& positions);
  Push pairPush(NodeIndex node, const Entry& entry, const Moment& moment, double share) const;
  Push colliderPush(NodeIndex node, const MovingCollider& collider, const Moment& moment, double share, StepWork& work) const;
  void pushRow(const Row& row, const Moment& moment, NodeVectors& force, NodeVectors& lossy, StepWork& work) const;
  double colliderStiffness(NodeIndex node, const MovingCollider& collider, std::span<const MaterialNow> materials) const;

  struct Candidate;
  void collectPairs(const Motion& motion, const Components& components, std::vector<Candidate>& pairs);
  void collectBroken(const Motion& motion, const Components& components, std::vector<Candidate>& pairs);
  void collectColliders(const Motion& motion, std::span<const MovingCollider> colliders, std::vector<std::pair<NodeIndex, std::uint32_t>>& near) const;
  void fillRows(std::vector<Candidate>& pairs, std::vector<std::pair<NodeIndex, std::uint32_t>>& near);
  bool contactMayTouch(NodeIndex i, NodeIndex j, const Components& components) const;
  double naturalLength(NodeIndex i, NodeIndex j) const;

  const Network* network_;
  ContactSettings settings_;
  std::vector<float> nodeStiffness_;  ///< the weakest bond of each node: contact is never stiffer (P16), dyn/cm
  double largestNatural_ = 0.0;
  double pairSkin_ = 0.0;
  double colliderSkin_ = 0.0;

  HashGrid grid_;
  std::vector<Row> rows_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> nearColliders_;
  std::vector<std::uint32_t> rowOfNode_;
  std::vector<BrokenPair> broken_;  ///< sorted by bond, but for the fresh ones at the end
  std::vector<std::uint32_t> fresh_;  ///< indices of broken_ that no row holds yet
  NodeVectors reference_;  ///< positions at the last rebuild
  bool stale_ = true;
  double travel_ = 0.0;
  double colliderTravel_ = 0.0;
  int stepsToRebuild_ = -1;
  std::uint64_t rebuilds_ = 0;
};

}  // namespace sim
