#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "modeling/run/recording.h"
#include "modeling/scene/scene.h"
#include "sim/dynamics/simulation.h"
#include "sim/take/take.h"

/// Going on from any frame of a take, as it was or under other conditions, as a new take beside the old.
namespace modeling {

/// Told how much is done, from 0 to 1; false stops.
using KeepGoing = std::function<bool(double share)>;

struct Continuation {
  std::unique_ptr<sim::Simulation> simulation;  ///< at the frame; its breaks since are none
  Scene scene;                                  ///< by which it goes on
  bool changed = false;                         ///< it moves otherwise than in the take
};

/// Whether a run of one scene can go on by the other: gravity, colliders, tracks, damping, contact and solver
/// may differ, and what is only looked at; what the network was made from may not. The Problem's place is a
/// path of the scene.
sim::Status checkChange(const Scene& before, const Scene& after);

/// The run again from the checkpoint at or before the frame, to the frame; from there by `changed`, or as it
/// was where that is null: then to the same bits. A Problem when there is no way to the frame, when the scene
/// cannot be changed so, or when it was stopped.
sim::Result<Continuation> continueFrom(const sim::TakeReader& take, std::size_t frame, const Scene* changed,
                                       int threads, const KeepGoing& keepGoing = {});

/// Begins a take of its own with the frames up to that one, and records what follows them until `until` (s).
/// The file must not be the take's. The recording refers to the simulation of `from`.
sim::Result<Recording> branchTake(const sim::TakeReader& take, std::size_t frame, const Continuation& from,
                                  double until, const std::filesystem::path& path,
                                  const KeepGoing& keepGoing = {});

}  // namespace modeling
