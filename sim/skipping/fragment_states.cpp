#include "sim/skipping/fragment_states.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

/// A fragment is at rest when the root mean square speed of its rigid motion has been below both, for so long
/// that it could have fallen: this share of sqrt(g h), ...
constexpr double kRestOfFall = 0.05;
/// ... this share of the highest root mean square speed the whole scene has had.
constexpr double kRestOfPeak = 5e-3;
/// A node that chatters between two contacts may go on: the vibration may be so many times as fast.
constexpr double kVibration = 3.0;
/// In units of sqrt(h / g). A fragment at the top of its flight is slow for sqrt(h / g) / 50 only.
constexpr double kRestTime = 2.0;
/// A sleeper wakes when what moves next to it could give it so many times the speed of rest.
constexpr double kWake = 2.0;
/// Neighbours lighter than this share do not wake a fragment by going away.
constexpr double kLightShare = 0.05;

/// What an elastic push of something that nears by `approach` gives to what it meets, cm/s: never more than
/// twice that, however heavy it is.
double speedGiven(double mass, double massMet, double approach) {
  return 2.0 * mass / (mass + massMet) * approach;
}

}  // namespace

FragmentStates::FragmentStates(const World& world, const SkipSettings& skip)
    : world_(world), skip_(skip), activity_(world.network, world.components) {
  double length = 0.0;
  for (const float radius : world.network.radii) length += static_cast<double>(radius);
  typicalLength_ = length / static_cast<double>(world.network.nodeCount());
  noteBirths(0.0);
  findSkippable();
}

bool FragmentStates::allAsleep() const {
  return noneDeforms() && bodies_.empty();
}

FragmentStates::RestLimits FragmentStates::restLimits() const {
  const double gravity = world_.controls.gravity().norm();
  RestLimits limits;
  if (!(gravity > 0.0)) return limits;
  limits.speed = std::min(kRestOfFall * std::sqrt(gravity * typicalLength_), kRestOfPeak * peakSpeed_);
  limits.time = kRestTime * std::sqrt(typicalLength_ / gravity);
  return limits;
}

void FragmentStates::noteBirths(double time) {
  activity_.noteBirths(world_.components);
  const std::size_t known = records_.size();
  records_.resize(world_.components.births().size());
  bool heldBroke = false;
  for (std::size_t fragment = known; fragment < records_.size(); ++fragment) {
    Record& record = records_[fragment];
    record.stillSince = time;
    const FragmentId parent = world_.components.births()[fragment].parent;
    if (parent == kNone) continue;
    record.past = records_[parent].past = Past::broken;
    record.skippable = records_[parent].skippable;
    // What broke off a held body may itself be free.
    heldBroke |= record.skippable == 0;
  }
  if (heldBroke) findSkippable();
}

void FragmentStates::findSkippable() {
  std::vector<std::uint8_t> solid(world_.network.partNames.size(), 0);
  for (const CellCorners& corners : world_.network.cells) solid[world_.network.nodeParts[corners[0]]] = 1;
  for (Record& record : records_) record.skippable = 1;
  for (NodeIndex node = 0; node < world_.network.nodeCount(); ++node) {
    const bool held = !std::isfinite(world_.network.masses[node]);
    if (held || solid[world_.network.nodeParts[node]] == 0)
      records_[world_.components.of(node)].skippable = 0;
  }
}

double FragmentStates::Sums::rigidSpeedSquared() const {
  return (momentum.squaredNorm() / mass + spin.dot(angularMomentum)) / mass;
}

/// Those of fragments that sleep have no motion, and those of rigid ones their kinetic energy and momentum.
std::vector<FragmentStates::Sums> FragmentStates::sumFragments() {
  const Network& network = world_.network;
  std::vector<Sums> sums(records_.size());
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const double mass = network.masses[node];
    if (!std::isfinite(mass)) continue;
    const Vec3 velocity = world_.now.velocity.get(node);
    Sums& sum = sums[world_.components.of(node)];
    sum.mass += mass;
    sum.centre += mass * world_.now.position.get(node);
    sum.momentum += mass * velocity;
    sum.kinetic += 0.5 * mass * velocity.squaredNorm();
  }
  for (Sums& sum : sums) {
    if (sum.mass > 0.0) sum.centre /= sum.mass;
  }
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const double mass = network.masses[node];
    if (!std::isfinite(mass) || !activity_.deforms(world_.components.of(node))) continue;
    Sums& sum = sums[world_.components.of(node)];
    const Vec3 arm = world_.now.position.get(node) - sum.centre;
    sum.angularMomentum += mass * arm.cross(world_.now.velocity.get(node));
    sum.inertia += mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
  }
  for (Sums& sum : sums) {
    if (sum.inertia.trace() > 0.0)
      sum.spin = sum.inertia.completeOrthogonalDecomposition().solve(sum.angularMomentum);
  }
  for (const RigidBody& body : bodies_) {
    Sums& sum = sums[body.fragment()];
    sum.kinetic = body.kineticEnergy();
    sum.centre = body.centre();
    sum.momentum = body.mass() * body.velocity();
    sum.spin = body.angularVelocity();
    sum.angularMomentum = body.angularMomentum();
  }
  double mass = 0.0;
  double energy = 0.0;
  for (const Sums& sum : sums) {
    mass += sum.mass;
    energy += sum.kinetic;
  }
  if (mass > 0.0) peakSpeed_ = std::max(peakSpeed_, std::sqrt(2.0 * energy / mass));
  return sums;
}

void FragmentStates::review(double time, double step) {
  time_ = time;
  reviewTime_ = static_cast<double>(kStepsPerReview) * step;
  activity_.listNodes(world_.components);
  const std::vector<Sums> sums = sumFragments();
  noteNeighbours(sums);
  noteTouching();
  if (skip_.sleep) {
    wakeByContact(sums);
    fallAsleep(sums);
  }
  if (skip_.rigid) freeze();
  apply();
}

void FragmentStates::noteNeighbours(const std::vector<Sums>& sums) {
  neighboursBefore_.swap(neighbours_);
  neighbours_.clear();
  world_.contacts.forEachNearPair([&](NodeIndex i, NodeIndex j) {
    FragmentId a = world_.components.of(i);
    FragmentId b = world_.components.of(j);
    if (a == b || !(sums[a].mass > 0.0) || !(sums[b].mass > 0.0)) return;
    const Vec3 from = world_.now.position.get(i);
    const Vec3 to = world_.now.position.get(j);
    const double approach = (sums[a].velocityAt(from) - sums[b].velocityAt(to)).dot((to - from).normalized());
    if (a > b) std::swap(a, b);
    neighbours_.push_back({a, b, approach});
  });
  std::ranges::stable_sort(neighbours_, std::less<>());
  std::size_t kept = 0;
  for (const Neighbours& pair : neighbours_) {
    if (kept > 0 && neighbours_[kept - 1].samePair(pair)) {
      neighbours_[kept - 1].approach = std::max(neighbours_[kept - 1].approach, pair.approach);
    } else {
      neighbours_[kept++] = pair;
    }
  }
  neighbours_.resize(kept);
}

/// What is still for long enough sleeps, unless something nears it that could move it.
void FragmentStates::fallAsleep(const std::vector<Sums>& sums) {
  const RestLimits limits = restLimits();
  std::vector<std::uint8_t> resting(records_.size(), 0);
  for (FragmentId fragment = 0; fragment < records_.size(); ++fragment) {
    if (activity_.stateOf(fragment) == FragmentState::asleep) continue;
    const Sums& sum = sums[fragment];
    const double most = limits.speed * limits.speed;
    const bool still =
        sum.rigidSpeedSquared() < most && sum.vibrationSquared() < kVibration * kVibration * most;
    if (!still) records_[fragment].stillSince = time_;
    resting[fragment] =
        records_[fragment].skippable && time_ - records_[fragment].stillSince > limits.time ? 1 : 0;
  }
  for (const auto& [a, b, approach] : neighbours_) {
    if (speedGiven(sums[a].mass, sums[b].mass, approach) > limits.speed) resting[b] = 0;
    if (speedGiven(sums[b].mass, sums[a].mass, approach) > limits.speed) resting[a] = 0;
  }
  for (FragmentId fragment = 0; fragment < records_.size(); ++fragment) {
    if (resting[fragment] != 0 && !flows(fragment)) putToSleep(fragment, sums[fragment].kinetic);
  }
}

double FragmentStates::strainOf(BondIndex bond) const {
  const NodeIndex a = world_.network.bondStart(bond);
  const NodeIndex b = world_.network.bondEnds[bond];
  const double length = (world_.now.position.get(b) - world_.now.position.get(a)).norm();
  return length / world_.layout.restLength(world_.network, bond) - 1.0;
}

/// Plastic fragments that still yield are not at rest, however slowly they creep.
bool FragmentStates::flows(FragmentId fragment) const {
  if (!world_.layout.hasPlastic()) return false;
  for (const NodeIndex node : activity_.nodesOf(fragment)) {
    for (BondIndex bond = world_.network.firstBond[node]; bond < world_.network.firstBond[node + 1]; ++bond) {
      if (!world_.breakage.bondBroken(bond) &&
          std::abs(strainOf(bond)) > world_.network.materials[world_.network.bond(bond).material].yieldStrain)
        return true;
    }
  }
  return false;
}

void FragmentStates::wakeIfAsleep(FragmentId fragment) {
  if (activity_.stateOf(fragment) == FragmentState::asleep) wake(fragment);
}

/// What nears a sleeper, and could give it more than the speed of rest, wakes it. So does what goes away from
/// it, since it may have held it up.
void FragmentStates::wakeByContact(const std::vector<Sums>& sums) {
  if (!activity_.any(FragmentState::asleep)) return;
  wakeLeftBehind(sums);
  const double enough = kWake * restLimits().speed;
  for (const auto& [a, b, approach] : neighbours_) {
    if (speedGiven(sums[a].mass, sums[b].mass, approach) > enough) wakeIfAsleep(b);
    if (speedGiven(sums[b].mass, sums[a].mass, approach) > enough) wakeIfAsleep(a);
  }
}

void FragmentStates::wakeLeftBehind(const std::vector<Sums>& sums) {
  for (const Neighbours& pair : neighboursBefore_) {
    if (std::ranges::binary_search(neighbours_, pair, std::less<>())) continue;
    if (sums[pair.a].mass > kLightShare * sums[pair.b].mass) wakeIfAsleep(pair.b);
    if (sums[pair.b].mass > kLightShare * sums[pair.a].mass) wakeIfAsleep(pair.a);
  }
}

void FragmentStates::wakeEverything(double time) {
  if (!activity_.any(FragmentState::asleep)) return;
  time_ = time;
  for (FragmentId fragment = 0; fragment < records_.size(); ++fragment) {
    if (activity_.stateOf(fragment) == FragmentState::asleep) wake(fragment);
  }
  apply();
}

void FragmentStates::noteColliders(double time) {
  if (!world_.controls.anyMoved() || !activity_.any(FragmentState::asleep)) return;
  time_ = time;
  world_.contacts.forEachNearCollider([&](NodeIndex node, std::uint32_t collider) {
    const FragmentId fragment = world_.components.of(node);
    if (world_.controls.moved(collider) && activity_.stateOf(fragment) == FragmentState::asleep)
      wake(fragment);
  });
  apply();
}

/// Takes a fragment's nodes out of the lattice: there they stand still.
void FragmentStates::hold(std::span<const NodeIndex> nodes) {
  for (const NodeIndex node : nodes) {
    world_.next.position.set(node, world_.now.position.get(node));
    world_.now.velocity.set(node, Vec3::Zero());
    world_.next.velocity.set(node, Vec3::Zero());
    world_.inverseMasses[node] = 0.0;
  }
}

void FragmentStates::release(std::span<const NodeIndex> nodes) {
  for (const NodeIndex node : nodes) {
    const double mass = world_.network.masses[node];
    world_.inverseMasses[node] = std::isfinite(mass) ? 1.0 / mass : 0.0;
  }
}

void FragmentStates::setState(FragmentId fragment, FragmentState state) {
  Record& record = records_[fragment];
  const auto count = [&](FragmentState in) -> std::uint64_t& { return bonds_[static_cast<std::size_t>(in)]; };
  if (state == FragmentState::deforming) {
    count(activity_.stateOf(fragment)) -= record.bonds;
  } else {
    record.bonds = wholeBonds(fragment);
    count(state) += record.bonds;
  }
  activity_.set(fragment, state);
  changed_ = true;
}

std::uint64_t FragmentStates::wholeBonds(FragmentId fragment) const {
  std::uint64_t count = 0;
  for (const NodeIndex node : activity_.nodesOf(fragment)) {
    for (BondIndex bond = world_.network.firstBond[node]; bond < world_.network.firstBond[node + 1]; ++bond)
      count += world_.breakage.bondBroken(bond) ? 0 : 1;
  }
  return count;
}

void FragmentStates::putToSleep(FragmentId fragment, double kineticEnergy) {
  world_.ledger.addDissipated(kineticEnergy);
  if (activity_.stateOf(fragment) == FragmentState::rigid) {
    const auto body = std::ranges::find(bodies_, fragment, &RigidBody::fragment);
    body->place(world_.now.position);
    bodies_.erase(body);
    // Its bonds are counted again in setState().
    setState(fragment, FragmentState::deforming);
  }
  hold(activity_.nodesOf(fragment));
  setState(fragment, FragmentState::asleep);
}

void FragmentStates::wake(FragmentId fragment) {
  release(activity_.nodesOf(fragment));
  records_[fragment].stillSince = time_;
  setState(fragment, FragmentState::deforming);
}

void FragmentStates::noteNewRows(double time) {
  time_ = time;
  noteTouching();
  if (activity_.any(FragmentState::asleep)) {
    const std::vector<Sums> sums = sumFragments();
    noteNeighbours(sums);
    wakeByContact(sums);
  }
  apply();
}

void FragmentStates::melt(std::span<const FragmentId> fragments, double time) {
  time_ = time;
  std::erase_if(bodies_, [&](const RigidBody& body) {
    if (std::ranges::find(fragments, body.fragment()) == fragments.end()) return false;
    waitLonger(records_[body.fragment()]);
    melt(body);
    return true;
  });
  placeTouched();
  apply();
}

void FragmentStates::meltEverything(double time) {
  time_ = time;
  for (const RigidBody& body : bodies_) melt(body);
  bodies_.clear();
  apply();
}

}  // namespace sim
