#include <algorithm>
#include <cmath>

#include "sim/contact/contacts.h"

namespace sim {
namespace {

/// The force of friction over the slip, g/s: as in frictionForce(), where the clamp is what stops it.
double frictionDamping(const Vec3& slip, double limit, double massShare, double kick) {
  const double speed = slip.norm();
  return speed > 0.0 ? std::min(limit / speed, massShare / kick) : 0.0;
}

}  // namespace

void Contacts::addPairTangent(NodeIndex node, const Entry& entry, const Moment& moment,
                              std::span<const RowLook> looks, std::vector<Tangent>& tangents) const {
  const Vec3 apart = moment.motion.position.get(entry.other) - moment.motion.position.get(node);
  const double distance = apart.norm();
  if (distance >= entry.rho || distance == 0.0) return;
  const Vec3 direction = apart / distance;
  const Vec3 relative = moment.motion.velocity.get(entry.other) - moment.motion.velocity.get(node);
  const double separating = relative.dot(direction);
  const PairConstants constants = scaled(constantsOf(node, entry), node, entry, moment);
  const double elastic = constants.stiffness * (entry.rho - distance);
  Tangent tangent{node, entry.other, direction, 0.0, 0.0, 0.0, 0.0};
  if (elastic - constants.damping * separating > 0.0) {
    tangent.stiffness = constants.stiffness;
    tangent.damping = constants.damping;
  }
  if (entry.brokenBond == kNone && settings_.friction > 0.0) {
    const double reduced = 1.0 / (1.0 / massShare(node, looks) + 1.0 / massShare(entry.other, looks));
    tangent.lateralDamping = frictionDamping(relative - separating * direction, settings_.friction * elastic,
                                             reduced, moment.kick);
  }
  tangents.push_back(tangent);
}

void Contacts::addColliderTangent(NodeIndex node, const MovingCollider& collider, const Moment& moment,
                                  std::span<const RowLook> looks, std::vector<Tangent>& tangents) const {
  const Vec3 here = moment.motion.position.get(node);
  const Intrusion inside = intrusion(collider.shape, here);
  const double mass = network_->masses[node];
  if (inside.depth <= 0.0 || !std::isfinite(mass)) return;
  const Vec3 relative = moment.motion.velocity.get(node) - collider.velocityAt(here);
  const double leaving = relative.dot(inside.normal);
  const double stiffness = colliderStiffness(node, collider.shape, moment.materials);
  const double elastic = stiffness * inside.depth;
  const double damping = 2.0 * collider.shape.dampingRatio * std::sqrt(stiffness * mass);
  Tangent tangent{node, kNone, inside.normal, 0.0, 0.0, 0.0, 0.0};
  if (elastic - damping * leaving > 0.0) {
    tangent.stiffness = stiffness;
    tangent.damping = damping;
  }
  tangent.lateralDamping =
      frictionDamping(relative - leaving * inside.normal, collider.shape.friction * elastic,
                      massShare(node, looks), moment.kick);
  tangents.push_back(tangent);
}

void Contacts::addTangents(const Moment& moment, const Forces& forces, std::vector<Tangent>& tangents) const {
  for (const std::uint32_t index : forces.busy) {
    const Row& row = rows_[index];
    for (std::uint32_t t = 0; t < forces.looks[index].touching; ++t) {
      const Entry& entry = entries_[forces.touching[row.firstEntry + t]];
      if (entry.other > row.node) addPairTangent(row.node, entry, moment, forces.looks, tangents);
    }
    for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c)
      addColliderTangent(row.node, moment.colliders[nearColliders_[c]], moment, forces.looks, tangents);
  }
  for (const BrokenPair& pair : fresh_)
    addPairTangent(pair.a, {pair.restLength, pair.b, pair.bond}, moment, {}, tangents);
}

}  // namespace sim
