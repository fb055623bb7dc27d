#pragma once

#include <memory>
#include <vector>

#include "sim/base/types.h"

namespace sim {

/// Where the energy is, erg: the parts of the sum that docs/numerics.md, Energy 1, states.
struct Energy {
  double kinetic = 0.0;
  double elastic = 0.0;      ///< in intact bonds
  double gravity = 0.0;      ///< of position, zero at the start
  double contact = 0.0;      ///< in node contacts, colliders and broken bonds in compression
  double dissipated = 0.0;   ///< by damping, friction and plastic flow, since the start
  double released = 0.0;     ///< dropped when bonds broke in tension, since the start
  double outsideWork = 0.0;  ///< done by tracks, moving colliders and held nodes that move
  double residual = 0.0;

  double mechanical() const { return kinetic + elastic + gravity + contact; }
};

struct LedgerRow {
  double time = 0.0;
  Energy energy;
  Vec3 linearMomentum = Vec3::Zero();   ///< g cm/s, of all nodes of finite mass
  Vec3 angularMomentum = Vec3::Zero();  ///< g cm^2/s, about the origin
  double step = 0.0;                    ///< s
};

/// A bond breaking, for the crack timeline.
struct BreakEvent {
  double time = 0.0;
  BondIndex bond = kNone;
  NodeIndex a = kNone;
  NodeIndex b = kNone;
  float strain = 0.0F;     ///< stretch / rest length - 1 when it broke
  CellIndex cell = kNone;  ///< the broken cell that took it along; kNone: its own threshold was passed
};

enum class FragmentState : std::uint8_t {
  deforming,  ///< its bonds pull: the lattice is computed
  rigid,      ///< flies freely as it is
  asleep,     ///< stays where it is until something wakes it
};
inline constexpr std::size_t kFragmentStates = 3;

/// A connected component, and where it comes from.
struct Fragment {
  FragmentId id = kNone;
  FragmentId parent = kNone;  ///< kNone for the components at the start
  double born = 0.0;          ///< s
  std::uint32_t nodeCount = 0;
  double mass = 0.0;  ///< g
};

/// Where a fragment is and how it moves.
struct MovingFragment {
  FragmentId id = kNone;
  Vec3 centre = Vec3::Zero();    ///< of mass, cm
  Vec3 velocity = Vec3::Zero();  ///< of the centre, cm/s
  Vec3 boxMin = Vec3::Zero();    ///< cm
  Vec3 boxMax = Vec3::Zero();    ///< cm
  FragmentState state = FragmentState::deforming;
};

/// What is broken, and which fragments that leaves. It changes only when something breaks, so all snapshots
/// between two breaks share one. Made by sealed(), and immutable from then on.
struct Broken {
  std::vector<std::uint8_t> bonds;         ///< one byte a bond, 1 where it is broken; empty: none is
  std::vector<std::uint8_t> cells;         ///< one byte a cell, 1 where it is broken; empty: none is
  std::vector<FragmentId> fragmentOfNode;  ///< one a node
  std::vector<Fragment> fragments;         ///< living ones, by id
  /// A hash of the arrays: two of equal version are equal. It does not matter whether they come from a
  /// running simulation, from a take or from a run that was resumed.
  std::uint64_t version = 0;

  bool hasLostBond(BondIndex bond) const { return !bonds.empty() && bonds[bond] != 0; }
  bool hasLostCell(CellIndex cell) const { return !cells.empty() && cells[cell] != 0; }
  std::size_t lostBonds() const;
  std::size_t lostCells() const;
};
using BrokenPointer = std::shared_ptr<const Broken>;

/// Sets the version. Flags other than 0 become 1.
BrokenPointer sealed(Broken broken);
/// Without any array; always the same one.
const BrokenPointer& nothingBroken();

/// One moment of a simulation, immutable once made; all that drawing, recording and export need.
struct Snapshot {
  double time = 0.0;  ///< s
  std::uint64_t stepCount = 0;
  std::vector<Vec3> positions;             ///< cm
  std::vector<Vec3> velocities;            ///< cm/s
  BrokenPointer broken = nothingBroken();  ///< never null
  std::vector<MovingFragment> fragments;   ///< those of `broken`, in the same order
  LedgerRow ledger;
};
using SnapshotPointer = std::shared_ptr<const Snapshot>;

}  // namespace sim
