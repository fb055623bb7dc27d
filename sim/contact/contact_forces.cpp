#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/parallel.h"
#include "sim/contact/contacts.h"

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

Contacts::PairConstants Contacts::constantsOf(NodeIndex node, const Entry& entry) const {
  if (entry.brokenBond != kNone) {
    const BondClass& bond = network_->bond(entry.brokenBond);
    return {bond.stiffness, bond.damping};
  }
  const double stiffness = settings_.stiffnessScale *
                           static_cast<double>(std::min(nodeStiffness_[node], nodeStiffness_[entry.other]));
  const double reduced = 1.0 / (1.0 / network_->masses[node] + 1.0 / network_->masses[entry.other]);
  return {stiffness,
          std::isfinite(reduced) ? 2.0 * settings_.dampingRatio * std::sqrt(stiffness * reduced) : 0.0};
}

/// Tracks that soften a material soften its contacts too, so that they stay no stiffer than its bonds. A
/// broken bond keeps to its own material, or its energy would change as it breaks.
Contacts::PairConstants Contacts::scaled(const PairConstants& constants, NodeIndex node, const Entry& entry,
                                         const Moment& moment) const {
  if (!moment.scaled) return constants;
  const std::span<const MaterialNow> materials = moment.materials;
  const double scale = entry.brokenBond != kNone
                           ? materials[network_->bond(entry.brokenBond).material].stiffnessScale
                           : std::min(materials[network_->nodeMaterials[node]].stiffnessScale,
                                      materials[network_->nodeMaterials[entry.other]].stiffnessScale);
  return {scale * constants.stiffness, std::sqrt(scale) * constants.damping};
}

double Contacts::massShare(NodeIndex node, std::span<const RowLook> looks) const {
  return network_->masses[node] / std::max(1U, looks[rowOfNode_[node]].active);
}

void Contacts::settle(const Motion& motion) {
  std::size_t kept = 0;
  for (const auto& [row, entryIndex] : growing_) {
    Entry& entry = entries_[entryIndex];
    const NodeIndex node = rows_[row].node;
    const double squared = (motion.position.get(entry.other) - motion.position.get(node)).squaredNorm();
    const double natural = naturalLength(node, entry.other);
    if (squared >= entry.rho * entry.rho) entry.rho = std::min(natural, std::sqrt(squared));
    if (entry.rho < natural) growing_[kept++] = {row, entryIndex};
  }
  growing_.resize(kept);
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

void Contacts::prepare(const Moment& moment, Forces& forces) const {
  if (forces.total.size() == 0) {
    forces.total = NodeVectors(network_->nodeCount());
    forces.lossy = NodeVectors(network_->nodeCount());
  }
  clear(forces);
  const bool sameRows = forces.looksOfRebuild == rebuilds_ && forces.looks.size() == rows_.size();
  if (!sameRows) {
    forces.looksOfRebuild = rebuilds_;
    forces.looks.assign(rows_.size(), {});
    forces.inside.assign(nearColliders_.size(), {});
    forces.touching.resize(entries_.size());
  }
  if (sameRows && forces.watchedVersion == moment.awakeVersion && !forces.watched.empty()) return;
  forces.watchedVersion = moment.awakeVersion;
  forces.watched.clear();
  for (std::uint32_t row = 0; row < rows_.size(); ++row) {
    if (isAwake(rows_[row].node, moment)) forces.watched.push_back(row);
  }
}

/// Finds what touches in a row, and how long nothing can, if nothing does.
void Contacts::look(std::uint32_t index, const Moment& moment, Forces& forces) const {
  RowLook& found = forces.looks[index];
  if (odometer_ + moment.lead < found.clearUntil) return;
  const Row& row = rows_[index];
  const double* const x = moment.motion.position.axis(0);
  const double* const y = moment.motion.position.axis(1);
  const double* const z = moment.motion.position.axis(2);
  const Vec3 here(x[row.node], y[row.node], z[row.node]);
  double nearest = std::numeric_limits<double>::infinity();  // squared
  found = {.room = std::numeric_limits<double>::infinity()};
  for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
    const Entry& entry = entries_[e];
    const double dx = x[entry.other] - here.x();
    const double dy = y[entry.other] - here.y();
    const double dz = z[entry.other] - here.z();
    const double squared = dx * dx + dy * dy + dz * dz;
    nearest = std::min(nearest, squared);
    if (squared >= entry.rho * entry.rho) continue;
    forces.touching[row.firstEntry + found.touching++] = e;
    if (entry.brokenBond == kNone) ++found.active;
  }
  // Both nodes may come; of node and collider each has its own share of the odometer.
  double clearance = 0.5 * (std::sqrt(nearest) - static_cast<double>(row.reach));
  for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) {
    const Collider& collider = moment.colliders[nearColliders_[c]].shape;
    Intrusion& inside = forces.inside[c];
    inside = intrusion(collider, here, inside.nearest);
    const double depth = inside.depth;
    if (depth > 0.0) ++found.active;
    clearance = std::min(clearance, -depth);
    found.room = std::min(found.room, deepest(collider) - depth);
  }
  if (found.touching + found.active == 0) found.clearUntil = odometer_ + kSurely * clearance - moment.lead;
}

Contacts::Push Contacts::pairPush(NodeIndex node, const Entry& entry, const PairConstants& unscaled,
                                  const Moment& moment, std::span<const RowLook> looks) const {
  const Vec3 apart = moment.motion.position.get(entry.other) - moment.motion.position.get(node);
  const double squared = apart.squaredNorm();
  if (squared >= entry.rho * entry.rho || squared == 0.0) return {};
  const double distance = std::sqrt(squared);
  const Vec3 direction = apart / distance;
  const Vec3 relative = moment.motion.velocity.get(entry.other) - moment.motion.velocity.get(node);
  const double separating = relative.dot(direction);
  const PairConstants constants = scaled(unscaled, node, entry, moment);
  const double elastic = constants.stiffness * (entry.rho - distance);
  const double normal = std::max(0.0, elastic - constants.damping * separating);
  Push push{-normal * direction, (elastic - normal) * direction};
  if (entry.brokenBond == kNone && settings_.friction > 0.0) {
    const double give = isAwake(entry.other, moment) ? 1.0 / massShare(entry.other, looks) : 0.0;
    const double reduced = 1.0 / (1.0 / massShare(node, looks) + give);
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

Contacts::Push Contacts::colliderPush(NodeIndex node, const MovingCollider& collider, const Intrusion& inside,
                                      const Moment& moment, std::span<const RowLook> looks,
                                      ColliderWork& work) const {
  const Vec3 here = moment.motion.position.get(node);
  const double mass = network_->masses[node];
  if (inside.depth <= 0.0 || !std::isfinite(mass)) return {};
  const Vec3 carried = collider.velocityAt(here);
  const Vec3 relative = moment.motion.velocity.get(node) - carried;
  const double leaving = relative.dot(inside.normal);
  const double stiffness = colliderStiffness(node, collider.shape, moment.materials);
  const double elastic = stiffness * inside.depth;
  const double damping = 2.0 * collider.shape.dampingRatio * std::sqrt(stiffness * mass);
  const double normal = std::max(0.0, elastic - damping * leaving);
  const Vec3 friction = frictionForce(relative - leaving * inside.normal, collider.shape.friction * elastic,
                                      massShare(node, looks), moment.kick);
  const Push push{normal * inside.normal + friction, (normal - elastic) * inside.normal + friction};
  work.outside += push.total.dot(carried) * moment.kick;
  work.dissipated += push.lossy.dot(carried) * moment.kick;
  return push;
}

Contacts::ColliderWork Contacts::pushRow(std::uint32_t index, const Moment& moment, Forces& forces) const {
  const Row& row = rows_[index];
  const RowLook& found = forces.looks[index];
  Push sum;
  ColliderWork work;
  const auto add = [&](const Push& push) {
    sum.total += push.total;
    sum.lossy += push.lossy;
  };
  for (std::uint32_t t = 0; t < found.touching; ++t) {
    const std::uint32_t e = forces.touching[row.firstEntry + t];
    add(pairPush(row.node, entries_[e], constants_[e], moment, forces.looks));
  }
  for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c)
    add(colliderPush(row.node, moment.colliders[nearColliders_[c]], forces.inside[c], moment, forces.looks,
                     work));
  forces.total.set(row.node, sum.total);
  forces.lossy.set(row.node, sum.lossy);
  return work;
}

/// Broken since the last rebuild: few that touch, so one after the other.
void Contacts::pushFresh(const Moment& moment, Forces& forces) const {
  for (const BrokenPair& pair : fresh_) {
    const Entry entry{pair.restLength, pair.b, pair.bond};
    const Push push = pairPush(pair.a, entry, constantsOf(pair.a, entry), moment, {});
    if (push.total.isZero(0.0) && push.lossy.isZero(0.0)) continue;
    forces.touched[pair.a / kBlockNodes] = forces.touched[pair.b / kBlockNodes] = 1;
    forces.total.add(pair.a, push.total);
    forces.lossy.add(pair.a, push.lossy);
    forces.total.add(pair.b, -push.total);
    forces.lossy.add(pair.b, -push.lossy);
  }
}

Contacts::ColliderWork Contacts::computeForces(const Moment& moment, Forces& forces) const {
  prepare(moment, forces);
  const std::vector<std::uint32_t>& watched = forces.watched;
  parallelRanges(watched.size(), kLookGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t w = begin; w < end; ++w) look(watched[w], moment, forces);
  });
  forces.busy.clear();
  for (const std::uint32_t r : watched) {
    if (forces.looks[r].touching + forces.looks[r].active == 0) continue;
    forces.busy.push_back(r);
    forces.touched[rows_[r].node / kBlockNodes] = 1;
  }
  forces.work.resize(forces.busy.size());
  parallelRanges(forces.busy.size(), kPushGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) forces.work[b] = pushRow(forces.busy[b], moment, forces);
  });
  pushFresh(moment, forces);
  ColliderWork sum;
  for (const ColliderWork& work : forces.work) {
    sum.outside += work.outside;
    sum.dissipated += work.dissipated;
  }
  return sum;
}

std::vector<Contacts::NearCollider> Contacts::nearLimits(const Moment& moment, const Forces& forces,
                                                         double step, double steps) const {
  std::vector<NearCollider> near;
  if (!collidersEnd_) return near;
  for (const std::uint32_t r : forces.watched) {
    const Row& row = rows_[r];
    if (row.firstCollider == row.lastCollider) continue;
    const RowLook& found = forces.looks[r];
    // What pushes has been looked at just now; the others are clear by what is left of their clearance.
    const bool pushes = found.touching + found.active > 0;
    const double room = pushes ? found.room : found.clearUntil - odometer_;
    const std::size_t count = row.lastCollider - row.firstCollider;
    const std::span colliders(nearColliders_.data() + row.firstCollider, count);
    const std::span inside(forces.inside.data() + row.firstCollider, count);
    const Vec3 here = moment.motion.position.get(row.node);
    const Vec3 velocity = moment.motion.velocity.get(row.node);
    double fastest = 0.0;
    for (const std::uint32_t c : colliders)
      fastest = std::max(fastest, (velocity - moment.colliders[c].velocityAt(here)).norm());
    if (room < kForcesShare * colliderSkin_ + steps * step * fastest)
      near.push_back({row.node, colliders, inside});
  }
  return near;
}

double Contacts::energy(const Moment& moment) const {
  double sum = 0.0;
  for (const Row& row : rows_) {
    const Vec3 here = moment.motion.position.get(row.node);
    for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
      const Entry& entry = entries_[e];
      const double squared = (moment.motion.position.get(entry.other) - here).squaredNorm();
      if (squared >= entry.rho * entry.rho) continue;
      const double depth = entry.rho - std::sqrt(squared);
      sum += 0.5 * spring(scaled(constants_[e], row.node, entry, moment).stiffness, depth);
    }
    for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) {
      const Collider& collider = moment.colliders[nearColliders_[c]].shape;
      const double depth = intrusion(collider, here).depth;
      if (depth > 0.0) sum += spring(colliderStiffness(row.node, collider, moment.materials), depth);
    }
  }
  for (const BrokenPair& pair : fresh_) {
    const double depth =
        pair.restLength - (moment.motion.position.get(pair.b) - moment.motion.position.get(pair.a)).norm();
    if (depth <= 0.0) continue;
    const Entry entry{pair.restLength, pair.b, pair.bond};
    sum += spring(scaled(constantsOf(pair.a, entry), pair.a, entry, moment).stiffness, depth);
  }
  return sum;
}

/// What touches in a row, or may before the step is chosen again. Most rows are out of the question even if
/// all in them touched.
void Contacts::raiseByRow(std::uint32_t index, const Moment& moment, Stiffest& most) const {
  const Row& row = rows_[index];
  const double mass = network_->masses[row.node];
  if (!std::isfinite(mass)) return;
  double stiffness = 0.0;
  double damping = 0.0;
  for (std::uint32_t c = row.firstCollider; c < row.lastCollider; ++c) {
    const Collider& collider = moment.colliders[nearColliders_[c]].shape;
    const double k = colliderStiffness(row.node, collider, moment.materials);
    stiffness += k;
    damping += 2.0 * collider.dampingRatio * std::sqrt(k * mass);
  }
  const Stiffest& pairs = mostOfRow_[index];
  const Stiffest all{(stiffness + pairs.rateSquared) / mass, (damping + pairs.damping) / mass};
  if (!moment.scaled && most.covers(all)) return;
  const Vec3 here = moment.motion.position.get(row.node);
  const double closing = kChoiceShare * largestNatural_;
  for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
    const Entry& entry = entries_[e];
    const double reach = entry.rho + closing;
    if ((moment.motion.position.get(entry.other) - here).squaredNorm() > reach * reach) continue;
    const PairConstants constants = scaled(constants_[e], row.node, entry, moment);
    stiffness += 2.0 * constants.stiffness;
    damping += 2.0 * constants.damping;
  }
  most.raise({stiffness / mass, damping / mass});
}

Contacts::Stiffest Contacts::stiffest(const Moment& moment, const Forces& forces) const {
  const double closing = kChoiceShare * largestNatural_;
  const bool looked = forces.looksOfRebuild == rebuilds_ && forces.looks.size() == rows_.size();
  std::vector<Stiffest> parts((rows_.size() + kLookGrain - 1) / kLookGrain);
  parallelFor(parts.size(), [&](std::size_t part) {
    const std::size_t end = std::min(rows_.size(), (part + 1) * kLookGrain);
    for (auto r = static_cast<std::uint32_t>(part * kLookGrain); r < end; ++r) {
      const bool clear = looked && 2.0 * (forces.looks[r].clearUntil - odometer_) > closing;
      if (clear && rows_[r].firstCollider == rows_[r].lastCollider) continue;
      raiseByRow(r, moment, parts[part]);
    }
  });
  Stiffest most;
  for (const Stiffest& part : parts) most.raise(part);
  return most;
}

}  // namespace sim
