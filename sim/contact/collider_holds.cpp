#include "sim/contact/collider_holds.h"

#include <algorithm>
#include <iterator>

namespace sim {
namespace {

Vec3 inCollider(const Collider& collider, const Vec3& point) {
  return collider.rotation.conjugate() * (point - collider.position);
}

/// Brings one hold to the present, and gives what is lost by it, erg.
double follow(const Contacts& contacts, const ContactMoment& moment, NodeIndex node, std::uint32_t which,
              ColliderHold& hold) {
  const Collider& collider = moment.colliders[which].shape;
  const Vec3 here = moment.motion.position.get(node);
  const Intrusion inside = intrusion(collider, here, hold.nearest);
  hold.nearest = inside.nearest;
  const double stiffness = contacts.model().colliderStiffness(node, collider, moment.materials);
  const double depth = inside.depth - contacts.starts().of(node, which, inside.normal, moment.time).depth;
  const bool touches = moment.colliders[which].active && depth > 0.0;
  if (hold.held == 0) {
    if (touches && collider.friction > 0.0) hold = {inCollider(collider, here), 0.0, inside.nearest, 1};
    return 0.0;
  }
  const Vec3 stretch = stretchOf(hold, collider, here, inside.normal);
  const double length = stretch.norm();
  const double most = touches ? collider.friction * depth : 0.0;
  const double left = std::min(length, most);
  const double lost = energyOf(hold, length, most, stiffness) - 0.5 * stiffness * left * left;
  if (length > most) hold.anchor = inCollider(collider, here - most / length * stretch);
  hold.stretch = left;
  if (!touches) hold.held = 0;
  return lost;
}

}  // namespace

bool holdsAtColliders(const ContactModel& model) {
  return model.settings().kind == ContactKind::surfaces;
}

Vec3 stretchOf(const ColliderHold& hold, const Collider& collider, const Vec3& here, const Vec3& normal) {
  const Vec3 apart = here - collider.position - collider.rotation * hold.anchor;
  return apart - normal.dot(apart) * normal;
}

double energyOf(const ColliderHold& hold, double stretch, double most, double stiffness) {
  const double before = hold.stretch;
  const double now = std::min(stretch, most);
  return 0.5 * stiffness * (before * before + (before + now) * (stretch - before));
}

double followHolds(Contacts& contacts, const ContactMoment& moment, const ContactForces& forces) {
  if (!holdsAtColliders(contacts.model())) return 0.0;
  const ContactRows& rows = contacts.rows();
  ColliderHolds& holds = contacts.holds();
  std::vector<std::uint32_t> looked;
  std::ranges::set_union(forces.busy, holds.rows, std::back_inserter(looked));
  holds.rows.clear();
  double lost = 0.0;
  for (const std::uint32_t r : looked) {
    const ContactRow& row = rows.rows[r];
    bool held = false;
    for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) {
      ColliderHold& hold = holds.byCollider[c];
      if (moment.moves(row.node)) lost += follow(contacts, moment, row.node, rows.nearColliders[c], hold);
      held = held || hold.held != 0;
    }
    if (held) holds.rows.push_back(r);
  }
  return lost;
}

}  // namespace sim
