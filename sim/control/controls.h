#pragma once

#include <limits>
#include <vector>

#include "sim/collider/moving_collider.h"
#include "sim/control/driven.h"
#include "sim/control/track.h"
#include "sim/kernel/bond_kernel.h"
#include "sim/network/network.h"
#include "sim/state/settings.h"

namespace sim {

/// The environment and the materials as tracks make them at a moment.
class Controls {
 public:
  Controls(const Network& network, Environment environment, std::vector<Track> tracks);

  /// Which values differ from those of the moment before.
  struct Change {
    bool gravity = false;
    bool stiffness = false;  ///< stiffness or damping of some material
    bool leap = false;       ///< a collider is elsewhere, or another one, without having moved there
    bool colliders = false;  ///< other colliders act
    bool motion = false;     ///< a collider moved, or goes on at another velocity

    bool any() const { return gravity || stiffness || leap || colliders || motion; }
  };
  Change moveTo(double time);
  /// Other plans, from the next moveTo() on: until then all stays as it is. The colliders are those there
  /// were, in their order, and perhaps more.
  void replan(Environment environment, std::vector<Track> tracks);
  /// Nothing changes between the last moveTo() and then, s. Minus infinity where what is planned is new.
  double constantUntil() const { return constantUntil_; }

  const Vec3& gravity() const { return gravity_; }
  const std::vector<MovingCollider>& colliders() const { return colliders_; }
  /// As they will be `ahead` seconds from now, if they go on as they move now.
  std::vector<MovingCollider> collidersAhead(double ahead) const;
  const std::vector<MaterialNow>& materials() const { return materials_; }
  /// Rest lengths flow by a share of the excess strain that depends on the step.
  void setFlow(const Network& network, double step);
  /// How far the last moveTo() moved any point of a collider that acts at most, cm.
  double colliderTravel() const { return colliderTravel_; }
  /// Whether the last moveTo() moved this collider, or made it act.
  bool moved(std::size_t collider) const { return moved_[collider] != 0; }
  bool anyMoved() const;
  /// Some material is stiffer or softer now than the network says.
  bool scalesStiffness() const;
  double largestStiffnessScale() const;
  double largestDampingScale() const;

 private:
  std::vector<MaterialNow> materialsAt(double time) const;
  void moveColliders(double time, Change& change);
  void moveCollider(std::uint32_t collider, const DrivenCollider& driven, Change& change);

  Environment environment_;
  std::vector<Track> tracks_;
  Vec3 gravity_;
  std::vector<MovingCollider> colliders_;
  std::vector<MaterialNow> materials_;
  std::vector<std::uint8_t> moved_;  ///< by collider
  double colliderTravel_ = 0.0;
  double constantUntil_ = -std::numeric_limits<double>::infinity();
};

}  // namespace sim
