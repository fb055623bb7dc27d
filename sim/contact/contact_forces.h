#pragma once

#include <limits>
#include <span>
#include <vector>

#include "sim/contact/contacts.h"
#include "sim/kernel/bond_kernel.h"

/// The forces of contacts, as functions over Contacts (docs/numerics.md, "Contact and friction").
namespace sim {

/// Everything that forces of contacts depend on at one moment.
struct ContactMoment {
  const Motion& motion;
  std::span<const MovingCollider> colliders;
  std::span<const MaterialNow> materials;
  double kick = 0.0;  ///< s: how long the forces act, for the clamp of friction and the colliders' work
  double time = 0.0;  ///< s: for what began inside a collider
  /// cm: no node is further than this from where it was when the rows were last aged. Unknown for trial
  /// states: then every row is looked at.
  double lead = std::numeric_limits<double>::infinity();
  /// Bit a lane, one number a block: the node is moved by forces. Empty: all are. Others stand like walls,
  /// and forces on them are not found.
  std::span<const std::uint16_t> awake = {};
  std::uint64_t awakeVersion = 0;  ///< another number whenever `awake` says otherwise than before
  bool scaled = true;              ///< some material's stiffness may be other than the network says
  /// The forces are those of a whole step, at whose end nothing may be too deep. False: they are rates.
  bool wholeStep = false;

  /// Whether forces move the node.
  bool moves(NodeIndex node) const {
    return awake.empty() ||
           ((static_cast<unsigned>(awake[node / kBlockNodes]) >> (node % kBlockNodes)) & 1U) != 0;
  }
};

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
struct ContactForces {
  explicit ContactForces(std::size_t blockCount) : touched(blockCount, 0) {}

  NodeVectors total;  ///< dyn
  NodeVectors lossy;  ///< the part that is not conservative: contact damping and friction, dyn
  std::vector<std::uint8_t> touched;  ///< one byte a block of nodes

  std::uint64_t looksOfRebuild = 0;     ///< whose rows the looks are about
  std::vector<RowLook> looks;           ///< by row
  std::vector<Intrusion> inside;        ///< by collider of a row: when the row was last looked at
  std::uint64_t watchedVersion = 0;     ///< of ContactMoment::awake
  std::vector<std::uint32_t> watched;   ///< rows of nodes that are awake
  std::vector<std::uint32_t> touching;  ///< entries, at the places of their row
  std::vector<std::uint32_t> busy;      ///< rows that may push
  std::vector<ColliderWork> work;       ///< by busy row

  void forgetRows() {
    looks.clear();
    inside.clear();
    watched.clear();
  }
  /// Sets all forces to zero.
  void clear();
};

/// Sets the forces of this moment, which need not be the one that the rows were last aged for. To be called
/// only where some row may push, else the forces are to be cleared.
ColliderWork findContactForces(const Contacts& contacts, const ContactMoment& moment, ContactForces& forces);

/// A node near colliders.
struct NearCollider {
  NodeIndex node = kNone;
  std::span<const std::uint32_t> colliders;
  std::span<const Intrusion> inside;  ///< each of them, there or nearby
};
/// In order, nodes moved by forces that within `steps` steps of `step` seconds each may go deeper into a
/// collider than deepest(), going on as they do. `forces` are those of the moment.
std::vector<NearCollider> nodesNearLimits(const Contacts& contacts, const ContactMoment& moment,
                                          const ContactForces& forces, double step, double steps);

/// Energy in compressed contacts, colliders and broken bonds, erg.
double contactEnergy(const Contacts& contacts, const ContactMoment& moment);

/// What touches now, or may before the step is chosen again. `forces` are of this step or the one before, or
/// have been forgotten: what was found clear then need not be looked at.
Stiffest stiffestContacts(const Contacts& contacts, const ContactMoment& moment, const ContactForces& forces);

/// The mass of a node that each of its active contacts may stop by friction, g.
double massShare(const Contacts& contacts, NodeIndex node, std::span<const RowLook> looks);
/// The constants of a pair as tracks scale them now.
PairConstants constantsNow(const Contacts& contacts, const PairConstants& unscaled, NodeIndex node,
                           const ContactEntry& entry, const ContactMoment& moment);

}  // namespace sim
