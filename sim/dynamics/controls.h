#pragma once

#include <vector>

#include "sim/contact/contacts.h"
#include "sim/control/track.h"
#include "sim/dynamics/settings.h"

namespace sim {

/// The environment and the materials as tracks make them at a moment.
class Controls {
 public:
  Controls(const Network& network, Environment environment, std::vector<Track> tracks);

  /// Which values differ from those of the moment before.
  struct Change {
    bool gravity = false;
    bool stiffness = false;  ///< stiffness or damping of some material
    bool leap = false;       ///< a collider is elsewhere without having moved there
  };
  Change moveTo(double time);
  bool hasTracks() const { return !tracks_.empty(); }

  const Vec3& gravity() const { return gravity_; }
  const std::vector<MovingCollider>& colliders() const { return colliders_; }
  /// As they will be `ahead` seconds from now, if they go on as they move now.
  std::vector<MovingCollider> collidersAhead(double ahead) const;
  const std::vector<MaterialNow>& materials() const { return materials_; }
  /// Rest lengths flow by a share of the excess strain that depends on the step.
  void setFlow(const Network& network, double step);
  /// How far the last moveTo() moved any point of a collider at most, cm.
  double colliderTravel() const { return colliderTravel_; }
  /// Whether the last moveTo() moved this collider.
  bool moved(std::size_t collider) const { return moved_[collider] != 0; }
  /// Nothing changes from `time` until then, s.
  double constantUntil(double time) const;
  double largestStiffnessScale() const;
  double largestDampingScale() const;

 private:
  /// True when one leapt, by a track of steps.
  bool moveColliders(double time);

  Environment environment_;
  std::vector<Track> tracks_;
  Vec3 gravity_;
  std::vector<MovingCollider> colliders_;
  std::vector<MaterialNow> materials_;
  std::vector<std::uint8_t> moved_;  ///< by collider
  double colliderTravel_ = 0.0;
};

}  // namespace sim
