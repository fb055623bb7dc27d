#pragma once

#include <vector>

#include "sim/base/aligned.h"
#include "sim/contact/contact_forces.h"
#include "sim/control/controls.h"
#include "sim/fracture/breakage.h"
#include "sim/fracture/components.h"
#include "sim/fragments/fragment_motions.h"
#include "sim/kernel/bond_layout.h"
#include "sim/state/ledger.h"
#include "sim/state/motion.h"
#include "sim/state/settings.h"
#include "sim/state/work.h"
#include "sim/world/clock.h"

namespace sim {

/// All that a run is at a moment, as data: what passes of a step read and write. It has more members than
/// other classes because it is the one place where they stand together; each is a type that keeps its own
/// invariants.
///
/// Between steps everything is of one moment, but for velocities, which may lag behind by half a step
/// (sim/methods/leapfrog.h), and for nodes of rigid bodies, which are where placeBodies() last put them.
struct World {
  /// Gravity, stiffness and colliders are not yet those of any moment: applying the tracks makes them so.
  World(Network network, Environment environment, std::vector<Track> tracks, const Settings& settings);
  // Its members point at each other.
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  double time() const { return clock.now(); }

  // What the run was given.
  const Network network;
  const Settings settings;
  const StepBlocks kernel;
  const std::vector<NodeIndex> carried;  ///< held nodes that move

  // What moves, is bent and broken.
  Clock clock;
  Motion now;
  AlignedVector<double>
      inverseMasses;  ///< 1/g, by node, padded; zero for nodes that do not move by themselves
  BondLayout layout;
  Breakage breakage;
  Components components;
  FragmentMotions fragments;
  Contacts contacts;
  Controls controls;
  double controlsTime = 0.0;  ///< s: when the tracks were last applied
  Ledger ledger;
  Work work;
  std::vector<BreakEvent> events;  ///< not yet fetched by anyone

  // What a step leaves for its later passes.
  Motion next;  ///< where a step is written; afterwards, the state before it
  ContactForces forces;
  std::vector<BlockReport> reports;  ///< of the kernel, by block
  std::vector<FragmentId> stopped;   ///< rigid ones that are to deform from the next step on

  std::size_t memoryBytes() const;
};

/// Steps are of this length (s) from now on, and so rest lengths flow by it.
void setStep(World& world, double seconds);

/// Some bond is evaluated.
bool latticeMoves(const World& world);

}  // namespace sim
