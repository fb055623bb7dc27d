#include <algorithm>

#include "sim/kernel/elastic_energy.h"
#include "sim/skipping/fragment_states.h"

// How rigid bodies move, and what a checkpoint holds.

namespace sim {

struct FragmentStates::Push {
  Vec3 force = Vec3::Zero();          ///< dyn
  Vec3 torque = Vec3::Zero();         ///< about the centre, dyn cm
  std::vector<std::uint32_t> places;  ///< in nodes(), of those pushed

  /// For another body.
  void clear() {
    force = torque = Vec3::Zero();
    places.clear();
  }
};

void FragmentStates::findPush(const RigidBody& body, const Contacts::Forces& forces, Push& push) {
  push.clear();
  for (const std::uint32_t place : body.touched()) {
    const NodeIndex node = body.nodes()[place];
    if (forces.touched[node / kBlockNodes] == 0) continue;
    const Vec3 force = forces.total.get(node);
    if (force.isZero(0.0)) continue;
    push.force += force;
    push.torque += body.arm(place).cross(force);
    push.places.push_back(place);
  }
}

/// As in the kernel: work against lossy forces is by the mean of the velocities before and after.
double FragmentStates::takeForces(const RigidBody& body, const Push& push, double kick,
                                  const RigidBody::Rates& before, const RigidBody::Rates& after,
                                  Contacts::Forces& forces) {
  double dissipated = 0.0;
  for (const std::uint32_t place : push.places) {
    const NodeIndex node = body.nodes()[place];
    const Vec3 arm = body.arm(place);
    dissipated -= 0.5 * kick * forces.lossy.get(node).dot(before.at(arm) + after.at(arm));
    forces.total.set(node, Vec3::Zero());
    forces.lossy.set(node, Vec3::Zero());
  }
  return dissipated;
}

double FragmentStates::moveBodies(double kick, double drift, bool byOldVelocity, Contacts::Forces& forces) {
  double dissipated = 0.0;
  Push push;
  for (RigidBody& body : bodies_) {
    const Vec3 old = body.velocity();
    findPush(body, forces, push);
    if (push.places.empty()) {
      body.kick(kick * world_.controls.gravity());
    } else {
      const RigidBody::Rates before = body.rates();
      body.kick(kick * (world_.controls.gravity() + push.force / body.mass()), kick * push.torque);
      dissipated += takeForces(body, push, kick, before, body.rates(), forces);
    }
    body.drift(drift, byOldVelocity ? old : body.velocity());
  }
  return dissipated;
}

bool FragmentStates::anyTouched() const {
  return std::ranges::any_of(bodies_, [](const RigidBody& body) { return !body.touched().empty(); });
}

void FragmentStates::placeTouched() {
  for (const RigidBody& body : bodies_) body.placeTouched(world_.now);
}

void FragmentStates::shiftVelocities(const Vec3& shift) {
  for (RigidBody& body : bodies_) body.kick(shift);
}

double FragmentStates::fastestBody() const {
  double fastest = 0.0;
  for (const RigidBody& body : bodies_) fastest = std::max(fastest, body.fastest());
  return fastest;
}

void FragmentStates::placeBodies() {
  for (const RigidBody& body : bodies_) body.place(world_.now.position);
}

std::vector<RigidBody::Rates> FragmentStates::ratesAfter(double kick, Contacts::Forces& forces,
                                                         double& dissipated) const {
  std::vector<RigidBody::Rates> rates;
  rates.reserve(bodies_.size());
  Push push;
  for (const RigidBody& body : bodies_) {
    findPush(body, forces, push);
    rates.push_back(
        body.ratesAfter(kick * (world_.controls.gravity() + push.force / body.mass()), kick * push.torque));
    dissipated += takeForces(body, push, kick, body.rates(), rates.back(), forces);
  }
  return rates;
}

void FragmentStates::placeVelocities(NodeVectors& velocities, std::span<const RigidBody::Rates> rates) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b) bodies_[b].placeVelocities(velocities, rates[b]);
}

double FragmentStates::stillElasticEnergy(KernelStep step) const {
  if (!stillElastic_) {
    step.awake = activity_.stillLanes().data();
    stillElastic_ = elasticEnergy(step, world_.layout.blockCount());
  }
  return *stillElastic_;
}

void FragmentStates::apply() {
  if (!changed_) return;
  changed_ = false;
  activity_.refresh(world_.components);
  stillElastic_.reset();
}

void FragmentStates::save(ByteWriter& writer) const {
  writer.putVector(activity_.states());
  writer.putVector(records_);
  writer.putVector(neighbours_);
  writer.put<std::uint64_t>(bodies_.size());
  for (const RigidBody& body : bodies_) body.save(writer);
  writer.put(peakSpeed_);
}

bool FragmentStates::read(ByteReader& reader, std::size_t nodes, std::size_t fragments, Saved& saved) {
  reader.readVector(saved.states);
  reader.readVector(saved.records);
  reader.readVector(saved.neighbours);
  std::uint64_t bodies = 0;
  reader.read(bodies);
  const auto known = [](FragmentState state) { return static_cast<std::size_t>(state) < kFragmentStates; };
  const auto rigid = std::ranges::count(saved.states, FragmentState::rigid);
  if (saved.states.size() != fragments || saved.records.size() != fragments ||
      !std::ranges::all_of(saved.neighbours,
                           [&](const Neighbours& n) { return n.a < fragments && n.b < fragments; }) ||
      bodies != static_cast<std::uint64_t>(rigid) || !std::ranges::all_of(saved.states, known))
    return reader.fail();
  saved.bodies.resize(static_cast<std::size_t>(bodies));
  for (RigidBody& body : saved.bodies) {
    if (!body.load(reader, nodes) || body.fragment() >= fragments ||
        saved.states[body.fragment()] != FragmentState::rigid)
      return reader.fail();
  }
  return reader.read(saved.peakSpeed);
}

void FragmentStates::restore(Saved saved) {
  records_ = std::move(saved.records);
  neighbours_ = std::move(saved.neighbours);
  bodies_ = std::move(saved.bodies);
  peakSpeed_ = saved.peakSpeed;
  activity_.restore(std::move(saved.states), world_.components);
  activity_.listNodes(world_.components);
  bonds_ = {};
  for (FragmentId fragment = 0; fragment < records_.size(); ++fragment) {
    release(activity_.nodesOf(fragment));
    if (activity_.deforms(fragment)) continue;
    bonds_[static_cast<std::size_t>(activity_.stateOf(fragment))] += records_[fragment].bonds;
    hold(activity_.nodesOf(fragment));
  }
  placeTouched();
  stillElastic_.reset();
}

void FragmentStates::takeOver(const FragmentStates& other) {
  restore({other.activity_.states(), other.records_, other.neighbours_, other.bodies_, other.peakSpeed_});
}

std::size_t FragmentStates::memoryBytes() const {
  std::size_t bytes = activity_.memoryBytes() + records_.capacity() * sizeof(Record) +
                      neighbours_.capacity() * sizeof(neighbours_[0]);
  for (const RigidBody& body : bodies_) bytes += body.memoryBytes();
  return bytes;
}

}  // namespace sim
