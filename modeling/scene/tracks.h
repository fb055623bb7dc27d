#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "modeling/scene/scene.h"

/// The tracks of a scene: what they make of it at a time, and how their keys are edited. What they mean is
/// decided by sim/control/driven.h alone; this puts scenes into its terms.
namespace modeling {

/// A number for scales, else a vector, in the units of the scene's file: a rotation is in degrees.
using TrackValue = std::variant<double, Vec3>;

/// What the numbers of a track are: a factor, cm/s^2, cm or degrees.
enum class TrackUnit { factor, acceleration, length, degrees };
TrackUnit unitOf(const TargetName& target);
/// 3 for vectors, else 1.
std::size_t componentsOf(const TargetName& target);
/// The least that a component may be: stiffness and damping are never below 0.
double leastOf(const TargetName& target);
/// The largest.
double mostOf(const TargetName& target);
/// A scalar becomes x.
Vec3 asVector(const TrackValue& value);
/// The target's kind of value: x alone for scalars.
TrackValue asValue(const TargetName& target, const Vec3& vector);

/// All that tracks of this scene can drive. A single material is named only where a track names it already,
/// since a track of all materials does the same.
std::vector<TargetName> targetsOf(const Scene& scene);
/// The value with which a track of this target changes nothing.
TrackValue neutralValue(const Scene& scene, const TargetName& target);

/// The tracks in the terms of a simulation. `materials` are the network's names, by index: a track of a
/// material that the network has in several variants becomes several tracks.
std::vector<sim::Track> simulationTracks(const Scene& scene, const std::vector<std::string>& materials);

/// The value of one track by itself.
TrackValue valueAt(const SceneTrack& track, double time);
/// What acts and what it is made of, cm/s^2: the scale multiplies the unscaled gravity.
Vec3 gravityAt(const Scene& scene, double time);
Vec3 unscaledGravityAt(const Scene& scene, double time);
/// The product of all tracks that scale this target, which is no vector. Tracks of all materials count for
/// each; for all materials together those of single ones do not count.
double scaleAt(const Scene& scene, const TargetName& target, double time);
/// The same without one of the scene's tracks.
double scaleWithoutAt(const Scene& scene, const SceneTrack& without, double time);
/// The scene's colliders that are active at a time (s), where its tracks have them; invisible ones as well.
std::vector<sim::Collider> collidersAt(const Scene& scene, double time);

/// s: keys are at least so far apart.
inline constexpr double kKeyDistance = 1e-6;

/// Adds a track that changes nothing yet, with one key at the start. Gives its index.
std::size_t addTrack(Scene& scene, const TargetName& target);
/// Drives another target from now on. Values of another kind mean nothing to it: they become neutral.
void setTarget(Scene& scene, std::size_t track, const TargetName& target);
/// Gives the key's index. A key that is at this time already is replaced.
std::size_t addKey(SceneTrack& track, double time, const TrackValue& value);
/// A key stays between its neighbours, and not before 0 s.
void moveKey(SceneTrack& track, std::size_t key, double time);
/// With its last key a track goes away.
void removeKey(Scene& scene, std::size_t track, std::size_t key);

}  // namespace modeling
