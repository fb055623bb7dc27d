#pragma once

#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "sim/base/bytes.h"
#include "sim/collider/moving_collider.h"
#include "sim/contact/fragment_boxes.h"
#include "sim/contact/hash_grid.h"
#include "sim/fracture/breakage.h"
#include "sim/fracture/components.h"
#include "sim/state/settings.h"
#include "sim/state/tangent.h"

namespace sim {

/// What pushes on nodes from outside the lattice: nodes of other fragments, broken bonds in compression,
/// colliders.
///
/// Contact of two nodes (P9, docs/numerics.md): force max(0, k (rho - x) - d v_n) along the line between
/// them, rho at most the natural length; a pair that becomes eligible closer than that starts with rho its
/// present distance, and rho grows only while the two are apart, so that switching a contact on never adds
/// energy. A pair whose bond broke repels by that bond's own k and l (P4); contact takes over at a rebuild
/// that finds it in different fragments and apart, so that no energy is lost on the way either. Friction
/// (P10) opposes sliding by friction * k * intrusion, and never reverses it within a step.
///
/// Pairs stand in rows, one row a touched node, both ways round: each node gathers its own force in a fixed
/// order. The rows cover all that can touch until something has moved by a skin's width; then stale() asks
/// for rebuild(). A row found clear of everything is not looked at again until nodes and colliders have
/// travelled its clearance.
class Contacts {
 public:
  /// `boxesFirst`: nodes are compared only where boxes of fragments and colliders are near each other, which
  /// finds the same.
  Contacts(const Network& network, const ContactSettings& settings, bool boxesFirst = true);

  /// Everything forces depend on at one moment.
  struct Moment {
    const Motion& motion;
    std::span<const MovingCollider> colliders;
    std::span<const MaterialNow> materials;
    double kick = 0.0;  ///< s: how long the forces act, for the clamp of friction and the colliders' work
    /// cm: no node is further than this from where it was at the last age(). Unknown for trial states: then
    /// every row is looked at.
    double lead = std::numeric_limits<double>::infinity();
    /// Bit a lane, one number a block: the node is moved by forces. Empty: all are. Others stand like walls,
    /// and forces on them are not found.
    std::span<const std::uint16_t> awake = {};
    std::uint64_t awakeVersion = 0;  ///< another number whenever `awake` says otherwise than before
    bool scaled = true;              ///< some material's stiffness may be other than the network says
  };

  /// A bond broke at this rest length: it goes on repelling.
  void addBroken(BondIndex bond, double restLength);
  /// Fragments were born: new pairs may touch. A burst of breaks shares one rebuild a few steps later.
  void noteBirths();
  /// No collider moved further than this since the rows were last asked whether they are stale, cm.
  void moveColliders(double travel);
  /// Other colliders push than before: rows are stale.
  void changeColliders() { stale_ = true; }
  /// Ages the rows by one step in which no node moved further than `travel` (cm).
  void age(const Motion& motion, double travel);
  bool stale() const { return stale_; }
  /// Remembers the pairs that contacts of the same network remember, under other settings or among other
  /// colliders. Rows are stale.
  void takeOver(const Contacts& other);
  /// `travel`: no node goes further in a step, as far as is known, cm.
  void rebuild(const Motion& motion, const Components& components, const Breakage& breakage,
               std::span<const MovingCollider> colliders, double travel = 0.0);

  /// No row can push: nothing to do this step.
  bool quiet() const { return rows_.empty() && fresh_.empty(); }

  /// Calls visit(i, j), i < j, for each two nodes that may push each other before the next rebuild.
  template <class Visit>
  void forEachNearPair(Visit&& visit) const {
    for (const Row& row : rows_) {
      for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
        if (row.node < entries_[e].other) visit(row.node, entries_[e].other);
      }
    }
    for (const BrokenPair& pair : fresh_) visit(pair.a, pair.b);
  }
  /// Calls visit(node, collider) for each node that may be pushed by a collider before the next rebuild.
  template <class Visit>
  void forEachNearCollider(Visit&& visit) const {
    for (const Row& row : rows_) {
      for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) visit(row.node, nearColliders_[c]);
    }
  }
  /// The next age() by such a travel (cm) may look at all positions.
  bool looksAfter(double travel) const {
    return stepsToRebuild_ > 0 || stale_ || slack_ - travel <= nextTravel(travel);
  }

  /// What was found of a row when it was last looked at.
  struct RowLook {
    double clearUntil = 0.0;     ///< cm of the odometer: till then nothing in the row can push
    double room = 0.0;           ///< cm that the node may yet go into the colliders, of a row that may push
    std::uint32_t touching = 0;  ///< entries that push
    std::uint32_t active = 0;    ///< contacts that push, among which friction shares the node's mass
  };
  /// What colliders that move did in a step, which the nodes' own account (force times velocity) cannot tell.
  struct ColliderWork {
    double outside = 0.0;     ///< erg, done on the network
    double dissipated = 0.0;  ///< erg, to be added to the nodes' account
  };
  /// The forces of one moment, zero where no block is touched, and what finding them left behind. Begins as
  /// `touched` alone, all zero; the vectors are made when first needed. To be used with one Contacts only, or
  /// be emptied by forgetRows() between two.
  struct Forces {
    NodeVectors total;  ///< dyn
    NodeVectors lossy;  ///< the part that is not conservative: contact damping and friction, dyn
    std::vector<std::uint8_t> touched;  ///< one byte a block of nodes

    std::uint64_t looksOfRebuild = 0;     ///< whose rows the looks are about
    std::vector<RowLook> looks;           ///< by row
    std::vector<Intrusion> inside;        ///< by collider of a row: when the row was last looked at
    std::uint64_t watchedVersion = 0;     ///< of Moment::awake
    std::vector<std::uint32_t> watched;   ///< rows of nodes that are awake
    std::vector<std::uint32_t> touching;  ///< entries, at the places of their row
    std::vector<std::uint32_t> busy;      ///< rows that may push
    std::vector<ColliderWork> work;       ///< by busy row
    void forgetRows() {
      looks.clear();
      inside.clear();
      watched.clear();
    }
  };
  /// Sets the forces of this moment, which need not be the one that age() was told of. Call only where
  /// !quiet(), else clear().
  ColliderWork computeForces(const Moment& moment, Forces& forces) const;
  static void clear(Forces& forces);

  /// A node near colliders.
  struct NearCollider {
    NodeIndex node = kNone;
    std::span<const std::uint32_t> colliders;
    std::span<const Intrusion> inside;  ///< each of them, there or nearby
  };
  /// In order, nodes moved by forces that within `steps` steps of `step` seconds each may go deeper into a
  /// collider than deepest(), going on as they do. `forces` are those of the moment.
  std::vector<NearCollider> nearLimits(const Moment& moment, const Forces& forces, double step,
                                       double steps) const;
  /// Lets rho grow where pairs are apart. Once a step; forces of the same moment do not depend on it.
  void settle(const Motion& motion);

  /// Adds what pushes now, for implicit methods; `forces` are those of this moment.
  void addTangents(const Moment& moment, const Forces& forces, std::vector<Tangent>& tangents) const;

  /// Energy in compressed contacts, colliders and broken bonds, erg.
  double energy(const Moment& moment) const;

  /// What the stable step must know (docs/numerics.md).
  struct Stiffest {
    double rateSquared = 0.0;  ///< largest over nodes of the sum of (2 k_pair + k_collider) / m, 1/s^2
    double damping = 0.0;      ///< likewise of 2 d / m, 1/s

    void raise(const Stiffest& other) {
      rateSquared = std::max(rateSquared, other.rateSquared);
      damping = std::max(damping, other.damping);
    }
    bool covers(const Stiffest& other) const {
      return other.rateSquared <= rateSquared && other.damping <= damping;
    }
  };
  /// `forces` are of this step or the one before, or have been forgotten: what was found clear then need not
  /// be looked at.
  Stiffest stiffest(const Moment& moment, const Forces& forces) const;
  /// The step was chosen by what stiffest() says of this moment; that holds until so much has moved that
  /// pairs not counted in it may touch.
  void noteChoice() { odometerAtChoice_ = odometer_; }
  bool choiceIsOld() const;
  /// How far a node may go in a step, cm: further, and it could leap over what it should have touched.
  double longestTravel() const;

  std::size_t pairCount() const { return entries_.size() / 2 + fresh_.size(); }
  std::uint64_t rebuilds() const { return rebuilds_; }
  /// Rebuilds in which nodes were compared with each other.
  std::uint64_t searches() const { return searches_; }

  void save(ByteWriter& writer) const;
  bool load(ByteReader& reader, std::span<const MovingCollider> colliders);
  std::size_t memoryBytes() const;

 private:
  /// One direction of a pair. Its other constants follow from the two nodes, or from the broken bond.
  struct Entry {
    double rho = 0.0;  ///< cm: present natural length; rest length of a broken bond
    NodeIndex other = kNone;
    BondIndex brokenBond = kNone;  ///< kNone for a contact
  };
  struct Row {
    NodeIndex node = kNone;
    std::uint32_t firstEntry = 0, lastEntry = 0;
    std::uint32_t firstCollider = 0, lastCollider = 0;  ///< of nearColliders_
    float reach = 0.0F;                                 ///< cm: no natural length in the row is longer
  };
  /// A bond that broke and still repels by itself.
  struct BrokenPair {
    BondIndex bond = kNone;
    NodeIndex a = kNone;
    NodeIndex b = kNone;
    double restLength = 0.0;
  };
  struct Candidate {
    NodeIndex i, j;
    Entry entry;
  };
  struct NodeAtCollider {
    NodeIndex node;
    std::uint32_t collider;
  };
  struct Push {
    Vec3 total = Vec3::Zero();
    Vec3 lossy = Vec3::Zero();
  };

  // Rebuilding (contact_rows.cpp).
  double naturalLength(NodeIndex i, NodeIndex j) const;
  bool mayTouch(NodeIndex i, NodeIndex j, const Components& components, const Breakage& breakage) const;
  const Entry* oldEntry(NodeIndex i, NodeIndex j) const;
  BrokenPair brokenPair(BondIndex bond, double restLength) const;
  void collectBroken(const Motion& motion, const Components& components, std::vector<Candidate>& pairs);
  std::vector<NodeIndex> nodesToCompare(const Motion& motion, const Components& components,
                                        const FragmentBoxes& boxes) const;
  void collectContacts(const Motion& motion, std::span<const NodeIndex> nodes, const Components& components,
                       const Breakage& breakage, std::vector<Candidate>& pairs);
  std::vector<std::uint8_t> fragmentsNear(const Collider& collider, double skin, const FragmentBoxes& boxes,
                                          std::size_t fragmentCount);
  std::vector<NodeAtCollider> collectColliders(const Motion& motion, const Components& components,
                                               const FragmentBoxes& boxes,
                                               std::span<const MovingCollider> colliders, double travel);
  void fillEntries(const std::vector<Candidate>& pairs, std::vector<std::uint32_t>& firstEntry);
  void fillRows(const std::vector<Candidate>& pairs, const std::vector<NodeAtCollider>& near);
  const BrokenPair* findBroken(BondIndex bond) const;
  void deduce();
  static void savePairs(ByteWriter& writer, const std::vector<BrokenPair>& pairs);
  void loadPairs(ByteReader& reader, std::vector<BrokenPair>& pairs) const;

  // Forces (contact_forces.cpp).
  struct PairConstants {
    double stiffness = 0.0;  ///< dyn/cm
    double damping = 0.0;    ///< g/s
  };
  /// Where no track scales anything.
  PairConstants constantsOf(NodeIndex node, const Entry& entry) const;
  PairConstants scaled(const PairConstants& constants, NodeIndex node, const Entry& entry,
                       const Moment& moment) const;
  static bool isAwake(NodeIndex node, const Moment& moment) {
    return moment.awake.empty() ||
           ((static_cast<unsigned>(moment.awake[node / kBlockNodes]) >> (node % kBlockNodes)) & 1U) != 0;
  }
  double massShare(NodeIndex node, std::span<const RowLook> looks) const;
  void prepare(const Moment& moment, Forces& forces) const;
  void look(std::uint32_t row, const Moment& moment, Forces& forces) const;
  Push pairPush(NodeIndex node, const Entry& entry, const PairConstants& unscaled, const Moment& moment,
                std::span<const RowLook> looks) const;
  Push colliderPush(NodeIndex node, const MovingCollider& collider, const Intrusion& inside,
                    const Moment& moment, std::span<const RowLook> looks, ColliderWork& work) const;
  ColliderWork pushRow(std::uint32_t row, const Moment& moment, Forces& forces) const;
  void addPairTangent(NodeIndex node, const Entry& entry, const Moment& moment,
                      std::span<const RowLook> looks, std::vector<Tangent>& tangents) const;
  void addColliderTangent(NodeIndex node, const MovingCollider& collider, const Moment& moment,
                          std::span<const RowLook> looks, std::vector<Tangent>& tangents) const;
  void pushFresh(const Moment& moment, Forces& forces) const;
  void raiseByRow(std::uint32_t row, const Moment& moment, Stiffest& most) const;
  double colliderStiffness(NodeIndex node, const Collider& collider,
                           std::span<const MaterialNow> materials) const;

  /// Pairs further apart than this share of the largest natural length beyond their own do not count in the
  /// stable step, which is chosen again before they can have met.
  static constexpr double kChoiceShare = 0.1;

  /// cm: where colliders have another side, rows are built again before the next step may lead through one
  /// that is in none.
  double nextTravel(double travel) const { return collidersEnd_ ? travel : 0.0; }

  const Network* network_;
  ContactSettings settings_;
  bool boxesFirst_;
  std::vector<float>
      nodeStiffness_;  ///< the weakest bond of each node: contact is never stiffer (P16), dyn/cm
  double largestNatural_ = 0.0;
  double pairSkin_ = 0.0;      ///< cm beyond the natural length that the rows cover
  double colliderSkin_ = 0.0;  ///< cm outside colliders that the rows cover

  HashGrid grid_;
  std::vector<Row> rows_;  ///< by node
  std::vector<Entry> entries_;
  std::vector<PairConstants> constants_;  ///< by entry: square roots are not for every step
  std::vector<Stiffest> mostOfRow_;       ///< by row: if all its pairs touched, not yet over the node's mass
  std::vector<std::uint32_t> nearColliders_;
  std::vector<std::uint32_t> rowOfNode_;  ///< kNone where a node has none
  struct Growing {
    std::uint32_t row, entry;
  };
  std::vector<Growing> growing_;    ///< entries whose rho is not yet their natural length
  std::vector<BrokenPair> broken_;  ///< by bond
  std::vector<BrokenPair> fresh_;   ///< broken since the last rebuild, in order of breaking
  NodeVectors reference_;           ///< positions at the last rebuild
  bool pairsMayMeet_ =
      false;  ///< there are fragments, broken bonds or self contact to keep rows of pairs for
  bool hasColliders_ = false;
  bool collidersEnd_ = false;  ///< some collider has another side to come out on
  bool stale_ = true;
  double odometer_ = 0.0;  ///< cm that nodes and colliders have travelled at most since the rows were built
  double odometerAtChoice_ = 0.0;  ///< cm: when the step was chosen
  double slack_ = 0.0;  ///< cm that may yet be travelled before the displacements must be looked at
  double colliderTravel_ = 0.0;
  double colliderClearance_ = 0.0;    ///< cm: no node outside the rows was nearer to a collider
  double longest_ = 0.0;              ///< cm: no natural or rest length is longer
  std::uint32_t stepsToRebuild_ = 0;  ///< counts down after births; 0: no rebuild is due
  std::uint64_t rebuilds_ = 0;
  std::uint64_t searches_ = 0;
};

}  // namespace sim
