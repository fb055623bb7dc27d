#include "sim/control/controls.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "tests/support/spring_network.h"

namespace {

using sim::Interpolation;
using sim::Track;
using sim::TrackTarget;
using sim::Vec3;

Track scalar(TrackTarget target, Interpolation interpolation, std::vector<std::pair<double, double>> keys,
             std::uint32_t object = sim::kNone) {
  Track track{.target = target, .object = object, .interpolation = interpolation, .keys = {}};
  for (const auto& [time, value] : keys) track.keys.push_back({time, Vec3(value, 0.0, 0.0)});
  return track;
}

constexpr double kStep = 1e-4;
constexpr double kGravity = 981.0;

sim::Settings fixedStep() {
  sim::Settings settings = tests::losslessSettings();
  settings.step = kStep;
  return settings;
}

sim::Blueprint stone() {
  sim::Blueprint blueprint;
  blueprint.materials = {{.name = "stone"}};
  blueprint.partNames = {"stone"};
  blueprint.nodes.push_back({.mass = 1.0});
  return blueprint;
}

double fallSpeed(const std::vector<Track>& tracks, double time) {
  const auto fall = tests::simulation(stone(), fixedStep(), sim::Environment{}, tracks);
  tests::run(*fall, time);
  return -fall->snapshot().velocities[0].z();
}

TEST_CASE("gravity acts as its tracks say: the speed gained is their integral") {
  // The integral from 0 to 0.4 of a scale that goes from 0 at 0.1 to 2 at 0.3: 0.2 by the ramp (linear and
  // smooth alike), 0.2 after it; by steps only the latter.
  const auto keys = std::vector<std::pair<double, double>>{{0.1, 0.0}, {0.3, 2.0}};
  // A step of the track falls on a step of the run: half a step's kick may be on either side.
  const double margin = kGravity * 2.0 * kStep;
  CHECK(fallSpeed({scalar(TrackTarget::gravityScale, Interpolation::linear, keys)}, 0.4) ==
        Approx(0.4 * kGravity).margin(margin));
  CHECK(fallSpeed({scalar(TrackTarget::gravityScale, Interpolation::smooth, keys)}, 0.4) ==
        Approx(0.4 * kGravity).margin(margin));
  CHECK(fallSpeed({scalar(TrackTarget::gravityScale, Interpolation::step, keys)}, 0.4) ==
        Approx(0.2 * kGravity).margin(margin));
  // Until its first key a track holds that key's value.
  CHECK(fallSpeed({scalar(TrackTarget::gravityScale, Interpolation::linear, keys)}, 0.1) == 0.0);
}

TEST_CASE("a gravity track replaces the environment's, and scales multiply it") {
  Track other{
      .target = TrackTarget::gravity, .object = sim::kNone, .interpolation = Interpolation::step, .keys = {}};
  other.keys = {{0.0, Vec3(100.0, 0.0, 0.0)}};
  const auto fall =
      tests::simulation(stone(), fixedStep(), sim::Environment{},
                        {other, scalar(TrackTarget::gravityScale, Interpolation::step, {{0.0, 3.0}}),
                         scalar(TrackTarget::gravityScale, Interpolation::step, {{0.0, 0.5}})});
  tests::run(*fall, 0.1);
  CHECK((fall->snapshot().velocities[0] - Vec3(15.0, 0.0, 0.0)).norm() < 1e-9);
}

/// Two pairs of nodes of two materials, each stretched by a tenth.
sim::Blueprint twoPairs() {
  sim::Blueprint pairs = tests::twoNodes({.damping = 1.0, .distance = 1.1});
  sim::Blueprint second = tests::twoNodes({.damping = 1.0, .distance = 1.1});
  for (sim::Blueprint::Node& node : second.nodes) node.position.z() += 100.0;
  tests::append(pairs, second);
  return pairs;
}

TEST_CASE("stiffness tracks scale the bonds of their material, or of all, from when they say") {
  const auto object = GENERATE(0U, 1U, sim::kNone);
  const auto scaled = tests::simulation(
      twoPairs(), fixedStep(), tests::weightless(),
      {scalar(TrackTarget::stiffnessScale, Interpolation::step, {{0.0, 1.0}, {10.5 * kStep, 0.25}}, object)});
  for (int n = 0; n < 10; ++n) REQUIRE(scaled->stepOnce().ok());
  const auto energyOf = [&](std::size_t pair, double stiffness) {
    const sim::Snapshot snapshot = scaled->snapshot();
    const double extension = (snapshot.positions[2 * pair + 1] - snapshot.positions[2 * pair]).norm() - 1.0;
    return 0.5 * stiffness * extension * extension;
  };
  CHECK(scaled->snapshot().ledger.energy.elastic == Approx(energyOf(0, 1000.0) + energyOf(1, 1000.0)));
  CHECK(scaled->snapshot().ledger.energy.outsideWork == 0.0);
  // The key falls into the eleventh step and is seen by the twelfth.
  for (int n = 0; n < 2; ++n) REQUIRE(scaled->stepOnce().ok());
  const double first = object == 1 ? 1000.0 : 250.0;
  const double second = object == 0 ? 1000.0 : 250.0;
  CHECK(scaled->snapshot().ledger.energy.elastic == Approx(energyOf(0, first) + energyOf(1, second)));
  CHECK(scaled->snapshot().ledger.energy.outsideWork < 0.0);
}

TEST_CASE("damping tracks scale what dampers take") {
  const auto dissipated = [](double scale) {
    const auto pair =
        tests::simulation(twoPairs(), fixedStep(), tests::weightless(),
                          {scalar(TrackTarget::dampingScale, Interpolation::linear, {{0.0, scale}})});
    tests::run(*pair, 0.01);
    return pair->snapshot().ledger.energy.dissipated;
  };
  CHECK(dissipated(0.0) == 0.0);
  // A tenth of critical takes little enough of the motion to be nearly in proportion.
  CHECK(dissipated(0.02) == Approx(2.0 * dissipated(0.01)).epsilon(0.01));
}

TEST_CASE("an automatic step follows the stiffness") {
  const auto sneeze = tests::simulation(
      tests::block({}), tests::losslessSettings(), tests::weightless(),
      {scalar(TrackTarget::stiffnessScale, Interpolation::step, {{0.0, 1.0}, {0.1, 0.01}, {0.2, 4.0}})});
  const double step = sneeze->step();
  tests::run(*sneeze, 0.11);
  CHECK(sneeze->step() == Approx(10.0 * step).epsilon(0.1));
  tests::run(*sneeze, 0.21);
  CHECK(sneeze->step() == Approx(0.5 * step).epsilon(0.1));
  CHECK(sneeze->time() >= 0.21);
}

TEST_CASE("colliders are where and as fast as their tracks say") {
  sim::Environment environment = tests::earth();
  environment.colliders[0].rotation = Eigen::AngleAxisd(M_PI / 2.0, Vec3::UnitX());
  Track shift{.target = TrackTarget::colliderPosition,
              .object = 0,
              .interpolation = Interpolation::linear,
              .keys = {}};
  shift.keys = {{1.0, Vec3(0.0, 0.0, 2.0)}, {2.0, Vec3(4.0, 0.0, 2.0)}};
  Track turn{.target = TrackTarget::colliderRotation,
             .object = 0,
             .interpolation = Interpolation::linear,
             .keys = {}};
  turn.keys = {{0.0, Vec3::Zero()}, {2.0, Vec3(0.0, 0.0, M_PI)}};
  const sim::Network network = tests::built(stone());
  sim::Controls controls(network, environment, {shift, turn});
  controls.moveTo(1.0);
  const sim::MovingCollider& collider = controls.colliders()[0];
  CHECK((collider.shape.position - Vec3(0.0, 0.0, 2.0)).norm() < 1e-12);
  CHECK((collider.velocity - Vec3(4.0, 0.0, 0.0)).norm() < 1e-12);
  CHECK((collider.angularVelocity - Vec3(0.0, 0.0, M_PI / 2.0)).norm() < 1e-12);
  // Its own turn by a right angle about x, then the track's by a right angle about z.
  CHECK((collider.shape.rotation * Vec3::UnitZ() - Vec3(1.0, 0.0, 0.0)).norm() < 1e-12);
  CHECK((collider.velocityAt(Vec3(0.0, 1.0, 2.0)) - Vec3(4.0 - M_PI / 2.0, 0.0, 0.0)).norm() < 1e-12);
  controls.moveTo(1.5);
  CHECK(collider.shape.position.x() == Approx(2.0));
  controls.moveTo(3.0);
  CHECK(controls.colliders()[0].velocity.norm() == 0.0);
}

TEST_CASE("a track that drives nothing is refused") {
  const auto target =
      GENERATE(TrackTarget::colliderPosition, TrackTarget::colliderRotation, TrackTarget::stiffnessScale);
  const auto created = sim::Simulation::create(tests::built(stone()), tests::weightless(),
                                               {scalar(target, Interpolation::step, {{0.0, 1.0}}, 5)},
                                               tests::losslessSettings());
  REQUIRE_FALSE(created.ok());
  CHECK(created.problem().place == "tracks[0]");
}

TEST_CASE("a track out of order or not finite is refused") {
  for (const auto& keys : {std::vector<std::pair<double, double>>{},
                           std::vector<std::pair<double, double>>{{1.0, 0.0}, {1.0, 1.0}},
                           std::vector<std::pair<double, double>>{{0.0, std::nan("")}},
                           std::vector<std::pair<double, double>>{{INFINITY, 1.0}}}) {
    const auto created = sim::Simulation::create(
        tests::built(stone()), tests::weightless(),
        {scalar(TrackTarget::gravityScale, Interpolation::linear, keys)}, tests::losslessSettings());
    CHECK_FALSE(created.ok());
  }
}

TEST_CASE("a step leaves nothing for the next that would not be found anew, also where the world leaps") {
  sim::Blueprint bar = tests::block({.nx = 3, .ny = 3, .nz = 12, .dampingTime = 1e-5});
  for (std::size_t i = 0; i < bar.nodes.size(); ++i) {
    const auto phase = static_cast<double>(i);
    bar.nodes[i].velocity = 20.0 * Vec3(std::sin(phase), std::cos(2.0 * phase), std::sin(3.0 * phase));
  }
  sim::Settings settings = tests::losslessSettings();
  const double step = tests::simulation(bar, settings, sim::Environment{}, {})->step();
  const std::vector<Track> tracks = {
      scalar(TrackTarget::gravityScale, Interpolation::step, {{0.0, 1.0}, {20.5 * step, 100.0}}),
      scalar(TrackTarget::stiffnessScale, Interpolation::step, {{0.0, 1.0}, {35.5 * step, 0.25}})};
  const auto onwards = tests::simulation(bar, settings, sim::Environment{}, tracks);
  // Taken back to where it is, a run knows nothing but its state.
  const auto anew = tests::simulation(bar, settings, sim::Environment{}, tracks);
  for (int n = 0; n < 60; ++n) {
    REQUIRE(onwards->stepOnce().ok());
    REQUIRE(anew->restore(anew->checkpoint()).ok());
    REQUIRE(anew->stepOnce().ok());
    REQUIRE(onwards->stateHash() == anew->stateHash());
  }
  CHECK(onwards->time() > 36.0 * step);
}

}  // namespace
