#include "sim/skipping/transitions.h"

#include <algorithm>
#include <cmath>

#include "sim/skipping/bodies.h"

namespace sim {
namespace {

/// Reviews: no fragment waits longer to be looked at again.
constexpr std::uint32_t kLongestWait = 16;

std::uint64_t wholeBonds(const World& world, FragmentId fragment) {
  std::uint64_t count = 0;
  for (const NodeIndex node : world.fragments.activity.nodesOf(fragment)) {
    for (BondIndex bond = world.network.firstBond[node]; bond < world.network.firstBond[node + 1]; ++bond)
      count += world.breakage.bondBroken(bond) ? 0 : 1;
  }
  return count;
}

void setState(World& world, FragmentId fragment, FragmentState state) {
  FragmentMotions& fragments = world.fragments;
  FragmentRecord& record = fragments.records[fragment];
  const auto count = [&](FragmentState in) -> std::uint64_t& {
    return fragments.bonds[static_cast<std::size_t>(in)];
  };
  if (state == FragmentState::deforming) {
    count(fragments.activity.stateOf(fragment)) -= record.bonds;
  } else {
    record.bonds = wholeBonds(world, fragment);
    count(state) += record.bonds;
  }
  fragments.activity.set(fragment, state);
  fragments.changed = true;
}

}  // namespace

void waitLonger(FragmentRecord& record) {
  record.lastWait = static_cast<std::uint16_t>(std::clamp(2U * record.lastWait, 1U, kLongestWait));
  record.quietLooks = 0;
  record.wait = record.lastWait;
}

void holdNodes(World& world, std::span<const NodeIndex> nodes) {
  for (const NodeIndex node : nodes) {
    world.next.position.set(node, world.now.position.get(node));
    world.now.velocity.set(node, Vec3::Zero());
    world.next.velocity.set(node, Vec3::Zero());
    world.inverseMasses[node] = 0.0;
  }
}

void releaseNodes(World& world, std::span<const NodeIndex> nodes) {
  for (const NodeIndex node : nodes) {
    const double mass = world.network.masses[node];
    world.inverseMasses[node] = std::isfinite(mass) ? 1.0 / mass : 0.0;
  }
}

void makeRigid(World& world, RigidBody body) {
  double kinetic = -body.kineticEnergy();
  for (const NodeIndex node : body.nodes())
    kinetic += 0.5 * world.network.masses[node] * world.now.velocity.get(node).squaredNorm();
  world.ledger.addDissipated(std::max(0.0, kinetic));
  holdNodes(world, body.nodes());
  setState(world, body.fragment(), FragmentState::rigid);
  world.fragments.bodies.push_back(std::move(body));
}

void melt(World& world, const RigidBody& body, double time) {
  body.place(world.now.position);
  body.placeVelocities(world.now.velocity);
  releaseNodes(world, body.nodes());
  world.fragments.records[body.fragment()].stillSince = time;
  setState(world, body.fragment(), FragmentState::deforming);
}

void putToSleep(World& world, FragmentId fragment, double kineticEnergy) {
  FragmentMotions& fragments = world.fragments;
  world.ledger.addDissipated(kineticEnergy);
  if (fragments.activity.stateOf(fragment) == FragmentState::rigid) {
    const auto body = std::ranges::find(fragments.bodies, fragment, &RigidBody::fragment);
    body->place(world.now.position);
    fragments.bodies.erase(body);
    // Its bonds are counted again below.
    setState(world, fragment, FragmentState::deforming);
  }
  holdNodes(world, fragments.activity.nodesOf(fragment));
  setState(world, fragment, FragmentState::asleep);
}

void wake(World& world, FragmentId fragment, double time) {
  releaseNodes(world, world.fragments.activity.nodesOf(fragment));
  world.fragments.records[fragment].stillSince = time;
  setState(world, fragment, FragmentState::deforming);
}

void wakeIfAsleep(World& world, FragmentId fragment, double time) {
  if (world.fragments.activity.stateOf(fragment) == FragmentState::asleep) wake(world, fragment, time);
}

void wakeEverything(World& world, double time) {
  if (!world.fragments.activity.any(FragmentState::asleep)) return;
  for (FragmentId fragment = 0; fragment < world.fragments.records.size(); ++fragment)
    wakeIfAsleep(world, fragment, time);
  refreshStates(world);
}

void meltEverything(World& world, double time) {
  for (const RigidBody& body : world.fragments.bodies) melt(world, body, time);
  world.fragments.bodies.clear();
  refreshStates(world);
}

void meltFragments(World& world, std::span<const FragmentId> fragments, double time) {
  std::erase_if(world.fragments.bodies, [&](const RigidBody& body) {
    if (std::ranges::find(fragments, body.fragment()) == fragments.end()) return false;
    waitLonger(world.fragments.records[body.fragment()]);
    melt(world, body, time);
    return true;
  });
  placeTouched(world);
  refreshStates(world);
}

void refreshStates(World& world) {
  FragmentMotions& fragments = world.fragments;
  if (!fragments.changed) return;
  fragments.changed = false;
  fragments.activity.refresh(world.components);
  fragments.stillElastic.reset();
}

}  // namespace sim
