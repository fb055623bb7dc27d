#include "sim/contact/contact_forces.h"

#include <algorithm>
#include <cmath>

#include "sim/base/parallel.h"
#include "sim/contact/collider_holds.h"
#include "sim/contact/surface_forces.h"

namespace sim {
namespace {

/// Rows a task takes at least: below, handing out costs more than the rows.
constexpr std::size_t kLookGrain = 1024;
constexpr std::size_t kPushGrain = 64;

/// Of the skin around colliders: more than any force adds to a node's way in a step, since springs change a
/// stable step's way by less than their own extension.
constexpr double kForcesShare = 0.1;

/// Of a clearance, what is left by the rounding of a long odometer.
constexpr double kSurely = 1.0 - 1e-9;

/// Against the slip, at most `limit` (dyn), but never more than stops it within the step.
Vec3 frictionForce(const Vec3& slip, double limit, double massShare, double kick) {
  const double speed = slip.norm();
  if (!(speed > 0.0)) return Vec3::Zero();
  return -std::min(limit / speed, massShare / kick) * slip;
}

double spring(double stiffness, double intrusion) {
  return 0.5 * stiffness * intrusion * intrusion;
}

}  // namespace

double massShare(const Contacts& contacts, NodeIndex node, std::span<const RowLook> looks) {
  return contacts.model().network().masses[node] /
         std::max(1U, looks[contacts.rows().rowOfNode[node]].active);
}

PairConstants constantsNow(const Contacts& contacts, const PairConstants& unscaled, NodeIndex node,
                           const ContactEntry& entry, const ContactMoment& moment) {
  return moment.scaled ? contacts.model().scaled(unscaled, node, entry, moment.materials) : unscaled;
}

void ContactForces::clear() {
  for (std::size_t block = 0; block < touched.size(); ++block) {
    if (touched[block] == 0) continue;
    touched[block] = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      std::fill_n(total.axis(k) + block * kBlockNodes, kBlockNodes, 0.0);
      std::fill_n(lossy.axis(k) + block * kBlockNodes, kBlockNodes, 0.0);
    }
  }
}

namespace {

struct Push {
  Vec3 total = Vec3::Zero();
  Vec3 lossy = Vec3::Zero();
};

/// The forces of one moment being found.
class ForcePass {
 public:
  ForcePass(const Contacts& contacts, const ContactMoment& moment, ContactForces& forces)
      : contacts_(contacts),
        model_(contacts.model()),
        rows_(contacts.rows()),
        moment_(moment),
        forces_(forces) {}

  void prepare();
  /// Finds what touches in a row, and how long nothing can, if nothing does.
  void look(std::uint32_t index);
  ColliderWork pushRow(std::uint32_t index);
  /// Pairs that broke since the rows were filled: few that touch, so one after the other.
  void pushFresh();

 private:
  Push pairPush(NodeIndex node, const ContactEntry& entry, const PairConstants& unscaled,
                std::span<const RowLook> looks) const;
  /// `place`: in ContactRows::nearColliders.
  Push colliderPush(NodeIndex node, std::uint32_t place, ColliderWork& work) const;
  /// Holds a node back, at most by `limit` (dyn), and drags on what slides, which is lost, within the same.
  Push holdBack(const ColliderHold& hold, const Collider& collider, const Vec3& here, const Vec3& normal,
                const Vec3& slip, double stiffness, double damping, double limit) const;

  const Contacts& contacts_;
  const ContactModel& model_;
  const ContactRows& rows_;
  const ContactMoment& moment_;
  ContactForces& forces_;
};

void ForcePass::prepare() {
  if (forces_.total.size() == 0) {
    forces_.total = NodeVectors(model_.network().nodeCount());
    forces_.lossy = NodeVectors(model_.network().nodeCount());
  }
  forces_.clear();
  const bool sameRows =
      forces_.looksOfRebuild == contacts_.rebuilds() && forces_.looks.size() == rows_.rows.size();
  if (!sameRows) {
    forces_.looksOfRebuild = contacts_.rebuilds();
    forces_.looks.assign(rows_.rows.size(), {});
    forces_.inside.assign(rows_.nearColliders.size(), {});
    forces_.touching.resize(rows_.entries.size());
  }
  if (sameRows && forces_.watchedVersion == moment_.awakeVersion && !forces_.watched.empty()) return;
  forces_.watchedVersion = moment_.awakeVersion;
  forces_.watched.clear();
  for (std::uint32_t row = 0; row < rows_.rows.size(); ++row) {
    if (moment_.moves(rows_.rows[row].node)) forces_.watched.push_back(row);
  }
}

void ForcePass::look(std::uint32_t index) {
  RowLook& found = forces_.looks[index];
  const double odometer = contacts_.age().odometer();
  if (odometer + moment_.lead < found.clearUntil) return;
  const ContactRow& row = rows_.rows[index];
  const double* const x = moment_.motion.position.axis(0);
  const double* const y = moment_.motion.position.axis(1);
  const double* const z = moment_.motion.position.axis(2);
  const Vec3 here(x[row.node], y[row.node], z[row.node]);
  double nearest = std::numeric_limits<double>::infinity();  // squared
  found = {.room = std::numeric_limits<double>::infinity()};
  for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
    const ContactEntry& entry = rows_.entries[e];
    const double dx = x[entry.other] - here.x();
    const double dy = y[entry.other] - here.y();
    const double dz = z[entry.other] - here.z();
    const double squared = dx * dx + dy * dy + dz * dz;
    nearest = std::min(nearest, squared);
    if (squared >= entry.rho * entry.rho) continue;
    forces_.touching[row.firstEntry + found.touching++] = e;
    if (entry.brokenBond == kNone) ++found.active;
  }
  // Both nodes may come; of node and collider each has its own share of the odometer.
  double clearance = 0.5 * (std::sqrt(nearest) - static_cast<double>(row.reach));
  for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) {
    const Collider& collider = moment_.colliders[rows_.nearColliders[c]].shape;
    Intrusion& inside = forces_.inside[c];
    inside = intrusion(collider, here, inside.nearest);
    const double depth = inside.depth;
    if (depth > 0.0) ++found.active;
    clearance = std::min(clearance, -depth);
    found.room = std::min(found.room, deepest(collider) - depth);
  }
  if (found.touching + found.active == 0) found.clearUntil = odometer + kSurely * clearance - moment_.lead;
}

Push ForcePass::pairPush(NodeIndex node, const ContactEntry& entry, const PairConstants& unscaled,
                         std::span<const RowLook> looks) const {
  const Vec3 apart = moment_.motion.position.get(entry.other) - moment_.motion.position.get(node);
  const double squared = apart.squaredNorm();
  if (squared >= entry.rho * entry.rho || squared == 0.0) return {};
  const double distance = std::sqrt(squared);
  const Vec3 direction = apart / distance;
  const Vec3 relative = moment_.motion.velocity.get(entry.other) - moment_.motion.velocity.get(node);
  const double separating = relative.dot(direction);
  const PairConstants constants = constantsNow(contacts_, unscaled, node, entry, moment_);
  const double elastic = constants.stiffness * (entry.rho - distance);
  const double normal = std::max(0.0, elastic - constants.damping * separating);
  Push push{-normal * direction, (elastic - normal) * direction};
  const double coefficient = model_.settings().friction;
  if (entry.brokenBond == kNone && coefficient > 0.0) {
    const double give = moment_.moves(entry.other) ? 1.0 / massShare(contacts_, entry.other, looks) : 0.0;
    const double reduced = 1.0 / (1.0 / massShare(contacts_, node, looks) + give);
    const Vec3 slip = -(relative - separating * direction);
    const Vec3 friction = frictionForce(slip, coefficient * elastic, reduced, moment_.kick);
    push.total += friction;
    push.lossy += friction;
  }
  return push;
}

Push ForcePass::holdBack(const ColliderHold& hold, const Collider& collider, const Vec3& here,
                         const Vec3& normal, const Vec3& slip, double stiffness, double damping,
                         double limit) const {
  Vec3 held = Vec3::Zero();
  if (hold.held != 0) held = -stiffness * stretchOf(hold, collider, here, normal);
  if (held.norm() > limit) held *= limit / held.norm();
  Vec3 drag = -damping * slip;
  const double room = std::max(0.0, limit - held.norm());
  if (drag.norm() > room) drag *= room / drag.norm();
  return {held + drag, drag};
}

Push ForcePass::colliderPush(NodeIndex node, std::uint32_t place, ColliderWork& work) const {
  const std::uint32_t which = rows_.nearColliders[place];
  const Intrusion& inside = forces_.inside[place];
  const MovingCollider& collider = moment_.colliders[which];
  const Vec3 here = moment_.motion.position.get(node);
  const double mass = model_.network().masses[node];
  if (inside.depth <= 0.0 || !std::isfinite(mass)) return {};
  const StartDepths::Surface surface = contacts_.starts().of(node, which, inside.normal, moment_.time);
  if (inside.depth <= surface.depth) return {};
  const Vec3 carried = collider.velocityAt(here) + surface.speed * inside.normal;
  const Vec3 relative = moment_.motion.velocity.get(node) - carried;
  const double leaving = relative.dot(inside.normal);
  const Vec3 slip = relative - leaving * inside.normal;
  const double stiffness = model_.colliderStiffness(node, collider.shape, moment_.materials);
  const double elastic = stiffness * (inside.depth - surface.depth);
  const double damping = 2.0 * collider.shape.dampingRatio * std::sqrt(stiffness * mass);
  const double normal = std::max(0.0, elastic - damping * leaving);
  const double limit = collider.shape.friction * elastic;
  Push friction;
  if (holdsAtColliders(model_)) {
    friction = holdBack(rows_.holds.byCollider[place], collider.shape, here, inside.normal, slip, stiffness,
                        damping, limit);
  } else {
    friction.total = friction.lossy =
        frictionForce(slip, limit, massShare(contacts_, node, forces_.looks), moment_.kick);
  }
  const Push push{normal * inside.normal + friction.total,
                  (normal - elastic) * inside.normal + friction.lossy};
  work.outside += push.total.dot(carried) * moment_.kick;
  work.dissipated += push.lossy.dot(carried) * moment_.kick;
  return push;
}

ColliderWork ForcePass::pushRow(std::uint32_t index) {
  const ContactRow& row = rows_.rows[index];
  const RowLook& found = forces_.looks[index];
  Push sum;
  ColliderWork work;
  const auto add = [&](const Push& push) {
    sum.total += push.total;
    sum.lossy += push.lossy;
  };
  for (std::uint32_t t = 0; t < found.touching; ++t) {
    const std::uint32_t e = forces_.touching[row.firstEntry + t];
    add(pairPush(row.node, rows_.entries[e], rows_.constants[e], forces_.looks));
  }
  for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) add(colliderPush(row.node, c, work));
  forces_.total.set(row.node, sum.total);
  forces_.lossy.set(row.node, sum.lossy);
  return work;
}

void ForcePass::pushFresh() {
  for (const BrokenPair& pair : rows_.fresh) {
    const ContactEntry entry{pair.restLength, pair.b, pair.bond};
    const Push push = pairPush(pair.a, entry, model_.constantsOf(pair.a, entry), {});
    if (push.total.isZero(0.0) && push.lossy.isZero(0.0)) continue;
    forces_.touched[pair.a / kBlockNodes] = forces_.touched[pair.b / kBlockNodes] = 1;
    forces_.total.add(pair.a, push.total);
    forces_.lossy.add(pair.a, push.lossy);
    forces_.total.add(pair.b, -push.total);
    forces_.lossy.add(pair.b, -push.lossy);
  }
}

}  // namespace

ColliderWork findContactForces(const Contacts& contacts, const ContactMoment& moment, ContactForces& forces) {
  ForcePass pass(contacts, moment, forces);
  pass.prepare();
  const std::vector<std::uint32_t>& watched = forces.watched;
  parallelRanges(watched.size(), kLookGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t w = begin; w < end; ++w) pass.look(watched[w]);
  });
  forces.busy.clear();
  for (const std::uint32_t r : watched) {
    if (forces.looks[r].touching + forces.looks[r].active == 0) continue;
    forces.busy.push_back(r);
    forces.touched[contacts.rows().rows[r].node / kBlockNodes] = 1;
  }
  forces.work.resize(forces.busy.size());
  parallelRanges(forces.busy.size(), kPushGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) forces.work[b] = pass.pushRow(forces.busy[b]);
  });
  pass.pushFresh();
  addSurfaceForces(contacts.model(), contacts.surfaces(), moment, forces);
  ColliderWork sum;
  for (const ColliderWork& work : forces.work) {
    sum.outside += work.outside;
    sum.dissipated += work.dissipated;
  }
  return sum;
}

std::vector<NearCollider> nodesNearLimits(const Contacts& contacts, const ContactMoment& moment,
                                          const ContactForces& forces, double step, double steps) {
  std::vector<NearCollider> near;
  if (!contacts.age().collidersEnd()) return near;
  const ContactRows& rows = contacts.rows();
  for (const std::uint32_t r : forces.watched) {
    const ContactRow& row = rows.rows[r];
    if (row.firstCollider == row.lastCollider) continue;
    const RowLook& found = forces.looks[r];
    // What pushes has been looked at just now; the others are clear by what is left of their clearance.
    const bool pushes = found.touching + found.active > 0;
    const double room = pushes ? found.room : found.clearUntil - contacts.age().odometer();
    const std::size_t count = row.lastCollider - row.firstCollider;
    const std::span colliders(rows.nearColliders.data() + row.firstCollider, count);
    const std::span inside(forces.inside.data() + row.firstCollider, count);
    const Vec3 here = moment.motion.position.get(row.node);
    const Vec3 velocity = moment.motion.velocity.get(row.node);
    double fastest = 0.0;
    for (const std::uint32_t c : colliders)
      fastest = std::max(fastest, (velocity - moment.colliders[c].velocityAt(here)).norm());
    if (room < kForcesShare * contacts.model().colliderSkin() + steps * step * fastest)
      near.push_back({row.node, colliders, inside});
  }
  return near;
}

double contactEnergy(const Contacts& contacts, const ContactMoment& moment) {
  const ContactModel& model = contacts.model();
  const ContactRows& rows = contacts.rows();
  const NodeVectors& positions = moment.motion.position;
  double sum = surfaceEnergy(model, contacts.surfaces(), moment);
  for (const ContactRow& row : rows.rows) {
    const Vec3 here = positions.get(row.node);
    for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
      const ContactEntry& entry = rows.entries[e];
      const double squared = (positions.get(entry.other) - here).squaredNorm();
      if (squared >= entry.rho * entry.rho) continue;
      const double depth = entry.rho - std::sqrt(squared);
      sum +=
          0.5 * spring(constantsNow(contacts, rows.constants[e], row.node, entry, moment).stiffness, depth);
    }
    for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) {
      const std::uint32_t which = rows.nearColliders[c];
      const Collider& collider = moment.colliders[which].shape;
      const Intrusion inside = intrusion(collider, here);
      const double depth =
          inside.depth - contacts.starts().of(row.node, which, inside.normal, moment.time).depth;
      if (depth <= 0.0) continue;
      const double stiffness = model.colliderStiffness(row.node, collider, moment.materials);
      sum += spring(stiffness, depth);
      const ColliderHold& hold = rows.holds.byCollider[c];
      if (hold.held == 0) continue;
      sum += energyOf(hold, stretchOf(hold, collider, here, inside.normal).norm(), collider.friction * depth,
                      stiffness);
    }
  }
  for (const BrokenPair& pair : rows.fresh) {
    const double depth = pair.restLength - (positions.get(pair.b) - positions.get(pair.a)).norm();
    if (depth <= 0.0) continue;
    const ContactEntry entry{pair.restLength, pair.b, pair.bond};
    const PairConstants unscaled = model.constantsOf(pair.a, entry);
    sum += spring(constantsNow(contacts, unscaled, pair.a, entry, moment).stiffness, depth);
  }
  return sum;
}

namespace {

/// Raises by what touches in a row, or may before the step is chosen again. Most rows are out of the question
/// even if all in them touched.
void raiseByRow(const Contacts& contacts, std::uint32_t index, const ContactMoment& moment, Stiffest& most) {
  const ContactModel& model = contacts.model();
  const ContactRows& rows = contacts.rows();
  const ContactRow& row = rows.rows[index];
  const double mass = model.network().masses[row.node];
  if (!std::isfinite(mass)) return;
  double stiffness = 0.0;
  double damping = 0.0;
  for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) {
    const Collider& collider = moment.colliders[rows.nearColliders[c]].shape;
    const double k = model.colliderStiffness(row.node, collider, moment.materials);
    stiffness += k;
    damping += 2.0 * collider.dampingRatio * std::sqrt(k * mass);
  }
  const Stiffest& pairs = rows.mostOfRow[index];
  const Stiffest all{(stiffness + pairs.rateSquared) / mass, (damping + pairs.damping) / mass};
  if (!moment.scaled && most.covers(all)) return;
  const Vec3 here = moment.motion.position.get(row.node);
  const double closing = RowAge::kChoiceShare * model.largestNatural();
  for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
    const ContactEntry& entry = rows.entries[e];
    const double reach = entry.rho + closing;
    if ((moment.motion.position.get(entry.other) - here).squaredNorm() > reach * reach) continue;
    const PairConstants constants = constantsNow(contacts, rows.constants[e], row.node, entry, moment);
    stiffness += 2.0 * constants.stiffness;
    damping += 2.0 * constants.damping;
  }
  most.raise({stiffness / mass, damping / mass});
}

}  // namespace

Stiffest stiffestContacts(const Contacts& contacts, const ContactMoment& moment,
                          const ContactForces& forces) {
  const std::vector<ContactRow>& rows = contacts.rows().rows;
  const double closing = RowAge::kChoiceShare * contacts.model().largestNatural();
  const double odometer = contacts.age().odometer();
  const bool looked = forces.looksOfRebuild == contacts.rebuilds() && forces.looks.size() == rows.size();
  std::vector<Stiffest> parts((rows.size() + kLookGrain - 1) / kLookGrain);
  parallelFor(parts.size(), [&](std::size_t part) {
    const std::size_t end = std::min(rows.size(), (part + 1) * kLookGrain);
    for (auto r = static_cast<std::uint32_t>(part * kLookGrain); r < end; ++r) {
      const bool clear = looked && 2.0 * (forces.looks[r].clearUntil - odometer) > closing;
      if (clear && rows[r].firstCollider == rows[r].lastCollider) continue;
      raiseByRow(contacts, r, moment, parts[part]);
    }
  });
  Stiffest most;
  for (const Stiffest& part : parts) most.raise(part);
  const Stiffest surfaces = stiffestSurfaces(contacts.model(), contacts.surfaces(), moment);
  most.rateSquared += surfaces.rateSquared;
  most.damping += surfaces.damping;
  return most;
}

}  // namespace sim
