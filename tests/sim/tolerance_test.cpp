#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "sim/methods/method_names.h"
#include "tests/support/crash.h"

/// The step that keeps to a tolerance of strain, relative to the largest there was, a shortest swing.
namespace {

using sim::Method;

sim::Settings tolerating(Method method, double tolerance) {
  sim::Settings settings = tests::losslessSettings();
  settings.method = method;
  settings.tolerance = tolerance;
  return settings;
}

struct Outcome {
  double error = 0.0;  ///< of strain, relative to the largest rms, the worst moment's, a shortest swing
  std::uint64_t steps = 0;
};

/// A free chain rings in its mode of q = turns pi / nodes: nodes swing as cos(q (j + 1/2)), all bonds alike.
/// Two nodes and one turn are a spring.
Outcome ring(unsigned nodes, double turns, const sim::Settings& settings, int swings) {
  constexpr double kStiffness = 1000.0;
  const double q = turns * std::numbers::pi / nodes;
  const double omega = 2.0 * std::sqrt(kStiffness) * std::sin(0.5 * q);
  const double shortest =
      2.0 * std::sqrt(kStiffness) * std::sin(0.5 * std::numbers::pi * (nodes - 1) / nodes);
  constexpr double kSpeed = 0.3;
  sim::Blueprint bar = tests::chain(nodes, kStiffness);
  for (unsigned j = 0; j < nodes; ++j) bar.nodes[j].velocity.x() = kSpeed * std::cos(q * (j + 0.5));
  const auto chain = tests::simulation(std::move(bar), settings);
  Outcome outcome;
  const double until = swings * 2.0 * std::numbers::pi / omega;
  while (chain->time() < until) {
    REQUIRE(chain->stepOnce().ok());
    if (++outcome.steps % 7 != 0) continue;
    const sim::Snapshot snapshot = chain->snapshot();
    double wrong = 0.0;
    double largest = 0.0;
    for (unsigned j = 0; j + 1 < nodes; ++j) {
      const double shape = kSpeed / omega * (std::cos(q * (j + 1.5)) - std::cos(q * (j + 0.5)));
      const double strain = snapshot.positions[j + 1].x() - snapshot.positions[j].x() - 1.0;
      const double difference = strain - shape * std::sin(omega * snapshot.time);
      wrong += difference * difference;
      largest += shape * shape;
    }
    const double passed = snapshot.time * shortest / (2.0 * std::numbers::pi);
    if (passed > 1.0) outcome.error = std::max(outcome.error, std::sqrt(wrong / largest) / passed);
  }
  return outcome;
}

Method anyMethod() {
  return GENERATE(Method::velocityVerlet, Method::rungeKutta, Method::implicitMidpoint,
                  Method::implicitEuler);
}

TEST_CASE("a tolerance of strain is kept to") {
  const Method method = anyMethod();
  const auto [nodes, turns, swings] = GENERATE(std::tuple(2U, 1.0, 6), std::tuple(16U, 3.0, 2));
  // Tight enough to shorten the step of all of them.
  const double tolerance = method == Method::implicitEuler ? 1e-2
                           : method == Method::rungeKutta  ? 1e-5
                                                           : 1e-3;
  const Outcome loose = ring(nodes, turns, tolerating(method, tolerance), swings);
  const Outcome tight = ring(nodes, turns, tolerating(method, 0.5 * tolerance), swings);
  INFO(sim::nameOf(method) << ", " << nodes << " nodes: " << loose.steps << " and " << tight.steps
                           << " steps");
  // A step stays until its error is (1 / 0.8)^2 of the tolerance, and errors of velocity, which the estimate
  // leaves out, are errors of strain a quarter of a swing later.
  CHECK(loose.error < 1.5 * tolerance);
  CHECK(tight.error < 0.75 * tolerance);
  CHECK(tight.error < 0.8 * loose.error);
  CHECK(tight.steps > loose.steps);
}

TEST_CASE("a run with a tolerance gives the same bits on any number of threads, and when resumed") {
  const Method method = GENERATE(Method::velocityVerlet, Method::rungeKutta);
  constexpr double kTolerance = 1e-2;
  INFO(sim::nameOf(method));
  const auto whole = tests::crash({.method = method, .tolerance = kTolerance});
  constexpr double kUntil = 0.0004;
  tests::run(*whole, kUntil);
  const auto automatic = tests::crash({.method = method});
  tests::run(*automatic, kUntil);
  REQUIRE(whole->stepCount() > automatic->stepCount());
  const auto first = tests::crash({.threads = 2, .method = method, .tolerance = kTolerance});
  // Not where the error is looked at.
  const std::uint64_t cut = whole->stepCount() / 2 / 16 * 16 + 5;
  for (std::uint64_t n = 0; n < cut; ++n) REQUIRE(first->stepOnce().ok());
  const auto resumed = tests::crash({.threads = 3, .method = method, .tolerance = kTolerance});
  REQUIRE(resumed->restore(first->checkpoint()).ok());
  tests::run(*resumed, kUntil);
  CHECK(resumed->stateHash() == whole->stateHash());
  CHECK(resumed->stepCount() == whole->stepCount());
}

TEST_CASE("what falls without strain is stepped as without a tolerance") {
  const auto fall = [](std::optional<double> tolerance) {
    sim::Settings settings;
    settings.threads = 1;
    settings.method = Method::rungeKutta;
    settings.tolerance = tolerance;
    sim::Environment environment = tests::weightless();
    environment.gravity = {0.0, 0.0, -981.0};
    auto block = tests::simulation(tests::block({.distortion = 0.2}), settings, environment);
    tests::run(*block, 0.05);
    return block->stateHash();
  };
  CHECK(fall(1e-6) == fall(std::nullopt));
}

TEST_CASE("a tolerance is refused where it cannot be kept to") {
  const auto refusal = [](const sim::Settings& settings) {
    const auto refused = sim::Simulation::create(tests::built(tests::twoNodes({})), {}, {}, settings);
    REQUIRE_FALSE(refused.ok());
    return refused.problem().line();
  };
  CHECK(refusal(tolerating(Method::forwardEuler, 1e-3)).find("no estimate") != std::string::npos);
  CHECK(refusal(tolerating(Method::velocityVerlet, -1.0)).find("tolerance") != std::string::npos);
  sim::Settings both = tolerating(Method::velocityVerlet, 1e-3);
  both.step = 1e-4;
  CHECK(refusal(both).find("one of the two") != std::string::npos);
}

}  // namespace
