#pragma once

#include <string>
#include <variant>
#include <vector>

#include "modeling/scene/tracks.h"
#include "sim/dynamics/simulation.h"

/// What someone does to a running simulation, as changes of its scene: afterwards conditionsOf() gives what
/// Simulation::replan() is to be told, and a run of the changed scene from the start is the same, to the bit.
namespace modeling {

/// The time of what is performed now, s: behind all that is done, by half of the step that is planned. Where
/// the next is made shorter than that it acts from the one after. What is performed later in the same step
/// has the same time, and replaces it.
double performTime(const sim::Simulation& simulation);

/// From `time` on the target has this value: a key in the last of its tracks that holds values (Interpolation
/// ::step) and decides, without the keys that the track had from then on; in a track of its own where there
/// is none. Until then, which is after 0, everything is as it was. Scales multiply those of other tracks. The
/// target is gravity or a scale: colliders that are to move are added by addPerformer().
void performKey(Scene& scene, const TargetName& target, double time, TrackValue value);

/// The value that performKey() has to be given for the scale of the target to be `total`, as other tracks
/// multiply with it. Where those make nothing of any value, `total` itself.
double performedScale(const Scene& scene, const TargetName& target, double time, double total);

/// Adds an invisible collider that comes at the path's first time, goes along it, and is gone at its last: at
/// least two keys in order of time, positions in cm. It is called by the prototype's name and a number that
/// makes it another's than all others'; gives that name.
std::string addPerformer(Scene& scene, SceneCollider prototype, std::vector<SceneTrackKey> path);

/// Adds a collider as it is, and a track that leads it along the path. No other collider has its name.
void addAlongPath(Scene& scene, SceneCollider collider, std::vector<SceneTrackKey> path);

}  // namespace modeling
