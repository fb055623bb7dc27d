#include "modeling/preflight/preflight.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "tests/modeling/table_scene.h"

namespace {

using modeling::Preflight;
using modeling::Scene;

modeling::BuiltScene builtOf(const Scene& scene) {
  auto built = modeling::build(scene, "");
  if (!built) FAIL(built.problem().line());
  return std::move(built).value();
}

Preflight flightOf(const Scene& scene, const modeling::BuiltScene& built) {
  auto flight = modeling::preflight(scene, built, 1);
  if (!flight) FAIL(flight.problem().line());
  return std::move(flight).value();
}

TEST_CASE("a pre-flight says how large and how long a run will be") {
  Scene scene = tests::tableScene(sim::Method::velocityVerlet);
  scene.output.duration = 0.5;
  const modeling::BuiltScene built = builtOf(scene);
  const Preflight flight = flightOf(scene, built);
  CHECK(flight.nodes == built.network.nodeCount());
  CHECK(flight.components == 2);
  CHECK(flight.brokenAtRestCount == 0);
  const double step = tests::started(scene, 1)->step();
  CHECK(flight.stableStep == step);
  CHECK(flight.step == step);
  // Nothing is driven, nor fast enough to matter; but what falls does so rigidly for a moment, with steps of
  // twice the length. It falls for less than a hundredth of the duration; until it touches, steps may be
  // longer by what contacts count.
  CHECK(flight.steps <= 0.5 / step + 1.0);
  CHECK(flight.steps > 0.97 * 0.5 / step);
  CHECK(flight.stepsPerSecond == Approx(flight.steps / 0.5));
  CHECK(flight.memoryBytes > 1'000'000);
  CHECK(flight.peakMemoryBytes >= flight.memoryBytes);
  CHECK(flight.frames == 13.0);
  CHECK(flight.wallSeconds == Approx(0.5 * flight.wallSecondsPerSecond).epsilon(0.01));
  CHECK(flight.takeBytes > 13.0 * 38.0 * static_cast<double>(flight.nodes));
  scene.solver.step.seconds = 1e-6;
  const Preflight fixed = flightOf(scene, builtOf(scene));
  CHECK(fixed.stableStep == step);
  CHECK(fixed.steps == 500000.0);
}

TEST_CASE("a pre-flight says what limits the step") {
  Scene scene = tests::tableScene(sim::Method::velocityVerlet);
  Scene alone = scene;
  alone.environment.colliders.clear();
  alone.solver.contact.between = false;
  CHECK(flightOf(alone, builtOf(alone)).stableStepLimit == sim::StepLimit::lattice);
  scene.environment.colliders[0].stiffness = 1e12;
  CHECK(flightOf(scene, builtOf(scene)).stableStepLimit == sim::StepLimit::contact);
  scene.environment.colliders[0].stiffness.reset();
  scene.solver.step.tolerance = 1e-7;
  CHECK(flightOf(scene, builtOf(scene)).stableStepLimit == sim::StepLimit::tolerance);
}

TEST_CASE("a pre-flight lists the worst cells, and bonds that would break at rest, the worst first") {
  const Scene scene = tests::tableScene(sim::Method::velocityVerlet);
  modeling::BuiltScene built = builtOf(scene);
  const Preflight sound = flightOf(scene, built);
  REQUIRE_FALSE(sound.worstCells.empty());
  CHECK(sound.worstCells.front().part == "vase");
  CHECK(std::ranges::is_sorted(sound.worstCells, {}, [](const modeling::PoorCell& cell) {
    return cell.scaledJacobian / cell.aspect;
  }));
  // A node of the vase is pulled out by a tenth of its bonds.
  const auto isOfVase = [&](sim::PartIndex part) { return built.network.partNames[part] == "vase"; };
  const auto node = static_cast<std::size_t>(std::ranges::find_if(built.network.nodeParts, isOfVase) -
                                             built.network.nodeParts.begin());
  built.network.positions[node].z() += 0.1;
  const Preflight pulled = flightOf(scene, built);
  REQUIRE(pulled.brokenAtRestCount > 0);
  REQUIRE(pulled.brokenAtRest.size() == std::min(pulled.brokenAtRestCount, Preflight::kMostListed));
  for (const modeling::BrokenAtRest& bond : pulled.brokenAtRest) {
    CHECK(bond.part == "vase");
    CHECK(bond.strain > bond.threshold);
    const bool touches =
        built.network.bondStart(bond.bond) == node || built.network.bondEnds[bond.bond] == node;
    CHECK(touches);
  }
}

TEST_CASE("a pre-flight can be stopped") {
  const Scene scene = tests::tableScene(sim::Method::velocityVerlet);
  const modeling::BuiltScene built = builtOf(scene);
  int asked = 0;
  CHECK_FALSE(modeling::preflight(scene, built, 1, [&] { return ++asked < 3; }).ok());
  CHECK(asked == 3);
}

}  // namespace
