#pragma once

#include <memory>

#include "modeling/scene/scene.h"
#include "sim/network/network.h"
#include "sim/state/snapshot.h"

namespace ui {

/// What there is to see at present: a network at one moment, and the scene it belongs to.
struct Shown {
  std::shared_ptr<const sim::Network> network;  ///< null: nothing
  sim::SnapshotPointer moment;
  std::shared_ptr<const modeling::Scene> scene;  ///< for looks and colliders; as it was built or run
  bool recorded = false;                         ///< a moment of a take; else the scene as edited, at rest
  bool live = false;                             ///< the present moment of the run
};

}  // namespace ui
