#include <algorithm>
#include <cmath>

#include "sim/base/parallel.h"
#include "sim/contact/contacts.h"

namespace sim {
namespace {

/// Rows a task takes at least: below, handing out costs more than the rows.
constexpr std::size_t kRowGrain = 256;

/// Pairs nearer than this, in natural lengths, may touch before the step is chosen again, and count in it.
constexpr double kNearShare = 1.1;

/// Friction force (P10): against the slip, friction * k * intrusion, but never more than stops it within the
/// step.
Vec3 frictionForce(const Vec3& slip, double limit, double massShare, double kick) {
  const double speed = slip.norm();
  if (!(speed > 0.0)) return Vec3::Zero();
  return -std::min(limit / speed, massShare / kick) * slip;
}

double spring(double stiffness, double intrusion) {
  return 0.5 * stiffness * intrusion * intrusion;
}

}  // namespace

/// Tracks that soften a material soften its contacts too, so that they stay no stiffer than its bonds. A
/// broken bond keeps to its own material, or its energy would change as it breaks.
double Contacts::pairScale(const Entry& entry, NodeIndex node, std::span<const MaterialNow> materials) const {
  if (entry.brokenBond != kNone) return materials[network_->bond(entry.brokenBond).material].stiffnessScale;
  const double own = materials[network_->nodeMaterials[node]].stiffnessScale;
  return std::min(own, materials[network_->nodeMaterials[entry.other]].stiffnessScale);
}

double Contacts::massShare(NodeIndex node) const {
  const std::uint32_t row = rowOfNode_[node];
  return network_->masses[node] / std::max(1U, rows_[row].active);
}

/// Lets rho grow while apart, and counts what pushes.
void Contacts::activate(Row& row, const Moment& moment) {
  row.active = 0;
  const Vec3 here = moment.motion.position.get(row.node);
  for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
    Entry& entry = entries_[e];
    if (entry.brokenBond != kNone) continue;
    const double distance = (moment.motion.position.get(entry.other) - here).norm();
    if (distance < entry.rho) {
      ++row.active;
    } else if (!moment.trial) {
      entry.rho = std::min(entry.natural, distance);
    }
  }
  for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) {
    if (intrusion(moment.colliders[nearColliders_[c]].shape, here).depth > 0.0) ++row.active;
  }
}

Contacts::Push Contacts::pairPush(const Row& row, const Entry& entry, const Moment& moment) const {
  const Vec3 apart = moment.motion.position.get(entry.other) - moment.motion.position.get(row.node);
  const double squared = apart.squaredNorm();
  if (squared >= entry.rho * entry.rho || squared == 0.0) return {};
  const double distance = std::sqrt(squared);
  const Vec3 direction = apart / distance;
  const Vec3 relative = moment.motion.velocity.get(entry.other) - moment.motion.velocity.get(row.node);
  const double separating = relative.dot(direction);
  const double scale = pairScale(entry, row.node, moment.materials);
  const double elastic = scale * entry.stiffness * (entry.rho - distance);
  const double normal = std::max(0.0, elastic - std::sqrt(scale) * entry.damping * separating);
  Push push{-normal * direction, (elastic - normal) * direction};
  if (entry.brokenBond == kNone && settings_.friction > 0.0) {
    const double reduced = 1.0 / (1.0 / massShare(row.node) + 1.0 / massShare(entry.other));
    const Vec3 slip = -(relative - separating * direction);
    const Vec3 friction = frictionForce(slip, settings_.friction * elastic, reduced, moment.kick);
    push.total += friction;
    push.lossy += friction;
  }
  return push;
}

double Contacts::colliderStiffness(NodeIndex node, const Collider& collider,
                                   std::span<const MaterialNow> materials) const {
  if (collider.stiffness) return *collider.stiffness;
  return settings_.stiffnessScale * static_cast<double>(nodeStiffness_[node]) *
         materials[network_->nodeMaterials[node]].stiffnessScale;
}

Contacts::Push Contacts::colliderPush(const Row& row, const MovingCollider& collider, const Moment& moment,
                                      ColliderWork& work) const {
  const Vec3 here = moment.motion.position.get(row.node);
  const Intrusion inside = intrusion(collider.shape, here);
  const double mass = network_->masses[row.node];
  if (inside.depth <= 0.0 || !std::isfinite(mass)) return {};
  const Vec3 carried = collider.velocityAt(here);
  const Vec3 relative = moment.motion.velocity.get(row.node) - carried;
  const double leaving = relative.dot(inside.normal);
  const double stiffness = colliderStiffness(row.node, collider.shape, moment.materials);
  const double elastic = stiffness * inside.depth;
  const double damping = 2.0 * collider.shape.dampingRatio * std::sqrt(stiffness * mass);
  const double normal = std::max(0.0, elastic - damping * leaving);
  const Vec3 friction = frictionForce(relative - leaving * inside.normal, collider.shape.friction * elastic,
                                      massShare(row.node), moment.kick);
  const Push push{normal * inside.normal + friction, (normal - elastic) * inside.normal + friction};
  work.outside += push.total.dot(carried) * moment.kick;
  work.dissipated += push.lossy.dot(carried) * moment.kick;
  return push;
}

Contacts::ColliderWork Contacts::pushRow(const Row& row, const Moment& moment, Forces& forces) const {
  Push sum;
  ColliderWork work;
  const auto add = [&](const Push& push) {
    sum.total += push.total;
    sum.lossy += push.lossy;
  };
  for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) add(pairPush(row, entries_[e], moment));
  for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) {
    add(colliderPush(row, moment.colliders[nearColliders_[c]], moment, work));
  }
  forces.total.set(row.node, sum.total);
  forces.lossy.set(row.node, sum.lossy);
  return work;
}

/// Broken since the last rebuild: few, so one after the other.
void Contacts::pushFresh(const Moment& moment, Forces& forces) const {
  for (const BrokenPair& pair : fresh_) {
    Entry entry = brokenEntry(pair);
    entry.other = pair.b;
    Row row;
    row.node = pair.a;
    const Push push = pairPush(row, entry, moment);
    forces.total.add(pair.a, push.total);
    forces.lossy.add(pair.a, push.lossy);
    forces.total.add(pair.b, -push.total);
    forces.lossy.add(pair.b, -push.lossy);
  }
}

void Contacts::clear(Forces& forces) {
  for (std::size_t block = 0; block < forces.touched.size(); ++block) {
    if (forces.touched[block] == 0) continue;
    forces.touched[block] = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      std::fill_n(forces.total.axis(k) + block * kBlockNodes, kBlockNodes, 0.0);
      std::fill_n(forces.lossy.axis(k) + block * kBlockNodes, kBlockNodes, 0.0);
    }
  }
}

Contacts::ColliderWork Contacts::computeForces(const Moment& moment, Forces& forces) {
  clear(forces);
  for (const Row& row : rows_) forces.touched[row.node / kBlockNodes] = 1;
  for (const BrokenPair& pair : fresh_)
    forces.touched[pair.a / kBlockNodes] = forces.touched[pair.b / kBlockNodes] = 1;
  rowWork_.resize(rows_.size());
  const auto overRows = [&](auto&& work) {
    parallelRanges(rows_.size(), kRowGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) work(r);
    });
  };
  overRows([&](std::size_t r) { activate(rows_[r], moment); });
  overRows([&](std::size_t r) { rowWork_[r] = pushRow(rows_[r], moment, forces); });
  pushFresh(moment, forces);
  ColliderWork sum;
  for (const ColliderWork& work : rowWork_) {
    sum.outside += work.outside;
    sum.dissipated += work.dissipated;
  }
  return sum;
}

double Contacts::energy(const Moment& moment) const {
  double sum = 0.0;
  for (const Row& row : rows_) {
    const Vec3 here = moment.motion.position.get(row.node);
    for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
      const Entry& entry = entries_[e];
      const double depth = entry.rho - (moment.motion.position.get(entry.other) - here).norm();
      if (depth > 0.0)
        sum += 0.5 * spring(pairScale(entry, row.node, moment.materials) * entry.stiffness, depth);
    }
    for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) {
      const Collider& collider = moment.colliders[nearColliders_[c]].shape;
      const double depth = intrusion(collider, here).depth;
      if (depth > 0.0) sum += spring(colliderStiffness(row.node, collider, moment.materials), depth);
    }
  }
  for (const BrokenPair& pair : fresh_) {
    Entry entry = brokenEntry(pair);
    entry.other = pair.b;
    const double depth =
        pair.restLength - (moment.motion.position.get(pair.b) - moment.motion.position.get(pair.a)).norm();
    if (depth > 0.0) sum += spring(pairScale(entry, pair.a, moment.materials) * entry.stiffness, depth);
  }
  return sum;
}

Contacts::Stiffest Contacts::stiffest(const Moment& moment) const {
  Stiffest most;
  for (const Row& row : rows_) {
    const double mass = network_->masses[row.node];
    if (!std::isfinite(mass)) continue;
    const Vec3 here = moment.motion.position.get(row.node);
    double stiffness = 0.0;
    double damping = 0.0;
    for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
      const Entry& entry = entries_[e];
      const double distance = (moment.motion.position.get(entry.other) - here).norm();
      if (distance > kNearShare * entry.rho) continue;
      const double scale = pairScale(entry, row.node, moment.materials);
      stiffness += 2.0 * scale * entry.stiffness;
      damping += 2.0 * std::sqrt(scale) * entry.damping;
    }
    for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) {
      const Collider& collider = moment.colliders[nearColliders_[c]].shape;
      const double k = colliderStiffness(row.node, collider, moment.materials);
      stiffness += k;
      damping += 2.0 * collider.dampingRatio * std::sqrt(k * mass);
    }
    most.rateSquared = std::max(most.rateSquared, stiffness / mass);
    most.damping = std::max(most.damping, damping / mass);
  }
  return most;
}

}  // namespace sim
