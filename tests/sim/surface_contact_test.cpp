#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>

#include "sim/contact/contact_forces.h"
#include "tests/support/spring_network.h"

/// Bodies that meet with their surfaces.
namespace {

using sim::Vec3;

/// Stiff enough that nothing sags by a hundredth of a cell.
tests::Block stiff(double cell, unsigned nx, unsigned ny, unsigned nz) {
  return {.nx = nx,
          .ny = ny,
          .nz = nz,
          .spacing = cell,
          .youngsModulus = 1e8,
          .dampingTime = 2e-5,
          .material = {.name = "stone"}};
}

void hold(sim::Blueprint& blueprint) {
  for (sim::Blueprint::Node& node : blueprint.nodes) node.mass = std::numeric_limits<double>::infinity();
}

/// A held table whose top is at z = 0, and on it, `above` over it, a block; seen by who stands on a slope of
/// so many degrees.
struct OnTable {
  tests::Block table;
  tests::Block block;
  double above = 0.02;  ///< cm
  double slope = 0.0;   ///< degrees
  sim::Settings settings = [] {
    sim::Settings made = tests::losslessSettings();
    made.contact.dampingRatio = 0.3;
    return made;
  }();

  std::unique_ptr<sim::Simulation> simulation() const {
    tests::Block lower = table;
    lower.corner = Vec3(-3.0, -1.5, -table.spacing * table.nz);
    sim::Blueprint blueprint = tests::block(lower);
    hold(blueprint);
    tests::Block upper = block;
    // Its nodes stand over nothing in particular.
    upper.corner = Vec3(0.13, 0.21, above);
    tests::append(blueprint, tests::block(upper));
    const double angle = slope / 180.0 * std::numbers::pi;
    sim::Environment environment;
    environment.gravity = 981.0 * Vec3(std::sin(angle), 0.0, -std::cos(angle));
    return tests::simulation(std::move(blueprint), settings, environment);
  }
};

double lowestOf(const sim::Simulation& simulation, std::size_t part) {
  const sim::Snapshot snapshot = simulation.snapshot();
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < snapshot.positions.size(); ++n) {
    if (simulation.network().nodeParts[n] == part) lowest = std::min(lowest, snapshot.positions[n].z());
  }
  return lowest;
}

double placeAlong(const sim::Simulation& simulation) {
  return simulation.snapshot().fragments[1].centre.x();
}

TEST_CASE("a block on another stands a few per cent of a cell above it, whatever the cells of both") {
  const auto [lower, upper] = GENERATE(std::pair{1.0, 1.0}, std::pair{1.0, 0.5}, std::pair{0.5, 1.0});
  INFO(lower << " " << upper);
  OnTable scene{
      .table = stiff(lower, static_cast<unsigned>(6.0 / lower), static_cast<unsigned>(4.0 / lower), 1),
      .block = stiff(upper, static_cast<unsigned>(2.0 / upper), static_cast<unsigned>(2.0 / upper),
                     static_cast<unsigned>(2.0 / upper)),
      .above = 0.1};
  scene.settings.contact.friction = 0.4;
  const auto run = scene.simulation();
  tests::run(*run, 0.4);
  const double gap = lowestOf(*run, 1);
  CHECK(gap > 0.0);
  CHECK(gap < 0.03 * std::min(lower, upper));
  CHECK(run->maxRise() < 0.005);
}

TEST_CASE("without friction a block slides down a slope that is a part as bodies do") {
  const double slope = GENERATE(5.0, 10.0);
  const double cell = GENERATE(1.0, 0.5);
  OnTable scene{.table = stiff(1.0, 24, 5, 1), .block = stiff(cell, 2, 2, 2), .slope = slope};
  const auto run = scene.simulation();
  const double start = placeAlong(*run);
  const double time = 0.4;
  tests::run(*run, time);
  const double fallen = 0.5 * 981.0 * std::sin(slope / 180.0 * std::numbers::pi) * time * time;
  // It lands from two hundredths of a centimetre, and nothing else holds it.
  CHECK(placeAlong(*run) - start == Approx(fallen).epsilon(0.01));
}

TEST_CASE("friction holds below its angle, and lets slide by what is left above it") {
  // The angle of friction 0.4 is 21.8 degrees.
  OnTable scene{.table = stiff(1.0, 20, 5, 1), .block = stiff(1.0, 2, 2, 2)};
  scene.settings.contact.friction = 0.4;
  SECTION("10 degrees") {
    scene.slope = 10.0;
    const auto run = scene.simulation();
    tests::run(*run, 0.2);
    const double landed = placeAlong(*run);
    tests::run(*run, 1.0);
    // Not a micrometre more.
    CHECK(std::abs(placeAlong(*run) - landed) < 1e-4);
  }
  SECTION("30 degrees") {
    scene.slope = 30.0;
    const auto run = scene.simulation();
    const double start = placeAlong(*run);
    const double time = 0.3;
    tests::run(*run, time);
    const double angle = scene.slope / 180.0 * std::numbers::pi;
    const double slid = 0.5 * 981.0 * (std::sin(angle) - 0.4 * std::cos(angle)) * time * time;
    CHECK(placeAlong(*run) - start == Approx(slid).epsilon(0.03));
    // What is not in its motion any more, friction took.
    const sim::LedgerRow row = run->snapshot().ledger;
    CHECK(std::abs(row.energy.residual) < 0.005 * row.energy.dissipated);
  }
}

TEST_CASE("a sheet stands with its edge on a block of larger cells") {
  tests::Block sheet = stiff(0.6, 3, 1, 3);
  OnTable scene{.table = stiff(1.0, 6, 4, 2), .block = sheet, .above = 0.1};
  const auto run = scene.simulation();
  double lowest = 1.0;
  while (run->time() < 0.1) {
    REQUIRE(run->stepOnce().ok());
    lowest = std::min(lowest, lowestOf(*run, 1));
  }
  CHECK(lowest > 0.0);
  CHECK(run->maxRise() < 0.005);
}

TEST_CASE("a soft block thrown at a thin sheet comes back from it") {
  const double speed = GENERATE(300.0, 500.0);
  INFO(speed);
  tests::Block sheet{.nx = 12, .ny = 12, .nz = 1, .spacing = 0.6, .youngsModulus = 1e7};
  sheet.corner = Vec3(-3.6, -3.6, -0.6);
  sheet.material = {.name = "rubber"};
  sim::Blueprint blueprint = tests::block(sheet);
  for (sim::Blueprint::Node& node : blueprint.nodes) {
    const double edge = std::max(std::abs(node.position.x()), std::abs(node.position.y()));
    if (edge > 3.5) node.mass = std::numeric_limits<double>::infinity();
  }
  tests::Block block{.nx = 3, .ny = 3, .nz = 3, .spacing = 0.6, .youngsModulus = 1e7};
  block.corner = Vec3(-0.8, -0.7, 0.1);
  block.velocity = Vec3(0.0, 0.0, -speed);
  block.material = {.name = "rubber"};
  tests::append(blueprint, tests::block(block));
  sim::Settings settings = tests::losslessSettings();
  settings.contact.friction = 0.4;
  const auto run = tests::simulation(std::move(blueprint), settings);
  tests::run(*run, 8.0 / speed);
  CHECK(run->snapshot().fragments[1].centre.z() > 1.0);
  CHECK(run->maxRise() < 0.005);
}

/// Two blocks that hit each other with their edges and corners, spinning.
std::unique_ptr<sim::Simulation> cornersMeet(int threads, double friction) {
  tests::Block shape{.nx = 3, .ny = 2, .nz = 3, .youngsModulus = 1e7};
  shape.material = {.name = "stuff"};
  sim::Blueprint blueprint = tests::block(shape);
  shape.spacing = 0.8;
  shape.corner = Vec3(1.7, 1.1, 3.1);
  shape.velocity = Vec3(-40.0, 10.0, -150.0);
  sim::Blueprint other = tests::block(shape);
  for (sim::Blueprint::Node& node : other.nodes)
    node.velocity += Vec3(3.0, 40.0, 20.0).cross(node.position - Vec3(2.9, 1.9, 4.3));
  tests::append(blueprint, other);
  sim::Settings settings = tests::losslessSettings();
  settings.threads = threads;
  settings.contact.friction = friction;
  settings.contact.dampingRatio = friction;
  return tests::simulation(std::move(blueprint), settings);
}

TEST_CASE("surfaces that meet keep the momentum, and give no energy") {
  const double friction = GENERATE(0.0, 0.4);
  const auto run = cornersMeet(1, friction);
  const sim::LedgerRow before = run->snapshot().ledger;
  tests::run(*run, 0.02);
  const sim::LedgerRow after = run->snapshot().ledger;
  // They did meet: each has something of the other's motion.
  CHECK(run->snapshot().fragments[0].velocity.z() < -10.0);
  const double scale = std::sqrt(2.0 * before.energy.kinetic * 40.0);
  CHECK((after.linearMomentum - before.linearMomentum).norm() < 1e-10 * scale);
  CHECK(run->maxRise() < 0.005);
  CHECK(std::abs(after.energy.residual) < 0.01 * before.energy.kinetic);
  CHECK((friction == 0.0 || after.energy.dissipated > 0.01 * before.energy.kinetic));
}

TEST_CASE("contacts of surfaces are the same for any number of threads, and when resumed") {
  const auto whole = cornersMeet(1, 0.4);
  tests::run(*whole, 0.003);
  REQUIRE(whole->snapshot().ledger.energy.contact > 0.0);
  const auto first = cornersMeet(3, 0.4);
  for (std::uint64_t n = 0; n < whole->stepCount() / 2; ++n) REQUIRE(first->stepOnce().ok());
  const auto resumed = cornersMeet(2, 0.4);
  REQUIRE(resumed->restore(first->checkpoint()).ok());
  tests::run(*resumed, 0.003);
  CHECK(resumed->stateHash() == whole->stateHash());
}

}  // namespace
