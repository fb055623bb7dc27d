#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "modeling/scene/scene.h"
#include "sim/dynamics/simulation.h"

namespace ui {

/// Something a person did while it ran, at the moment of the simulation from which on it acts.
struct PerformedKey {
  modeling::TargetName target;
  double time = 0.0;  ///< s
  std::variant<double, sim::Vec3> value = 0.0;
};
struct PerformedCollider {
  modeling::SceneCollider collider;           ///< under the name the run gave it
  std::vector<modeling::SceneTrackKey> path;  ///< of its position
};
using Performed = std::variant<PerformedKey, PerformedCollider>;
/// Writes it into a scene, whose run from the start then is the one in which it was performed.
void replay(const Performed& performed, modeling::Scene& scene);

/// What is performed on a running simulation, and the scene that it makes of the run's. Not thread-safe.
class Performance {
 public:
  explicit Performance(modeling::Scene scene)
      : scene_(std::make_shared<const modeling::Scene>(std::move(scene))) {}

  /// As performed so far; immutable.
  const std::shared_ptr<const modeling::Scene>& scene() const { return scene_; }
  /// Everything that was done, in its order.
  const std::vector<Performed>& performed() const { return performed_; }

  /// From the next step on, from which the times of the keys count. A Problem where it cannot be done; then
  /// neither run nor scene are changed.
  sim::Status perform(sim::Simulation& simulation, const modeling::TargetName& target,
                      const std::vector<modeling::SceneTrackKey>& keys);
  /// Lets an invisible collider come, go along a path of two keys or more and vanish.
  sim::Status performCollider(sim::Simulation& simulation, const modeling::SceneCollider& prototype,
                              std::vector<modeling::SceneTrackKey> path);

 private:
  sim::Status replan(sim::Simulation& simulation, const std::vector<Performed>& performed);

  std::shared_ptr<const modeling::Scene> scene_;
  std::vector<Performed> performed_;
};

}  // namespace ui
