#include "sim/skipping/sleeping.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/skipping/transitions.h"
#include "sim/world/forces.h"

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

struct RestLimits {
  double speed = 0.0;  ///< cm/s
  double time = 0.0;   ///< s
};

RestLimits restLimits(const World& world) {
  const double gravity = world.controls.gravity().norm();
  const double length = world.fragments.typicalLength;
  RestLimits limits;
  if (!(gravity > 0.0)) return limits;
  limits.speed = std::min(kRestOfFall * std::sqrt(gravity * length), kRestOfPeak * world.fragments.peakSpeed);
  limits.time = kRestTime * std::sqrt(length / gravity);
  return limits;
}

/// Plastic fragments that still yield are not at rest, however slowly they creep.
bool flows(const World& world, FragmentId fragment) {
  if (!world.layout.hasPlastic()) return false;
  const Network& network = world.network;
  for (const NodeIndex node : world.fragments.activity.nodesOf(fragment)) {
    for (BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      if (!world.breakage.bondBroken(bond) && std::abs(strainIn(world, world.now, bond)) >
                                                  network.materials[network.bond(bond).material].yieldStrain)
        return true;
    }
  }
  return false;
}

void wakeLeftBehind(World& world, const std::vector<FragmentSums>& sums, double time) {
  for (const FragmentNeighbours& pair : world.fragments.neighboursBefore) {
    if (std::ranges::binary_search(world.fragments.neighbours, pair, std::less<>())) continue;
    if (sums[pair.a].mass > kLightShare * sums[pair.b].mass) wakeIfAsleep(world, pair.b, time);
    if (sums[pair.b].mass > kLightShare * sums[pair.a].mass) wakeIfAsleep(world, pair.a, time);
  }
}

/// One for each pair of fragments, the fastest approach.
void mergePairs(std::vector<FragmentNeighbours>& neighbours) {
  std::ranges::stable_sort(neighbours, std::less<>());
  std::size_t kept = 0;
  for (const FragmentNeighbours& pair : neighbours) {
    if (kept > 0 && neighbours[kept - 1].samePair(pair)) {
      neighbours[kept - 1].approach = std::max(neighbours[kept - 1].approach, pair.approach);
    } else {
      neighbours[kept++] = pair;
    }
  }
  neighbours.resize(kept);
}

}  // namespace

void noteNeighbours(World& world, const std::vector<FragmentSums>& sums) {
  std::vector<FragmentNeighbours>& neighbours = world.fragments.neighbours;
  world.fragments.neighboursBefore.swap(neighbours);
  neighbours.clear();
  world.contacts.forEachNearPair([&](NodeIndex i, NodeIndex j) {
    FragmentId a = world.components.of(i);
    FragmentId b = world.components.of(j);
    if (a == b || !(sums[a].mass > 0.0) || !(sums[b].mass > 0.0)) return;
    const Vec3 from = world.now.position.get(i);
    const Vec3 to = world.now.position.get(j);
    const double approach = (sums[a].velocityAt(from) - sums[b].velocityAt(to)).dot((to - from).normalized());
    if (a > b) std::swap(a, b);
    neighbours.push_back({a, b, approach});
  });
  mergePairs(neighbours);
}

namespace {

/// Fragments that held nodes touch, or nearly, while they are moved: however slowly, it is a load.
std::vector<FragmentId> besideCarried(const World& world) {
  std::vector<FragmentId> beside;
  if (world.carried.empty()) return beside;
  const auto moves = [&](NodeIndex node) {
    return std::ranges::binary_search(world.carried, node) && !world.now.velocity.get(node).isZero(0.0);
  };
  world.contacts.forEachNearPair([&](NodeIndex i, NodeIndex j) {
    if (moves(i)) beside.push_back(world.components.of(j));
    if (moves(j)) beside.push_back(world.components.of(i));
  });
  std::ranges::sort(beside);
  beside.erase(std::ranges::unique(beside).begin(), beside.end());
  return beside;
}

}  // namespace

void fallAsleep(World& world, const std::vector<FragmentSums>& sums, double time) {
  std::vector<FragmentRecord>& records = world.fragments.records;
  const RestLimits limits = restLimits(world);
  std::vector<std::uint8_t> resting(records.size(), 0);
  for (FragmentId fragment = 0; fragment < records.size(); ++fragment) {
    if (world.fragments.activity.stateOf(fragment) == FragmentState::asleep) continue;
    const FragmentSums& sum = sums[fragment];
    const double most = limits.speed * limits.speed;
    const bool still =
        sum.rigidSpeedSquared() < most && sum.vibrationSquared() < kVibration * kVibration * most;
    FragmentRecord& record = records[fragment];
    if (!still) record.stillSince = time;
    resting[fragment] = record.skippable && time - record.stillSince > limits.time ? 1 : 0;
  }
  for (const auto& [a, b, approach] : world.fragments.neighbours) {
    if (speedGiven(sums[a].mass, sums[b].mass, approach) > limits.speed) resting[b] = 0;
    if (speedGiven(sums[b].mass, sums[a].mass, approach) > limits.speed) resting[a] = 0;
  }
  for (const FragmentId fragment : besideCarried(world)) resting[fragment] = 0;
  for (FragmentId fragment = 0; fragment < records.size(); ++fragment) {
    if (resting[fragment] != 0 && !flows(world, fragment))
      putToSleep(world, fragment, sums[fragment].kinetic);
  }
}

void wakeByContact(World& world, const std::vector<FragmentSums>& sums, double time) {
  if (!world.fragments.activity.any(FragmentState::asleep)) return;
  wakeLeftBehind(world, sums, time);
  for (const FragmentId fragment : besideCarried(world)) wakeIfAsleep(world, fragment, time);
  const double enough = kWake * restLimits(world).speed;
  for (const auto& [a, b, approach] : world.fragments.neighbours) {
    if (speedGiven(sums[a].mass, sums[b].mass, approach) > enough) wakeIfAsleep(world, b, time);
    if (speedGiven(sums[b].mass, sums[a].mass, approach) > enough) wakeIfAsleep(world, a, time);
  }
}

void wakeByColliders(World& world, double time) {
  if (!world.controls.anyMoved() || !world.fragments.activity.any(FragmentState::asleep)) return;
  world.contacts.forEachNearCollider([&](NodeIndex node, std::uint32_t collider) {
    if (world.controls.moved(collider)) wakeIfAsleep(world, world.components.of(node), time);
  });
  refreshStates(world);
}

}  // namespace sim
