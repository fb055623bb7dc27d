#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include <catch2/catch.hpp>

#include "sim/fragments/rigid_body.h"
#include "tests/support/spring_network.h"

// What is skipped (docs/numerics.md), and that the result stays what it is without.

namespace {

using sim::FragmentState;
using sim::Vec3;

sim::Material brittle() {
  sim::Material material{.name = "brittle"};
  material.thresholdMean = 0.1;
  return material;
}

/// A small block of something soft and well damped, so that it comes to rest soon.
tests::Block cube(double height, double speed = 0.0) {
  tests::Block block;
  block.youngsModulus = 1e6;
  block.dampingTime = 2e-3;
  block.material = brittle();
  block.corner = Vec3(0.0, 0.0, height);
  block.velocity = Vec3(0.0, 0.0, -speed);
  return block;
}

/// Two of it break at tens of metres a second.
tests::Block brittleBlock() {
  tests::Block block = cube(0.0);
  block.nx = block.ny = block.nz = 4;
  block.youngsModulus = 1e8;
  block.dampingTime = 5e-5;
  block.material.thresholdMean = 0.02;
  block.material.thresholdSpread = 0.2;
  return block;
}

sim::Settings withSkips(bool on) {
  sim::Settings settings;
  settings.threads = 1;
  settings.contact.dampingRatio = 0.8;
  settings.skip.sleep = settings.skip.rigid = on;
  return settings;
}

sim::Environment dampedFloor() {
  sim::Environment environment = tests::earth();
  environment.colliders[0].dampingRatio = 0.8;
  return environment;
}

std::size_t fragmentsThat(const sim::Simulation& simulation, FragmentState state) {
  const sim::Snapshot snapshot = simulation.snapshot();
  return static_cast<std::size_t>(std::count_if(snapshot.fragments.begin(), snapshot.fragments.end(),
                                                [&](const auto& f) { return f.state == state; }));
}

double furthestApart(const sim::Snapshot& one, const sim::Snapshot& other) {
  double most = 0.0;
  for (std::size_t n = 0; n < one.positions.size(); ++n)
    most = std::max(most, (one.positions[n] - other.positions[n]).norm());
  return most;
}

double furthestApart(const sim::Simulation& one, const sim::Simulation& other) {
  return furthestApart(one.snapshot(), other.snapshot());
}

/// The largest of the whole bonds of fragments in that state.
double strainOfPieces(const sim::Simulation& simulation, FragmentState state) {
  const sim::Network& network = simulation.network();
  const sim::Snapshot snapshot = simulation.snapshot();
  double most = 0.0;
  for (const sim::MovingFragment& fragment : snapshot.fragments) {
    if (fragment.state != state) continue;
    for (sim::BondIndex bond = 0; bond < network.bondCount(); ++bond) {
      const sim::NodeIndex a = network.bondStart(bond);
      if (snapshot.broken->bonds[bond] != 0 || snapshot.broken->fragmentOfNode[a] != fragment.id) continue;
      const double length = (snapshot.positions[network.bondEnds[bond]] - snapshot.positions[a]).norm();
      most = std::max(most, std::abs(length / network.bond(bond).restLength - 1.0));
    }
  }
  return most;
}

TEST_CASE("an undeformed body in flight is carried as a rigid one, and lands as if it had not been") {
  const tests::Block block = cube(4.0, 100.0);
  // The same step for both: nothing but contact limits that of a rigid one.
  const auto dropped = [&](bool skips) {
    sim::Settings settings = withSkips(skips);
    settings.step = 1e-5;
    return tests::simulation(tests::block(block), settings, dampedFloor());
  };
  const auto skipping = dropped(true);
  const auto full = dropped(false);
  // It reaches the floor at 0.0326 s.
  tests::run(*skipping, 0.02);
  tests::run(*full, 0.02);
  CHECK(fragmentsThat(*skipping, FragmentState::rigid) == 1);
  CHECK(skipping->work().bondsRigid > 0);
  CHECK(full->work().bondsRigid == 0);
  CHECK(skipping->work().bondsEvaluated < full->work().bondsEvaluated / 2);
  // Rounding only: the centre follows the same recurrence, and nothing turns.
  CHECK(furthestApart(*skipping, *full) < 1e-12);
  CHECK((skipping->snapshot().velocities[0] - full->snapshot().velocities[0]).norm() < 1e-9);
  tests::run(*skipping, 0.04);
  tests::run(*full, 0.04);
  CHECK(fragmentsThat(*skipping, FragmentState::rigid) == 0);
  CHECK(furthestApart(*skipping, *full) < 1e-9);
}

TEST_CASE("a rigid body in flight keeps momentum and angular momentum") {
  sim::Blueprint blueprint = tests::block({.nx = 1, .ny = 2, .nz = 4});
  const Vec3 spin(3.0, 20.0, 7.0);
  for (sim::Blueprint::Node& node : blueprint.nodes)
    node.velocity = Vec3(5.0, 1.0, 2.0) + spin.cross(node.position);
  const sim::Network network = tests::built(blueprint);
  sim::Motion motion{sim::NodeVectors(network.nodeCount()), sim::NodeVectors(network.nodeCount())};
  std::vector<sim::NodeIndex> nodes;
  for (sim::NodeIndex n = 0; n < network.nodeCount(); ++n) {
    nodes.push_back(n);
    motion.position.set(n, network.positions[n]);
    motion.velocity.set(n, network.velocities[n]);
  }
  const auto moments = [&] {
    std::pair<Vec3, Vec3> sum{Vec3::Zero(), Vec3::Zero()};
    for (const sim::NodeIndex n : nodes) {
      sum.first += network.masses[n] * motion.velocity.get(n);
      sum.second += network.masses[n] * motion.position.get(n).cross(motion.velocity.get(n));
    }
    return sum;
  };
  const auto before = moments();
  sim::RigidBody body(network, 0, nodes, motion);
  const double energy = body.kineticEnergy();
  for (int step = 0; step < 10000; ++step) body.drift(1e-4, body.velocity());
  body.place(motion.position);
  body.placeVelocities(motion.velocity);
  const auto after = moments();
  CHECK((after.first - before.first).norm() < 1e-12 * before.first.norm());
  CHECK((after.second - before.second).norm() < 1e-10 * before.second.norm());
  // Some four turns in 10,000 steps of 2e-3 rad: the midpoint rule is off by (2e-3)^2 times a few.
  CHECK(body.kineticEnergy() == Approx(energy).epsilon(1e-5));
  // Distances are kept.
  const double length = (network.positions[7] - network.positions[0]).norm();
  CHECK((motion.position.get(7) - motion.position.get(0)).norm() == Approx(length).epsilon(1e-12));
}

TEST_CASE("rigid pieces of a crash push each other by equal forces") {
  const tests::Block block = brittleBlock();
  sim::Settings settings = withSkips(true);
  // Friction between the centres of two nodes has a torque.
  settings.contact.friction = 0.0;
  const auto run = tests::simulation(tests::twoBlocks(block, 1.5, 1500.0), settings, tests::weightless());
  const sim::LedgerRow before = run->snapshot().ledger;
  const double scale = 0.5 * run->network().masses[0] * 8.0 * 125.0 * 1500.0;  // g cm/s
  tests::run(*run, 0.05);
  const sim::Snapshot after = run->snapshot();
  REQUIRE(run->brokenBondCount() > 100);
  REQUIRE(run->work().bondsRigid > 0);
  REQUIRE(fragmentsThat(*run, FragmentState::rigid) > 2);
  // Rounding of 10,000 steps; the torques of a pair are about the centres of two bodies, not about one point.
  CHECK((after.ledger.linearMomentum - before.linearMomentum).norm() < 1e-10 * scale);
  CHECK((after.ledger.angularMomentum - before.angularMomentum).norm() < 1e-6 * scale * 10.0);
  CHECK(run->maxRise() < 0.005);
}

TEST_CASE("pieces that stay strained go on as rigid bodies once they are still") {
  sim::Blueprint blueprint = tests::twoBlocks(brittleBlock(), 1.5, 3000.0);
  // Rest lengths that cannot all be had leave strain of the size of their differences in every piece: more
  // than the 5e-3 that are nothing to speak of.
  for (std::size_t bond = 0; bond < blueprint.bonds.size(); bond += 3)
    blueprint.bonds[bond].restLength *= 1.01;
  const auto run = tests::simulation(blueprint, withSkips(true), tests::weightless());
  tests::run(*run, 0.3);
  REQUIRE(run->brokenBondCount() > 100);
  CHECK(strainOfPieces(*run, FragmentState::rigid) > 6e-3);
  CHECK(fragmentsThat(*run, FragmentState::deforming) == 0);
  CHECK(run->maxRise() < 0.005);
}

TEST_CASE("the pieces of a crash come to rest, all of them, and then cost nothing") {
  // A hundredfold gravity, so that what flies off is soon back.
  sim::Environment environment = dampedFloor();
  environment.gravity *= 100.0;
  tests::Block block = brittleBlock();
  block.corner.z() = 1.0;
  block.velocity.z() = -2500.0;
  const auto run = tests::simulation(tests::block(block), withSkips(true), environment);
  tests::run(*run, 0.6);
  REQUIRE(run->brokenBondCount() > 100);
  const sim::Snapshot end = run->snapshot();
  CHECK(fragmentsThat(*run, FragmentState::asleep) == end.fragments.size());
  const sim::Work before = run->work();
  tests::run(*run, 1.0);
  CHECK(run->work().bondsEvaluated == before.bondsEvaluated);
  CHECK(run->work().contactPairs == before.contactPairs);
  CHECK(furthestApart(run->snapshot(), end) == 0.0);
}

TEST_CASE("what breaks off a held body is skipped like any other piece") {
  sim::Blueprint blueprint = tests::twoBlocks(brittleBlock(), 1.5, 3000.0);
  for (sim::Blueprint::Node& node : blueprint.nodes) {
    if (node.position.z() > 0.0) continue;
    node.mass = std::numeric_limits<double>::infinity();
    node.velocity = Vec3::Zero();
  }
  const auto run = tests::simulation(blueprint, withSkips(true), tests::weightless());
  tests::run(*run, 0.1);
  const sim::Snapshot end = run->snapshot();
  const std::size_t lower = end.positions.size() / 2;
  std::size_t skipped = 0;
  for (sim::NodeIndex node = 0; node < lower; ++node) {
    const auto piece =
        std::ranges::find(end.fragments, end.broken->fragmentOfNode[node], &sim::MovingFragment::id);
    REQUIRE(piece != end.fragments.end());
    if (piece->state == FragmentState::rigid) ++skipped;
    if (!std::isfinite(run->network().masses[node])) CHECK(piece->state == FragmentState::deforming);
  }
  CHECK(skipped > 0);
}

TEST_CASE("looking at a crash does not change it") {
  const auto crash = [] {
    return tests::simulation(tests::twoBlocks(brittleBlock(), 1.5, 3000.0), withSkips(true), dampedFloor());
  };
  const auto unseen = crash();
  const auto watched = crash();
  tests::run(*unseen, 0.05);
  REQUIRE(unseen->brokenBondCount() > 100);
  REQUIRE(unseen->work().bondsRigid > 0);
  while (watched->stepCount() < unseen->stepCount()) {
    REQUIRE(watched->stepOnce().ok());
    if (watched->stepCount() % 5 == 0) static_cast<void>(watched->snapshot());
  }
  CHECK(watched->brokenBondCount() == unseen->brokenBondCount());
  CHECK(watched->stateHash() == unseen->stateHash());
}

TEST_CASE("tests of bonds that cannot break and dampers of no strength are spared, and change no bit") {
  // Beside two that break, one that cannot and has no dampers; or that need not and hardly has.
  const auto crash = [](double threshold, double dampingTime) {
    sim::Blueprint blueprint = tests::twoBlocks(brittleBlock(), 1.5, 3000.0);
    tests::Block beside{
        .dampingTime = dampingTime, .corner = Vec3(0.0, 1.5, 30.0), .velocity = Vec3(0.0, 0.0, -3000.0)};
    beside.material.thresholdMean = threshold;
    tests::append(blueprint, tests::block(beside));
    // What may fly as a rigid body depends on thresholds.
    auto run = tests::simulation(blueprint, withSkips(false), dampedFloor());
    tests::run(*run, 0.01);
    return run;
  };
  const auto spared = crash(std::numeric_limits<double>::infinity(), 0.0);
  const auto computed = crash(1e30, 1e-300);
  REQUIRE(spared->brokenBondCount() > 100);
  CHECK(spared->work().bondsUntested > 0);
  CHECK(spared->work().bondsUndamped > 0);
  CHECK(computed->work().bondsUntested == 0);
  CHECK(computed->work().bondsUndamped == 0);
  CHECK(computed->stateHash() == spared->stateHash());
}

TEST_CASE("fragments are looked for, and energy accounted for, only where something may have changed") {
  const auto run =
      tests::simulation(tests::twoBlocks(brittleBlock(), 1.5, 3000.0), withSkips(true), dampedFloor());
  tests::run(*run, 0.01);
  REQUIRE(run->brokenBondCount() > 100);
  CHECK(run->work().labelings > 0);
  CHECK(run->work().labelingsSkipped > 0);
  CHECK(run->work().ledgersSkipped > 0);
  // What no step asked for is right all the same.
  const sim::Snapshot snapshot = run->snapshot();
  const sim::Network& network = run->network();
  std::vector<sim::NodeIndex> lowest(network.nodeCount());
  std::iota(lowest.begin(), lowest.end(), 0U);
  for (bool changed = true; changed;) {
    changed = false;
    for (sim::BondIndex bond = 0; bond < network.bondCount(); ++bond) {
      if (snapshot.broken->hasLostBond(bond)) continue;
      sim::NodeIndex& a = lowest[network.bondStart(bond)];
      sim::NodeIndex& b = lowest[network.bondEnds[bond]];
      changed = changed || a != b;
      a = b = std::min(a, b);
    }
  }
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node)
    CHECK(snapshot.broken->fragmentOfNode[node] == snapshot.broken->fragmentOfNode[lowest[node]]);
  const std::set<sim::NodeIndex> pieces(lowest.begin(), lowest.end());
  CHECK(snapshot.fragments.size() == pieces.size());
}

TEST_CASE("what rests sleeps where it lies, and costs nothing") {
  const auto skipping = tests::simulation(tests::block(cube(0.5)), withSkips(true), dampedFloor());
  const auto full = tests::simulation(tests::block(cube(0.5)), withSkips(false), dampedFloor());
  tests::run(*skipping, 1.0);
  tests::run(*full, 1.0);
  REQUIRE(fragmentsThat(*skipping, FragmentState::asleep) == 1);
  // It slept when slower than 0.05 sqrt(g h) = 1.6 cm/s for 0.06 s, so it was about 0.1 cm from where it
  // would end.
  CHECK(furthestApart(*skipping, *full) < 0.1);
  CHECK(skipping->maxRise() < 1e-3);
  const sim::Work before = skipping->work();
  const std::uint64_t steps = skipping->stepCount();
  tests::run(*skipping, 2.0);
  CHECK(skipping->work().bondsEvaluated == before.bondsEvaluated);
  CHECK(skipping->stepCount() > steps + 100);
  CHECK(skipping->time() == Approx(2.0).epsilon(1e-3));
}

TEST_CASE("when frames are asked for does not show in what sleeps or flies") {
  const auto whole = tests::simulation(tests::block(cube(3.0)), withSkips(true), dampedFloor());
  const auto frames = tests::simulation(tests::block(cube(3.0)), withSkips(true), dampedFloor());
  tests::run(*whole, 1.5);
  for (int frame = 1; frame <= 150; ++frame) {
    tests::run(*frames, 0.01 * frame);
    static_cast<void>(frames->snapshot());
  }
  REQUIRE(fragmentsThat(*whole, FragmentState::asleep) == 1);
  CHECK(whole->stepCount() == frames->stepCount());
  CHECK(whole->stateHash() == frames->stateHash());
  CHECK(whole->work().bondsRigid > 0);
}

TEST_CASE("a run that sleeps or flies resumes bit for bit, on any number of threads") {
  const double cut = GENERATE(0.02, 0.3, 1.0);
  sim::Settings settings = withSkips(true);
  const auto whole = tests::simulation(tests::twoBlocks(cube(3.0), 0.3, 20.0), settings, dampedFloor());
  tests::run(*whole, cut);
  const auto checkpoint = whole->checkpoint();
  settings.threads = 2;
  const auto resumed = tests::simulation(tests::twoBlocks(cube(3.0), 0.3, 20.0), settings, dampedFloor());
  REQUIRE(resumed->restore(checkpoint).ok());
  CHECK(resumed->checkpoint() == checkpoint);
  tests::run(*whole, 1.4);
  tests::run(*resumed, 1.4);
  CHECK(whole->stateHash() == resumed->stateHash());
  CHECK(fragmentsThat(*whole, FragmentState::asleep) == fragmentsThat(*resumed, FragmentState::asleep));
}

TEST_CASE("a change of gravity wakes the sleepers") {
  sim::Track track;
  track.target = sim::TrackTarget::gravityScale;
  track.interpolation = sim::Interpolation::step;
  track.keys = {{0.0, Vec3(1.0, 0.0, 0.0)}, {1.5, Vec3(-1.0, 0.0, 0.0)}};
  const auto run = tests::simulation(tests::block(cube(0.1)), withSkips(true), dampedFloor(), {track});
  tests::run(*run, 1.49);
  REQUIRE(fragmentsThat(*run, FragmentState::asleep) == 1);
  tests::run(*run, 1.6);
  // It falls upwards for 0.1 s: g t^2 / 2 = 4.9 cm.
  const sim::Snapshot snapshot = run->snapshot();
  CHECK(snapshot.fragments[0].state != FragmentState::asleep);
  CHECK(snapshot.fragments[0].boxMin.z() == Approx(4.9).margin(0.3));
}

TEST_CASE("a collider that comes along pushes a sleeper") {
  sim::Environment environment = dampedFloor();
  sim::Collider& ball = environment.colliders.emplace_back();
  ball.name = "ball";
  ball.shape = sim::SphereShape{1.0};
  sim::Track track;
  track.target = sim::TrackTarget::colliderPosition;
  track.object = 1;
  track.keys = {{1.0, Vec3(-6.0, 1.0, 1.0)}, {1.5, Vec3(4.0, 1.0, 1.0)}};
  const auto run = tests::simulation(tests::block(cube(0.1)), withSkips(true), environment, {track});
  tests::run(*run, 1.0);
  REQUIRE(fragmentsThat(*run, FragmentState::asleep) == 1);
  tests::run(*run, 1.5);
  CHECK(run->snapshot().fragments[0].boxMin.x() > 2.0);
}

TEST_CASE("what falls on a sleeper wakes it") {
  tests::Block block = cube(0.0);
  block.youngsModulus = 1e7;
  block.dampingTime = 5e-4;
  block.material = {.name = "tough"};
  sim::Blueprint blueprint = tests::block(block);
  block.corner = Vec3(0.0, 0.0, 100.0);
  tests::append(blueprint, tests::block(block));
  const auto run = tests::simulation(blueprint, withSkips(true), dampedFloor());
  // The second falls the 98 cm in 0.447 s.
  tests::run(*run, 0.43);
  REQUIRE(fragmentsThat(*run, FragmentState::asleep) == 1);
  REQUIRE(fragmentsThat(*run, FragmentState::rigid) == 1);
  const double before = run->snapshot().fragments[0].centre.z();
  // Sound crosses the two in a millisecond: a little later they are squeezed most.
  tests::run(*run, 0.4495);
  CHECK(fragmentsThat(*run, FragmentState::deforming) == 2);
  CHECK(run->snapshot().fragments[0].centre.z() < before - 0.1);
}

TEST_CASE("a body that rings is left to ring, and springs without cells are never skipped") {
  SECTION("a block that was let go stretched by a thousandth") {
    sim::Blueprint blueprint = tests::block({.youngsModulus = 1e6, .material = brittle()});
    for (sim::Blueprint::Node& node : blueprint.nodes) node.position *= 1.001;
    const auto run = tests::simulation(blueprint, withSkips(true), tests::weightless());
    tests::run(*run, 0.2);
    CHECK(run->work().bondsRigid == 0);
    CHECK(fragmentsThat(*run, FragmentState::deforming) == 1);
  }
  SECTION("a chain that lies on the floor") {
    sim::Blueprint blueprint = tests::chain(5, 1e5, 30.0);
    const auto run = tests::simulation(blueprint, withSkips(true), dampedFloor());
    tests::run(*run, 1.0);
    CHECK(run->work().bondsAsleep == 0);
    CHECK(run->work().bondsRigid == 0);
  }
}

}  // namespace
