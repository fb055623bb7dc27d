// How long a step may be, by numbers alone: no network, no world.

#include "sim/methods/step_length.h"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

namespace {

using sim::Method;
using sim::StepLength;
using sim::StepLimit;

/// A thousand radians a second.
sim::Spectrum swinging() {
  sim::Spectrum spectrum;
  spectrum.highestFrequency = 1000.0;
  return spectrum;
}

sim::Settings verlet() {
  sim::Settings settings;
  settings.method = Method::velocityVerlet;
  settings.safety = 0.5;
  return settings;
}

TEST_CASE("an undamped lattice sets the step to the safety's share of 2 / omega") {
  StepLength length(verlet(), swinging());
  const double step = length.choose({}, 0.0);
  CHECK(step == Approx(0.5 * 2.0 / 1000.0));
  CHECK(length.limit(1.0, 1.0, step) == StepLimit::lattice);
  // Four times as stiff, twice as fast.
  CHECK(length.choose({.stiffnessScale = 4.0}, step) == Approx(0.5 * step));
}

TEST_CASE("contacts shorten the step, and are named as what limits it") {
  StepLength length(verlet(), swinging());
  const double step = length.choose({.contactRateSquared = 3e6}, 0.0);
  CHECK(step == Approx(0.5 * 2.0 / 2000.0));
  CHECK(length.limit(1.0, 1.0, step) == StepLimit::contact);
}

TEST_CASE("no node goes further in a step than it may") {
  StepLength length(verlet(), swinging());
  CHECK(length.choose({.speed = 1e4, .longestTravel = 0.25}, 0.0) == Approx(2.5e-5));
}

TEST_CASE("a step shrinks at once and grows only by more than a tenth") {
  StepLength length(verlet(), swinging());
  const double step = 1e-3;
  CHECK(length.choose({.stiffnessScale = 1.01}, step) < step);
  CHECK(length.choose({.stiffnessScale = 1.0 / 1.18}, step) == step);
  CHECK(length.choose({.stiffnessScale = 1.0 / 1.3}, step) == Approx(step * std::sqrt(1.3)));
}

TEST_CASE("where nothing is stiff or moves, frames set the pace") {
  StepLength length(verlet(), {});
  const double step = length.choose({}, 0.0);
  CHECK(step == 1e-2);
  CHECK(length.limit(1.0, 1.0, step) == StepLimit::none);
}

TEST_CASE("a lattice in which no bond is evaluated allows twice the step and no more") {
  StepLength length(verlet(), swinging());
  CHECK(length.choose({.latticeMoves = false}, 0.0) == Approx(2.0 * 0.5 * 2.0 / 1000.0));
  CHECK_FALSE(length.countsLattice());
}

TEST_CASE("a fixed step stays, or is divided into equal parts that are stable") {
  sim::Settings settings = verlet();
  settings.step = 1.9e-3;
  StepLength length(settings, swinging());
  CHECK(length.choose({}, 0.0) == 1.9e-3);
  CHECK(length.limit(1.0, 1.0, 1.9e-3) == StepLimit::fixed);
  CHECK(length.longestFixed() == Approx(2e-3));
  const double part = length.choose({.contactRateSquared = 8e6}, 1.9e-3);
  CHECK(part < 2.0 / 3000.0);
  CHECK(std::remainder(1.9e-3, part) == Approx(0.0).margin(1e-12));
  // What is stable where nothing touches is judged without contacts.
  CHECK(length.longestFixed() == Approx(2e-3));
}

TEST_CASE("forward Euler has no stable step where a bond has no damper") {
  sim::Settings settings = verlet();
  settings.method = Method::forwardEuler;
  StepLength length(settings, swinging());
  CHECK(length.choose({}, 0.0) == 0.0);
}

TEST_CASE("a step that was too wrong is tried again, as much shorter as its error asks for") {
  sim::Settings settings = verlet();
  settings.method = Method::rungeKutta;
  settings.tolerance = 1e-3;
  StepLength length(settings, swinging());
  const double swing = 2.0 * std::numbers::pi / 1000.0;
  double step = 2e-3;
  // An error of strain a swing 27 times the tolerance: the fourth order's estimate grows with the third power
  // over a swing, so a third of the step would use the tolerance up. Strains of 1 make errors relative to 1.
  const double error = 27.0 * 1e-3 * step / swing;
  CHECK_FALSE(length.accepts({error, 1.0, step}, step, 1.0));
  CHECK(step == Approx(0.8 * 2e-3 / 3.0));
  CHECK(length.exceeds(2e-3));
  // With a thousandth of the tolerance it is accepted, and may grow again, by at most a factor of 2 a swing.
  const double before = step;
  CHECK(length.accepts({1e-6 * step / swing, 1.0, step}, step, 1.0));
  CHECK(length.choose({}, 0.0) > before);
  CHECK(length.choose({}, 0.0) <= before * std::pow(2.0, before / swing) * (1.0 + 1e-12));
}

TEST_CASE("what a step length remembers is saved and loaded") {
  sim::Settings settings = verlet();
  settings.tolerance = 1e-2;
  StepLength length(settings, swinging());
  length.beginSurely(1.0);
  length.follow({1e-9, 0.5, 1e-4}, 1e-3, 1.0);
  sim::ByteWriter writer;
  length.save(writer);
  const std::vector<std::byte> bytes = std::move(writer).take();
  sim::ByteReader reader(bytes);
  StepLength restored(settings, swinging());
  REQUIRE(restored.load(reader));
  CHECK(restored.choose({}, 0.0) == length.choose({}, 0.0));
}

}  // namespace
