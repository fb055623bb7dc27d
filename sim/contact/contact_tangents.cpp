#include "sim/contact/contact_tangents.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

/// The force of friction over the slip, g/s: as in contact_forces.cpp, where the clamp is what stops it.
double frictionDamping(const Vec3& slip, double limit, double massShare, double kick) {
  const double speed = slip.norm();
  return speed > 0.0 ? std::min(limit / speed, massShare / kick) : 0.0;
}

void addPairTangent(const Contacts& contacts, NodeIndex node, const ContactEntry& entry,
                    const ContactMoment& moment, std::span<const RowLook> looks,
                    std::vector<Tangent>& tangents) {
  const Vec3 apart = moment.motion.position.get(entry.other) - moment.motion.position.get(node);
  const double distance = apart.norm();
  if (distance >= entry.rho || distance == 0.0) return;
  const Vec3 direction = apart / distance;
  const Vec3 relative = moment.motion.velocity.get(entry.other) - moment.motion.velocity.get(node);
  const double separating = relative.dot(direction);
  const PairConstants constants =
      constantsNow(contacts, contacts.model().constantsOf(node, entry), node, entry, moment);
  const double elastic = constants.stiffness * (entry.rho - distance);
  Tangent tangent{node, entry.other, direction, 0.0, 0.0, 0.0, 0.0};
  if (elastic - constants.damping * separating > 0.0) {
    tangent.stiffness = constants.stiffness;
    tangent.damping = constants.damping;
  }
  const double friction = contacts.model().settings().friction;
  if (entry.brokenBond == kNone && friction > 0.0) {
    const double reduced =
        1.0 / (1.0 / massShare(contacts, node, looks) + 1.0 / massShare(contacts, entry.other, looks));
    tangent.lateralDamping =
        frictionDamping(relative - separating * direction, friction * elastic, reduced, moment.kick);
  }
  tangents.push_back(tangent);
}

void addColliderTangent(const Contacts& contacts, NodeIndex node, std::uint32_t which,
                        const ContactMoment& moment, std::span<const RowLook> looks,
                        std::vector<Tangent>& tangents) {
  const MovingCollider& collider = moment.colliders[which];
  const Vec3 here = moment.motion.position.get(node);
  const Intrusion inside = intrusion(collider.shape, here);
  const StartDepths::Surface surface = contacts.starts().of(node, which, inside.normal, moment.time);
  const double mass = contacts.model().network().masses[node];
  if (inside.depth <= surface.depth || !std::isfinite(mass)) return;
  const Vec3 carried = collider.velocityAt(here) + surface.speed * inside.normal;
  const Vec3 relative = moment.motion.velocity.get(node) - carried;
  const double leaving = relative.dot(inside.normal);
  const double stiffness = contacts.model().colliderStiffness(node, collider.shape, moment.materials);
  const double elastic = stiffness * (inside.depth - surface.depth);
  const double damping = 2.0 * collider.shape.dampingRatio * std::sqrt(stiffness * mass);
  Tangent tangent{node, kNone, inside.normal, 0.0, 0.0, 0.0, 0.0};
  if (elastic - damping * leaving > 0.0) {
    tangent.stiffness = stiffness;
    tangent.damping = damping;
  }
  tangent.lateralDamping =
      frictionDamping(relative - leaving * inside.normal, collider.shape.friction * elastic,
                      massShare(contacts, node, looks), moment.kick);
  tangents.push_back(tangent);
}

}  // namespace

void addContactTangents(const Contacts& contacts, const ContactMoment& moment, const ContactForces& forces,
                        std::vector<Tangent>& tangents) {
  const ContactRows& rows = contacts.rows();
  for (const std::uint32_t index : forces.busy) {
    const ContactRow& row = rows.rows[index];
    for (std::uint32_t t = 0; t < forces.looks[index].touching; ++t) {
      const ContactEntry& entry = rows.entries[forces.touching[row.firstEntry + t]];
      if (entry.other > row.node) addPairTangent(contacts, row.node, entry, moment, forces.looks, tangents);
    }
    for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c)
      addColliderTangent(contacts, row.node, rows.nearColliders[c], moment, forces.looks, tangents);
  }
  for (const BrokenPair& pair : rows.fresh)
    addPairTangent(contacts, pair.a, {pair.restLength, pair.b, pair.bond}, moment, {}, tangents);
}

}  // namespace sim
