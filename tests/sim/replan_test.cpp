#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/support/spring_network.h"

// Plans that are made while a simulation runs, and colliders that come and go.

namespace {

using sim::FragmentState;
using sim::Interpolation;
using sim::Method;
using sim::Track;
using sim::TrackTarget;
using sim::Vec3;

Track scalar(TrackTarget target, std::vector<std::pair<double, double>> keys,
             Interpolation interpolation = Interpolation::step) {
  Track track{.target = target, .object = sim::kNone, .interpolation = interpolation, .keys = {}};
  for (const auto& [time, value] : keys) track.keys.push_back({time, Vec3(value, 0.0, 0.0)});
  return track;
}

/// A small block of something soft and well damped, so that it comes to rest soon.
sim::Blueprint cube(double height, double threshold = sim::kUnbreakable) {
  tests::Block block{.youngsModulus = 1e6, .dampingTime = 2e-3};
  block.material.thresholdMean = threshold;
  block.corner = Vec3(0.0, 0.0, height);
  return tests::block(block);
}

sim::Environment dampedFloor() {
  sim::Environment environment = tests::earth();
  environment.colliders[0].dampingRatio = 0.8;
  return environment;
}

sim::Settings settingsFor(Method method, int threads = 1) {
  sim::Settings settings;
  settings.threads = threads;
  settings.method = method;
  settings.contact.dampingRatio = 0.8;
  return settings;
}

sim::Collider ball(const Vec3& position, double from, double until) {
  sim::Collider ball;
  ball.name = "ball";
  ball.shape = sim::SphereShape{};
  ball.position = position;
  ball.activeFrom = from;
  ball.activeUntil = until;
  return ball;
}

bool asleep(const sim::Simulation& simulation) {
  const sim::Snapshot snapshot = simulation.snapshot();
  return std::ranges::all_of(snapshot.fragments,
                             [](const auto& f) { return f.state == FragmentState::asleep; });
}

TEST_CASE("tracks that change nothing leave every bit as it was") {
  const auto method = GENERATE(Method::velocityVerlet, Method::rungeKutta, Method::implicitMidpoint);
  Track gravity{.target = TrackTarget::gravity, .interpolation = Interpolation::step, .keys = {}};
  gravity.keys = {{0.0, dampedFloor().gravity}};
  const auto dropped = [&](const std::vector<Track>& tracks) {
    const auto run = tests::simulation(cube(0.02, 0.01), settingsFor(method), dampedFloor(), tracks);
    tests::run(*run, 0.02);
    return std::pair(run->stateHash(), run->stepCount());
  };
  const auto without = dropped({});
  CHECK(dropped({scalar(TrackTarget::gravityScale, {{0.0, 1.0}, {0.01, 1.0}}), gravity,
                 scalar(TrackTarget::stiffnessScale, {{0.0, 1.0}, {0.01, 1.0}}),
                 scalar(TrackTarget::dampingScale, {{0.0, 1.0}})}) == without);
  // Looked at in every step or so.
  std::vector<std::pair<double, double>> keys;
  for (int key = 0; key < 400; ++key) keys.emplace_back(5e-5 * key, 1.0);
  CHECK(dropped({scalar(TrackTarget::gravityScale, keys, Interpolation::linear)}) == without);
}

TEST_CASE("a collider that never acts leaves every bit as it was") {
  const auto method = GENERATE(Method::velocityVerlet, Method::rungeKutta);
  const bool onFloor = GENERATE(true, false);
  const auto dropped = [&](bool withBall) {
    sim::Environment environment = onFloor ? dampedFloor() : tests::weightless();
    std::vector<Track> tracks;
    if (withBall) {
      environment.colliders.push_back(ball(Vec3(1.0, 1.0, 1.0), 7.0, 8.0));
      tracks.push_back({.target = TrackTarget::colliderPosition,
                        .object = static_cast<std::uint32_t>(environment.colliders.size() - 1),
                        .keys = {{0.0, Vec3(1.0, 1.0, 1.0)}, {9.0, Vec3(2.0, 2.0, 2.0)}}});
    }
    const auto run = tests::simulation(cube(0.02), settingsFor(method), environment, tracks);
    tests::run(*run, method == Method::velocityVerlet ? 1.0 : 0.03);
    return std::pair(run->stateHash(), run->stepCount());
  };
  CHECK(dropped(true) == dropped(false));
}

TEST_CASE("a collider pushes while it acts, and its coming and going is work from outside") {
  const auto method = GENERATE(Method::velocityVerlet, Method::rungeKutta);
  sim::Environment environment = tests::weightless();
  environment.colliders.push_back(ball(Vec3(1.0, 1.0, -0.6), 0.01, 0.012));
  // Nothing is lost, so that the account can be judged.
  environment.colliders[0].dampingRatio = environment.colliders[0].friction = 0.0;
  sim::Settings settings = tests::losslessSettings();
  settings.method = method;
  settings.step = 2e-5;
  const auto run = tests::simulation(tests::block({.youngsModulus = 1e6}), settings, environment);
  tests::run(*run, 0.0099);
  CHECK(run->snapshot().ledger.energy.mechanical() < 1e-12);
  tests::run(*run, 0.011);
  const sim::Energy during = run->snapshot().ledger.energy;
  CHECK(during.contact > 0.0);
  CHECK(during.outsideWork > 0.0);
  CHECK(std::abs(during.residual) < 0.02 * during.outsideWork);
  tests::run(*run, 0.013);
  const sim::LedgerRow after = run->snapshot().ledger;
  CHECK(after.energy.contact == 0.0);
  CHECK(after.energy.outsideWork < during.outsideWork);
  CHECK(after.linearMomentum.z() > 0.0);
  CHECK(std::abs(after.energy.residual) < 0.02 * during.outsideWork);
  // Left alone it goes on as it is.
  tests::run(*run, 0.02);
  CHECK((run->snapshot().ledger.linearMomentum - after.linearMomentum).norm() <
        1e-9 * after.linearMomentum.norm());
}

TEST_CASE("a collider that comes near a sleeper wakes it") {
  sim::Environment environment = dampedFloor();
  const auto run = tests::simulation(cube(0.02), settingsFor(Method::velocityVerlet), environment);
  tests::run(*run, 1.0);
  REQUIRE(asleep(*run));
  // One that comes far away does not.
  environment.colliders.push_back(ball(Vec3(50.0, 0.0, 0.0), run->time(), 9.0));
  REQUIRE(run->replan(environment, {}).ok());
  REQUIRE(run->stepOnce().ok());
  CHECK(asleep(*run));
  environment.colliders.push_back(ball(Vec3(1.0, 1.0, 3.2), run->time(), 9.0));
  REQUIRE(run->replan(environment, {}).ok());
  CHECK(asleep(*run));
  REQUIRE(run->stepOnce().ok());
  CHECK_FALSE(asleep(*run));
}

TEST_CASE("nothing happens when plans change, until the next step") {
  sim::Environment environment = dampedFloor();
  const auto run = tests::simulation(cube(5.0), settingsFor(Method::velocityVerlet), environment);
  tests::run(*run, 0.01);
  const sim::LedgerRow before = run->snapshot().ledger;
  environment.gravity *= 2.0;
  REQUIRE(run->replan(environment, {scalar(TrackTarget::gravityScale, {{0.0, 3.0}})}).ok());
  CHECK(run->snapshot().ledger.energy.gravity == before.energy.gravity);
  REQUIRE(run->stepOnce().ok());
  const double fallen = run->snapshot().ledger.energy.gravity / before.energy.gravity;
  CHECK(fallen == Approx(6.0).epsilon(0.01));
  CHECK(run->snapshot().ledger.energy.outsideWork < 0.0);
}

TEST_CASE("what replaces a gravity track is the last one that has begun") {
  const auto gravityFrom = [](double time, double x) {
    return Track{.target = TrackTarget::gravity,
                 .interpolation = Interpolation::step,
                 .keys = {{time, Vec3(x, 0.0, 0.0)}}};
  };
  // A stone: x'' is 1 until 0.1 s, where the third begins, then 3 until 0.2 s, then 2.
  sim::Blueprint stone;
  stone.materials = {{.name = "stone"}};
  stone.partNames = {"stone"};
  stone.nodes.push_back({.mass = 1.0});
  sim::Settings settings = tests::losslessSettings();
  settings.step = 1e-4;
  const auto run = tests::simulation(stone, settings, tests::weightless(),
                                     {gravityFrom(0.05, 1.0), gravityFrom(0.1, 3.0), gravityFrom(0.2, 2.0)});
  tests::run(*run, 0.3);
  CHECK(run->snapshot().velocities[0].x() == Approx(0.1 + 0.3 + 0.2).margin(1e-3));
}

TEST_CASE("a rigid body keeps to its account of energy when gravity changes") {
  sim::Settings settings = settingsFor(Method::velocityVerlet);
  const auto run = tests::simulation(cube(1000.0), settings, tests::earth(),
                                     {scalar(TrackTarget::gravityScale, {{0.0, 1.0}, {0.5, 5.0}})});
  tests::run(*run, 1.0);
  REQUIRE(run->work().stepsRigid > 100);
  const sim::Energy energy = run->snapshot().ledger.energy;
  // Free fall is exact in leapfrog: rounding only.
  CHECK(std::abs(energy.residual) < 1e-9 * energy.kinetic);
}

TEST_CASE("plans that do not fit a run are refused, and change nothing") {
  sim::Environment environment = dampedFloor();
  const auto run = tests::simulation(cube(5.0), settingsFor(Method::velocityVerlet), environment);
  sim::Environment none = environment;
  none.colliders.clear();
  CHECK(run->replan(none, {}).problem().place == "environment.colliders[0]");
  sim::Environment other = environment;
  other.colliders[0].shape = sim::BoxShape{};
  CHECK(run->replan(other, {}).problem().place == "environment.colliders[0]");
  CHECK(run->replan(environment, {scalar(TrackTarget::stiffnessScale, {{0.0, -1.0}})}).problem().place ==
        "tracks[0]");
  tests::run(*run, 0.01);
  const auto alone = tests::simulation(cube(5.0), settingsFor(Method::velocityVerlet), environment);
  tests::run(*alone, 0.01);
  CHECK(run->stateHash() == alone->stateHash());
}

}  // namespace
