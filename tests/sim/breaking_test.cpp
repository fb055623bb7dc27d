#include <algorithm>
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/fracture/breakage.h"
#include "tests/support/spring_network.h"

namespace {

using sim::BondIndex;
using sim::NodeIndex;
using sim::Vec3;

double distanceOf(const sim::Simulation& simulation, NodeIndex a = 0, NodeIndex b = 1) {
  const sim::Snapshot snapshot = simulation.snapshot();
  return (snapshot.positions[b] - snapshot.positions[a]).norm();
}

/// A stretched spring between two nodes that breaks at once, and which far, feeble springs hold in one
/// fragment, so that contact has no part in what follows.
sim::Blueprint brokenWithinOneFragment(const tests::Pair& pair) {
  sim::Blueprint blueprint = tests::twoNodes(pair);
  blueprint.materials.push_back({.name = "thread"});
  for (const double height : {1e3, 1e3 + 1.0})
    blueprint.nodes.push_back({.position = Vec3(0.0, 0.0, height), .mass = 1.0});
  blueprint.bonds.push_back({2, 3, 1e-9, 1.0, 0.0, 1});
  for (const NodeIndex node : {0U, 1U}) {
    const double length = (blueprint.nodes[node].position - blueprint.nodes[2].position).norm();
    blueprint.bonds.push_back({node, 2, 1e-9, length, 0.0, 1});
  }
  return blueprint;
}

TEST_CASE("a broken bond never pulls, still pushes when shorter than its rest length, and damps only then") {
  // The oracle: the same leapfrog of the one distance, with the force of docs/numerics.md, Breaking 4.
  const double damping = GENERATE(0.0, 5.0);
  const double approach = GENERATE(30.0, -30.0);
  const tests::Pair pair{.damping = damping, .distance = 1.2, .approach = approach, .threshold = 0.1};
  constexpr double kStep = 2e-4;
  sim::Settings settings = tests::losslessSettings();
  settings.step = kStep;
  const auto broken = tests::simulation(brokenWithinOneFragment(pair), settings);
  double distance = pair.distance;
  double speed = -approach;
  double force = -(pair.stiffness * 0.2 + damping * speed);  // whole until the end of the first step
  for (int n = 0; n < 600; ++n) {
    speed += (n == 0 ? 0.5 : 1.0) * kStep * 2.0 * force / pair.mass;
    distance += kStep * speed;
    const double push = pair.stiffness * (pair.restLength - distance) - damping * speed;
    force = distance < pair.restLength ? std::max(0.0, push) : 0.0;
    REQUIRE(broken->stepOnce().ok());
    // The threads pull with 1e-9 dyn/cm; lengths of 1e3 are rounded to 1e-13.
    REQUIRE(distanceOf(*broken) == Approx(distance).margin(1e-9));
  }
  CHECK(broken->brokenBondCount() == 1);
  CHECK(broken->snapshot().fragments.size() == 1);
  if (approach > 0.0) CHECK(distance > pair.restLength);  // it was pushed out again
}

TEST_CASE("a broken bond pushes even after its nodes were long apart and far from where they broke") {
  sim::Blueprint blueprint = brokenWithinOneFragment({.distance = 1.2, .approach = -60.0, .threshold = 0.1});
  // Springs to a third node bring them back.
  blueprint.nodes.push_back({.position = Vec3(0.6, 0.0, -0.8), .mass = 5.0});
  for (const NodeIndex node : {0U, 1U}) blueprint.bonds.push_back({node, 4, 2000.0, 1.0, 0.0, 1});
  for (sim::Blueprint::Node& node : blueprint.nodes) node.velocity.y() += 15.0;
  // A floor so near that the rows of neighbours are rebuilt for it as all drift along it.
  sim::Environment environment = tests::earth();
  environment.gravity = Vec3::Zero();
  environment.colliders[0].position.z() = -2.4;
  sim::Settings settings = tests::losslessSettings();
  settings.step = 1e-4;
  const auto swing = tests::simulation(std::move(blueprint), settings, environment);
  double furthest = 0.0;
  double pushed = 0.0;
  for (int n = 0; n < 4000; ++n) {
    REQUIRE(swing->stepOnce().ok());
    furthest = std::max(furthest, distanceOf(*swing));
    if (distanceOf(*swing) < 0.95) pushed = std::max(pushed, swing->snapshot().ledger.energy.contact);
  }
  REQUIRE(furthest > 1.65);  // beyond the skin of the rows, 0.6 of the largest radius
  CHECK(pushed > 0.5 * 1000.0 * 0.05 * 0.05);
  // (omega h)^2 is 4e-5; a push that began late would show as energy out of nothing.
  const sim::Energy energy = swing->snapshot().ledger.energy;
  CHECK(swing->work().neighbourLists > 10);
  CHECK(std::abs(energy.residual) < 1e-3 * pushed);
}

TEST_CASE("contact takes over from a broken bond without loss or gain") {
  // The bond is 1 long, but contact begins at 0.5 only, the length of the nodes' other bonds: a handover in
  // compression would drop what the broken bond holds. The pair is fast enough to be in compression when the
  // rows are rebuilt, eight steps after the break.
  sim::Blueprint blueprint = tests::twoNodes({.distance = 1.101, .approach = 20.0, .threshold = 0.1});
  blueprint.materials.push_back({.name = "tail"});
  for (const NodeIndex node : {0U, 1U}) {
    sim::Blueprint::Node tail = blueprint.nodes[node];
    tail.position.z() = 0.5;
    blueprint.nodes.push_back(tail);
    blueprint.bonds.push_back({node, node + 2, 1000.0, 0.5, 0.0, 1});
  }
  sim::Settings settings = tests::losslessSettings();
  settings.step = 1e-3;
  const auto crash = tests::simulation(std::move(blueprint), settings);
  double most = 0.0;
  for (int n = 0; n < 100; ++n) {
    REQUIRE(crash->stepOnce().ok());
    const sim::Energy energy = crash->snapshot().ledger.energy;
    most = std::max(most, std::abs(energy.residual) / energy.mechanical());
  }
  CHECK(crash->brokenBondCount() == 1);
  CHECK(crash->snapshot().fragments.size() == 2);
  CHECK(most < 2e-3);  // (omega h)^2 / 8 and somewhat more, omega = 77 / s with the tails
}

TEST_CASE("bonds break by stretch only, never by compression") {
  const double strain = GENERATE(-0.5, 0.099, 0.101);
  const auto pair = tests::simulation(tests::twoNodes({.distance = 1.0 + strain, .threshold = 0.1}),
                                      tests::losslessSettings());
  REQUIRE(pair->stepOnce().ok());
  CHECK(pair->brokenBondCount() == (strain > 0.1 ? 1 : 0));
}

TEST_CASE("a break is told with its time, nodes, strain and cause") {
  const auto pair =
      tests::simulation(tests::twoNodes({.distance = 1.25, .threshold = 0.1}), tests::losslessSettings());
  REQUIRE(pair->stepOnce().ok());
  const auto events = pair->drainBreakEvents();
  REQUIRE(events.size() == 1);
  CHECK(events[0].time == 0.0);
  CHECK(events[0].a == 0);
  CHECK(events[0].b == 1);
  CHECK(events[0].strain == Approx(0.25));
  CHECK(events[0].cell == sim::kNone);
  CHECK(pair->drainBreakEvents().empty());
}

sim::Network variedChain(std::uint64_t seed) {
  sim::Blueprint blueprint = tests::chain(20001);
  blueprint.materials[0].thresholdMean = 0.01;
  blueprint.materials[0].thresholdSpread = 0.2;
  return tests::built(std::move(blueprint), seed);
}

TEST_CASE("thresholds scatter about their mean by the seed alone") {
  const sim::Network network = variedChain(5);
  const double count = static_cast<double>(network.bondCount());
  const double mean = std::accumulate(network.thresholds.begin(), network.thresholds.end(), 0.0) / count;
  double squares = 0.0;
  for (const float threshold : network.thresholds) squares += std::pow(threshold - mean, 2);
  // Standard errors: 0.2 / sqrt(20000) of the mean and 0.2 / sqrt(40000) of the spread; four of them. The cut
  // at three standard deviations lowers the spread by 0.3 % of itself.
  CHECK(mean == Approx(0.01).epsilon(4.0 * 0.2 / std::sqrt(count)));
  CHECK(std::sqrt(squares / count) == Approx(0.002).epsilon(0.003 + 4.0 / std::sqrt(2.0 * count)));
  CHECK(*std::min_element(network.thresholds.begin(), network.thresholds.end()) >= 0.0039F);

  CHECK(variedChain(5).thresholds == network.thresholds);
  CHECK(variedChain(6).thresholds != network.thresholds);
  // Neighbours know nothing of each other: four standard errors.
  double together = 0.0;
  for (std::size_t b = 1; b < network.bondCount(); ++b)
    together += (network.thresholds[b] - mean) * (network.thresholds[b - 1] - mean);
  CHECK(std::abs(together / squares) < 4.0 / std::sqrt(count));
}

/// Every whole bond of a body of cells has a whole cell, and no whole cell has a broken bond
/// (docs/numerics.md, Breaking 3).
void checkNoStrings(const sim::Network& network, const std::vector<std::uint8_t>& brokenBonds,
                    const std::vector<std::uint8_t>& brokenCells) {
  std::vector<std::uint8_t> hasWholeCell(network.bondCount(), 0);
  std::size_t wrong = 0;
  for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    if (brokenCells[cell] != 0) continue;
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t j = i + 1; j < 8; ++j) {
        const BondIndex bond = network.findBond(network.cells[cell][i], network.cells[cell][j]);
        if (bond == sim::kNone) continue;
        hasWholeCell[bond] = 1;
        if (brokenBonds[bond] != 0) ++wrong;
      }
    }
  }
  CHECK(wrong == 0);
  std::size_t strings = 0;
  for (BondIndex bond = 0; bond < network.bondCount(); ++bond) {
    if (brokenBonds[bond] == 0 && hasWholeCell[bond] == 0) ++strings;
  }
  CHECK(strings == 0);
}

TEST_CASE("a broken bond breaks its cells, and a bond without a whole cell breaks") {
  const sim::Network network = tests::built(tests::block({.nx = 1, .ny = 1, .nz = 3}));
  // The four middle cells' edges in a row of three cells: a lengthwise edge of the first cell is in it alone.
  const BondIndex edge = network.findBond(network.cells[0][0], network.cells[0][4]);
  REQUIRE(edge != sim::kNone);
  sim::Breakage breakage(network);
  std::vector<sim::BreakEvent> events;
  const auto strainOf = [](BondIndex) { return 0.5F; };
  breakage.breakBonds(std::vector<sim::Breakage::Overstretched>{{edge, 1.0F}}, 2.0, strainOf, events);
  CHECK(breakage.brokenCells() == std::vector<std::uint8_t>{1, 0, 0});
  // Of the first cell's 28 bonds the 6 of the face it shares with the second live on.
  CHECK(breakage.brokenBondCount() == 22);
  REQUIRE(events.size() == 22);
  CHECK(events[0].cell == sim::kNone);
  CHECK(std::all_of(events.begin() + 1, events.end(),
                    [](const sim::BreakEvent& event) { return event.cell == 0 && event.strain == 0.5F; }));
  checkNoStrings(network, breakage.brokenBonds(), breakage.brokenCells());

  // Breaking it again changes nothing.
  breakage.breakBonds(std::vector<sim::Breakage::Overstretched>{{edge, 1.0F}}, 3.0, strainOf, events);
  CHECK(events.size() == 22);
}

TEST_CASE("whichever bonds break, no strings are left") {
  const std::uint64_t seed = GENERATE(range(1, 9));
  const sim::Network network = tests::built(tests::block({.nx = 3, .ny = 4, .nz = 5}));
  sim::Breakage breakage(network);
  std::vector<sim::BreakEvent> events;
  for (int batch = 0; batch < 6; ++batch) {
    std::vector<sim::Breakage::Overstretched> over;
    for (std::uint64_t draw = 0; draw < 5; ++draw) {
      const double place = sim::uniformAt(seed, static_cast<std::uint64_t>(batch) * 10 + draw);
      over.push_back({static_cast<BondIndex>(place * static_cast<double>(network.bondCount())), 1.0F});
    }
    breakage.breakBonds(
        over, 0.0, [](BondIndex) { return 0.0F; }, events);
    checkNoStrings(network, breakage.brokenBonds(), breakage.brokenCells());
  }
  CHECK(events.size() == breakage.brokenBondCount());
  CHECK(breakage.brokenBondCount() > 100);
  const std::vector<std::uint8_t> cells = breakage.brokenCells();
  CHECK(breakage.brokenCellCount() ==
        static_cast<std::uint64_t>(std::count(cells.begin(), cells.end(), std::uint8_t{1})));
}

tests::Block brittle(double damping) {
  tests::Block shape{.nx = 3, .ny = 3, .nz = 8, .youngsModulus = 1e7, .dampingTime = damping};
  shape.material.thresholdMean = 0.01;
  shape.material.thresholdSpread = 0.3;
  return shape;
}

TEST_CASE("pulling a bar apart never raises the energy") {
  sim::Blueprint bar = tests::block(brittle(GENERATE(0.0, 1e-5)));
  for (sim::Blueprint::Node& node : bar.nodes) node.velocity.z() = 60.0 * (node.position.z() - 4.0);
  sim::Settings settings;
  settings.seed = GENERATE(1, 2);
  settings.threads = 1;
  const auto pulled = tests::simulation(std::move(bar), settings);
  tests::run(*pulled, 0.01);
  const sim::Snapshot snapshot = pulled->snapshot();
  CHECK(snapshot.fragments.size() > 1);
  CHECK(pulled->maxRise() < 0.005);
  checkNoStrings(pulled->network(), snapshot.broken->bonds, snapshot.broken->cells);
}

TEST_CASE("dropping a block hard never raises the energy") {
  tests::Block shape = brittle(GENERATE(0.0, 1e-5));
  shape.corner.z() = 0.05;
  shape.velocity = Vec3(30.0, 0.0, -400.0);
  sim::Settings settings;
  settings.seed = GENERATE(1, 2);
  settings.threads = 1;
  const auto dropped = tests::simulation(tests::block(shape), settings, tests::earth());
  tests::run(*dropped, 0.01);
  const sim::Snapshot snapshot = dropped->snapshot();
  CHECK(snapshot.fragments.size() > 3);
  CHECK(dropped->maxRise() < 0.005);
  checkNoStrings(dropped->network(), snapshot.broken->bonds, snapshot.broken->cells);
}

}  // namespace
