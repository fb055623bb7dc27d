#pragma once

#include <memory>
#include <vector>

#include "sim/base/types.h"

namespace sim {

/// Where the energy is, erg (B3). kinetic + elastic + gravity + contact + dissipated + released - outsideWork
/// - (its value at the start) = residual, the numerical error.
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

/// A bond breaking, for the crack timeline (B15).
struct BreakEvent {
  double time = 0.0;
  BondIndex bond = kNone;
  NodeIndex a = kNone;
  NodeIndex b = kNone;
  float strain = 0.0F;     ///< stretch / rest length - 1 when it broke
  CellIndex cell = kNone;  ///< the broken cell that took it along (P15); kNone: its own threshold was passed
};

enum class FragmentState : std::uint8_t {
  deforming,  ///< its bonds pull: the lattice is computed
  rigid,      ///< flies freely as it is
  asleep,     ///< stays where it is until something wakes it
};
inline constexpr std::size_t kFragmentStates = 3;

/// A connected component from its birth on.
struct Fragment {
  FragmentId id = kNone;
  FragmentId parent = kNone;  ///< kNone for the components at the start
  double born = 0.0;          ///< s
  std::uint32_t nodeCount = 0;
  double mass = 0.0;
  Vec3 centre = Vec3::Zero();    ///< of mass, cm
  Vec3 velocity = Vec3::Zero();  ///< of the centre, cm/s
  Vec3 boxMin = Vec3::Zero();
  Vec3 boxMax = Vec3::Zero();
  FragmentState state = FragmentState::deforming;
};

/// One moment of a simulation, immutable once made; all that drawing, recording and export need.
struct Snapshot {
  double time = 0.0;
  std::uint64_t stepCount = 0;
  std::vector<Vec3> positions;
  std::vector<Vec3> velocities;
  std::vector<FragmentId> fragmentOfNode;
  std::vector<std::uint8_t> brokenBonds;  ///< one byte a bond
  std::vector<std::uint8_t> brokenCells;  ///< one byte a cell
  std::vector<Fragment> fragments;        ///< living ones, by id
  LedgerRow ledger;
};
using SnapshotPointer = std::shared_ptr<const Snapshot>;

}  // namespace sim
