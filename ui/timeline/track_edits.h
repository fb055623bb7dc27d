#pragma once

#include <QString>

#include "modeling/scene/scene.h"
#include "ui/document/track_titles.h"

/// What the timeline does to the tracks of a scene.
namespace ui {

using TrackValue = std::variant<double, sim::Vec3>;

/// "g", "cm", "degrees"... empty for a factor.
QString unitOf(const modeling::TargetName& target);
/// All that tracks of this scene can drive.
std::vector<modeling::TargetName> targetsOf(const modeling::Scene& scene);

/// Scalars in x.
sim::Vec3 asVector(const TrackValue& value);
/// Of the target's kind.
TrackValue asValue(const modeling::TargetName& target, const sim::Vec3& vector);
std::size_t componentsOf(const modeling::TargetName& target);
/// The lowest that makes sense: stiffness and damping are never below 0.
double leastOf(const modeling::TargetName& target);
sim::Track asTrack(const modeling::SceneTrack& track);
/// Between and beyond keys.
TrackValue valueAt(const modeling::SceneTrack& track, double time);

/// A track that changes nothing yet, with one key at the start. Answers its place.
std::size_t addTrack(modeling::Scene& scene, const modeling::TargetName& target);
/// Answers the key's place; a key that is there at this very time is replaced.
std::size_t addKey(modeling::SceneTrack& track, double time, const TrackValue& value);
/// A key stays between its neighbours, and after the start.
void moveKey(modeling::SceneTrack& track, std::size_t key, double time);
/// With its last key a track goes away.
void removeKey(modeling::Scene& scene, std::size_t track, std::size_t key);

/// s: keys are at least so far apart.
inline constexpr double kKeyDistance = 1e-6;

}  // namespace ui
