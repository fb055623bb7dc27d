#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "tests/support/spring_network.h"

namespace {

using sim::Interpolation;
using sim::TrackTarget;
using sim::Vec3;

sim::Track track(TrackTarget target, std::vector<sim::Track::Key> keys,
                 Interpolation interpolation = Interpolation::smooth, std::uint32_t object = sim::kNone) {
  sim::Track track;
  track.target = target;
  track.object = object;
  track.interpolation = interpolation;
  track.keys = std::move(keys);
  return track;
}

/// A scene, and how long it is watched. Each is a block of sound speed 1000 cm/s.
struct Scene {
  sim::Blueprint blueprint;
  sim::Settings settings = tests::losslessSettings();
  sim::Environment environment = tests::weightless();
  std::vector<sim::Track> tracks = {};
  double until = 0.03;
};

tests::Block soft() {
  return {.nx = 2, .ny = 2, .nz = 4, .youngsModulus = 1e6};
}

/// Stretched along its length, so that it swings.
sim::Blueprint swinging(const tests::Block& shape) {
  sim::Blueprint bar = tests::block(shape);
  for (sim::Blueprint::Node& node : bar.nodes) node.velocity.z() = 50.0 * (node.position.z() / 2.0 - 1.0);
  return bar;
}

/// The largest residual, relative to the most energy there was in motion, bonds and contacts.
struct Account {
  double worst = 0.0;
  sim::Energy end;
  double scale = 0.0;
};

/// With steps of 1/20 of the stable one (omega h = 0.1) over `finer`.
Account accountOf(const Scene& scene, double finer) {
  sim::Settings settings = scene.settings;
  settings.safety = 0.05;
  settings.step =
      tests::simulation(scene.blueprint, settings, scene.environment, scene.tracks)->step() / finer;
  const auto run = tests::simulation(scene.blueprint, settings, scene.environment, scene.tracks);
  Account account;
  for (int step = 1; run->time() < scene.until; ++step) {
    const sim::Status status = run->stepOnce();
    if (!status) FAIL(status.problem().line() << run->snapshot().ledger.energy.kinetic);
    if (step % static_cast<int>(4.0 * finer) != 0) continue;
    account.end = run->snapshot().ledger.energy;
    account.worst = std::max(account.worst, std::abs(account.end.residual));
    account.scale = std::max(account.scale, account.end.kinetic + account.end.elastic + account.end.contact);
  }
  account.worst /= account.scale;
  return account;
}

/// The account is wrong by little, and by a quarter of that with half the step: it is the error of Verlet,
/// which keeps an energy off by some (omega h)^2 / 8 of the stiffest motion's, and nothing was left out.
/// Contacts begin and end between steps, which makes the ratio uneven; so it is taken over two halvings, a
/// sixteenth, with a factor of two to spare.
void checkSecondOrder(const Scene& scene) {
  const Account coarse = accountOf(scene, 1.0);
  const Account fine = accountOf(scene, 4.0);
  CHECK(coarse.worst < 1e-3);
  CHECK(fine.worst < coarse.worst / 8.0);
}

TEST_CASE("the account of a free swing closes") {
  checkSecondOrder({.blueprint = swinging(soft())});
}

TEST_CASE("the account of dampers closes") {
  tests::Block shape = soft();
  shape.dampingTime = 1e-4;
  const Scene scene{.blueprint = swinging(shape)};
  checkSecondOrder(scene);
  const Account account = accountOf(scene, 1.0);
  CHECK(account.end.dissipated > 0.5 * account.scale);
}

TEST_CASE("the account of contacts closes, of damping and friction in them too") {
  Scene scene{.blueprint = tests::twoBlocks(soft(), 1.1, 60.0)};
  for (sim::Blueprint::Node& node : scene.blueprint.nodes)
    node.velocity.x() = 20.0 * (node.position.z() - 4.5);
  const double damping = GENERATE(0.0, 0.3);
  const double friction = GENERATE(0.0, 0.5);
  scene.settings.contact.kind = sim::ContactKind::nodes;
  scene.settings.contact.dampingRatio = damping;
  scene.settings.contact.friction = friction;
  checkSecondOrder(scene);
  CHECK((accountOf(scene, 1.0).end.dissipated > 0.0) == (damping + friction > 0.0));
}

TEST_CASE("the account of colliders closes, of damping and friction in them too") {
  tests::Block shape = soft();
  shape.corner.z() = 0.2;
  shape.velocity = Vec3(50.0, 0.0, -50.0);
  Scene scene{.blueprint = tests::block(shape), .environment = tests::earth()};
  const double damping = GENERATE(0.0, 0.3);
  const double friction = GENERATE(0.0, 0.5);
  scene.environment.colliders[0].dampingRatio = damping;
  scene.environment.colliders[0].friction = friction;
  checkSecondOrder(scene);
  CHECK((accountOf(scene, 1.0).end.dissipated > 0.0) == (damping + friction > 0.0));
}

TEST_CASE("the account of breaking closes, and breaking takes what the bonds held") {
  tests::Block shape = soft();
  shape.material.thresholdMean = 0.03;
  shape.material.thresholdSpread = 0.2;
  const Scene scene{.blueprint = swinging(shape)};
  checkSecondOrder(scene);
  const Account account = accountOf(scene, 1.0);
  CHECK(account.end.released > 0.2 * account.scale);
}

TEST_CASE("the account of plastic flow closes") {
  tests::Block shape = soft();
  shape.material.yieldStrain = 0.01;
  shape.material.flowRate = 1e3;
  const Scene scene{.blueprint = swinging(shape)};
  // Rest lengths flow before the kick, whose first half belongs to the lengths of before: first order.
  const Account coarse = accountOf(scene, 1.0);
  const Account fine = accountOf(scene, 4.0);
  CHECK(coarse.worst < 1e-2);
  CHECK(fine.worst < coarse.worst / 3.0);
  CHECK(coarse.end.dissipated > 0.5 * coarse.scale);
}

TEST_CASE("the account of gravity that varies closes") {
  const auto interpolation = GENERATE(Interpolation::step, Interpolation::linear, Interpolation::smooth);
  Scene scene{.blueprint = swinging(soft())};
  scene.tracks = {track(TrackTarget::gravity, {{0.0, Vec3(100.0, 0.0, 0.0)}, {0.01, Vec3(0.0, 0.0, -5000.0)}},
                        interpolation)};
  checkSecondOrder(scene);
  CHECK(std::abs(accountOf(scene, 1.0).end.outsideWork) > 1.0);
}

TEST_CASE("the account of stiffness that varies closes") {
  const auto interpolation = GENERATE(Interpolation::step, Interpolation::linear, Interpolation::smooth);
  Scene scene{.blueprint = swinging(soft())};
  // The leap in the middle of a swing, when bonds are stretched and moving. The stiffest omega h is 1.7 times
  // that of the other scenes.
  scene.tracks = {track(TrackTarget::stiffnessScale, {{0.005, Vec3::UnitX()}, {0.00777, 3.0 * Vec3::UnitX()}},
                        interpolation)};
  checkSecondOrder(scene);
  const Account account = accountOf(scene, 1.0);
  CHECK(account.end.outsideWork > 0.1 * account.scale);
}

TEST_CASE("the account of a moving collider closes") {
  Scene scene{.blueprint = tests::block(soft()), .environment = tests::earth()};
  scene.environment.gravity = Vec3::Zero();
  const bool lossy = GENERATE(false, true);
  if (!lossy) scene.environment.colliders[0].dampingRatio = scene.environment.colliders[0].friction = 0.0;
  scene.tracks = {track(TrackTarget::colliderPosition,
                        {{0.0, Vec3(0.0, 0.0, -0.2)}, {0.02, Vec3(0.5, 0.0, 1.0)}}, Interpolation::smooth,
                        0)};
  checkSecondOrder(scene);
  const Account account = accountOf(scene, 1.0);
  CHECK(account.end.outsideWork > 0.5 * account.scale);
  // Setting out as a rigid body, it loses rounding.
  CHECK((account.end.dissipated > 1e-12 * account.scale) == lossy);
}

TEST_CASE("the account of held nodes that move closes, through damping, breaking and contact") {
  // A bar pulled apart by its ends, with a second one in its way.
  tests::Block shape = soft();
  shape.dampingTime = GENERATE(0.0, 1e-4);
  const bool breaks = GENERATE(false, true);
  if (breaks) shape.material.thresholdMean = 0.05;
  Scene scene{.blueprint = tests::twoBlocks(shape, 1.1, 0.0)};
  for (sim::Blueprint::Node& node : scene.blueprint.nodes) {
    if (node.position.z() != 0.0 && node.position.z() != 4.0) continue;
    node.mass = std::numeric_limits<double>::infinity();
    node.velocity = Vec3(0.0, 10.0, node.position.z() > 0.0 ? 40.0 : -40.0);
  }
  scene.settings.contact.kind = sim::ContactKind::nodes;
  checkSecondOrder(scene);
  const Account account = accountOf(scene, 1.0);
  CHECK(account.end.outsideWork > 0.5 * account.scale);
  CHECK((account.end.released > 0.0) == breaks);
}

TEST_CASE("stiffness that comes back all at once gives what it holds and no more") {
  // Softened by two orders of magnitude and restored in one step, as in a sneeze: the automatic step shrinks
  // tenfold at that moment.
  sim::Settings settings = tests::losslessSettings();
  const auto sneeze =
      tests::simulation(swinging(soft()), settings, tests::weightless(),
                        {track(TrackTarget::stiffnessScale,
                               {{0.0, Vec3::UnitX()}, {0.001, 0.01 * Vec3::UnitX()}, {0.0213, Vec3::UnitX()}},
                               Interpolation::step)});
  tests::run(*sneeze, 0.04);
  const sim::Energy energy = sneeze->snapshot().ledger.energy;
  CHECK(energy.outsideWork > 0.0);
  // (omega h)^2 / 8 with omega h up to 1 is 12 % of the stiffest motion's energy, of which there is little.
  CHECK(std::abs(energy.residual) < 0.03 * energy.mechanical());
  CHECK(sneeze->maxRise() < 0.03);
}

TEST_CASE("gravity's energy and the momenta are those of the nodes") {
  tests::Block shape = soft();
  shape.velocity = Vec3(1.0, 2.0, 3.0);
  sim::Environment environment;
  const auto fall = tests::simulation(tests::block(shape), tests::losslessSettings(), environment);
  tests::run(*fall, 0.1);
  const sim::LedgerRow row = fall->snapshot().ledger;
  // Two by two by four cells of 1 g. Thrown up at 3 cm/s, it is lower by g t^2 / 2 - 3 t.
  const double time = fall->time();
  CHECK(row.energy.gravity == Approx(-16.0 * 981.0 * (0.5 * 981.0 * time * time - 3.0 * time)));
  CHECK((row.linearMomentum - 16.0 * Vec3(1.0, 2.0, 3.0 - 981.0 * time)).norm() < 1e-8);
  CHECK(std::abs(row.energy.residual) < 1e-9 * row.energy.kinetic);
}

}  // namespace
