#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/fragments/activity.h"
#include "sim/fragments/rigid_body.h"

namespace sim {

/// What is remembered of a fragment that may be skipped. There is no padding, since checkpoints hold the
/// bytes.
struct FragmentRecord {
  /// What happened to a fragment so far, the last of these.
  enum class Past : std::uint8_t { untouched, touched, broken };

  double stillSince = 0.0;       ///< s
  std::uint64_t bonds = 0;       ///< whole ones, while it does not deform
  std::uint16_t wait = 0;        ///< reviews until it is looked at again
  std::uint16_t quietLooks = 0;  ///< in a row, at which it was strained but still
  std::uint16_t lastWait = 0;    ///< reviews
  std::uint8_t skippable = 0;    ///< not held, and made of cells
  Past past = Past::untouched;
};

/// Two fragments that may touch.
struct FragmentNeighbours {
  FragmentId a = kNone;  ///< the lower
  FragmentId b = kNone;
  double approach = 0.0;  ///< cm/s: fastest of their nodes near each other, by their rigid motions

  bool samePair(const FragmentNeighbours& other) const { return a == other.a && b == other.b; }
  bool operator<(const FragmentNeighbours& other) const { return a != other.a ? a < other.a : b < other.b; }
};

/// How each fragment moves, and what is remembered of it. The functions of sim/skipping change it.
struct FragmentMotions {
  FragmentMotions(const Network& network, const Components& components) : activity(network, components) {}

  Activity activity;
  std::vector<FragmentRecord> records;               ///< by fragment
  std::vector<RigidBody> bodies;                     ///< of the fragments that are rigid
  std::vector<FragmentNeighbours> neighbours;        ///< in the contact rows, ascending
  std::vector<FragmentNeighbours> neighboursBefore;  ///< at the look before
  /// Whole bonds of the fragments in each state but `deforming`.
  std::array<std::uint64_t, kFragmentStates> bonds{};
  double typicalLength = 0.0;  ///< cm: mean distance of a node's nearest neighbour
  double peakSpeed = 0.0;      ///< cm/s: highest root mean square speed of everything so far
  bool changed = false;        ///< states were set since the activity was refreshed
  mutable std::optional<double>
      stillElastic;  ///< erg: elastic energy of what does not deform, if it is known

  bool noneDeforms() const { return activity.activeBlocks().empty(); }
  /// Nothing at all moves, or will before something from outside does.
  bool allAsleep() const { return noneDeforms() && bodies.empty(); }
  std::uint64_t bondsIn(FragmentState state) const { return bonds[static_cast<std::size_t>(state)]; }
  std::size_t memoryBytes() const;
};

}  // namespace sim
