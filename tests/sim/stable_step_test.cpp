#include "sim/methods/stable_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/methods/method_names.h"
#include "tests/support/spring_network.h"

namespace {

using sim::Vec3;

/// The highest frequency of all, by a dense solver.
double trueFrequency(const sim::Network& network) {
  const auto size = static_cast<Eigen::Index>(3 * network.nodeCount());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  for (sim::BondIndex b = 0; b < network.bondCount(); ++b) {
    const sim::NodeIndex first = network.bondStart(b);
    const sim::NodeIndex second = network.bondEnds[b];
    const Vec3 along = (network.positions[second] - network.positions[first]).normalized();
    const Eigen::Matrix3d block = network.bond(b).stiffness * along * along.transpose();
    const auto add = [&](sim::NodeIndex row, sim::NodeIndex column, double sign) {
      matrix.block<3, 3>(3 * static_cast<Eigen::Index>(row), 3 * static_cast<Eigen::Index>(column)) +=
          sign / std::sqrt(network.masses[row] * network.masses[column]) * block;
    };
    add(first, first, 1.0);
    add(second, second, 1.0);
    add(first, second, -1.0);
    add(second, first, -1.0);
  }
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
                       .eigenvalues()
                       .maxCoeff());
}

double ratioOf(const sim::Network& network) {
  return sim::measureSpectrum(network).highestFrequency / trueFrequency(network);
}

const std::array<tests::Pattern, 4> kPatterns = {tests::Pattern::full, tests::Pattern::edgesAndBody,
                                                 tests::Pattern::edgesAndHalfFaces,
                                                 tests::Pattern::edgesAndFaces};

// From below by what twenty steps of the power iteration miss, from above by the margin it is given for that.
// The safety factor of at most 0.9 covers the rest.
constexpr double kLeast = 0.97;
constexpr double kMost = 1.031;

TEST_CASE("the highest frequency is found within a few per cent") {
  SECTION("in blocks of every pattern, straight and distorted") {
    for (const tests::Pattern pattern : kPatterns) {
      for (const double distortion : {0.0, 0.2, 0.5}) {
        for (const unsigned n : {1U, 2U, 4U}) {
          const double ratio = ratioOf(tests::built(
              tests::block({.nx = n, .ny = 2, .nz = n + 1, .pattern = pattern, .distortion = distortion})));
          CHECK(ratio > kLeast);
          CHECK(ratio < kMost);
        }
      }
    }
  }
  SECTION("in random networks") {
    for (unsigned seed = 1; seed < 7; ++seed) {
      const double ratio = ratioOf(tests::built(tests::randomNetwork(20 + 20 * seed, seed)));
      CHECK(ratio > kLeast);
      CHECK(ratio < kMost);
    }
  }
  SECTION("of one stiff bond among many") {
    for (const double factor : {1.2, 1.5, 2.0, 4.0, 100.0}) {
      sim::Blueprint row = tests::chain(200);
      row.bonds[70].stiffness *= factor;
      sim::Blueprint longRow = tests::chain(50000);
      longRow.bonds[7000].stiffness *= factor;
      // The stiff bond's own swing does not feel how long the row is.
      const double truth = trueFrequency(tests::built(row));
      const double ratio = sim::measureSpectrum(tests::built(longRow)).highestFrequency / truth;
      CHECK(ratio > kLeast);
      CHECK(ratio < kMost);
    }
  }
}

TEST_CASE("held nodes and nothing to swing are no trouble") {
  sim::Blueprint held = tests::chain(3);
  for (sim::Blueprint::Node& node : held.nodes) node.mass = std::numeric_limits<double>::infinity();
  CHECK(sim::measureSpectrum(tests::built(held)).highestFrequency == 0.0);
  held.nodes[1].mass = 1.0;
  CHECK(sim::measureSpectrum(tests::built(held)).highestFrequency == Approx(std::sqrt(2000.0)).epsilon(0.01));
  held.bonds.clear();
  const auto still = tests::simulation(held, tests::losslessSettings());
  tests::run(*still, 1.0);
  CHECK(still->snapshot().ledger.energy.mechanical() == 0.0);
}

double longestStep(const sim::Network& network, sim::Method method) {
  return sim::stableStep(sim::measureSpectrum(network), {}, method, 1.0);
}

/// Energy in the end, relative to the start, of a pair that swings for a thousand steps of `share` of the
/// stable step.
double growth(sim::Method method, double damping, double share) {
  sim::Settings settings = tests::losslessSettings();
  settings.method = method;
  const sim::Blueprint pair = tests::twoNodes({.stiffness = 1e5, .damping = damping, .distance = 1.0 + 1e-6});
  settings.step = share * longestStep(tests::built(pair), method);
  const auto swing = tests::simulation(pair, settings);
  const double start = swing->snapshot().ledger.energy.elastic;
  for (int n = 0; n < 1000; ++n) {
    if (!swing->stepOnce().ok()) return std::numeric_limits<double>::infinity();
    if (swing->snapshot().ledger.energy.mechanical() > 1e6 * start)
      return std::numeric_limits<double>::infinity();
  }
  return swing->snapshot().ledger.energy.mechanical() / start;
}

/// By what a damped swing x'' = -omega^2 x - rate x' grows a step at most, as each method is defined.
double factorOf(sim::Method method, double omega, double rate, double step) {
  Eigen::Matrix2d motion;
  motion << 0.0, step, -step * omega * omega, -step * rate;
  const Eigen::Matrix2d same = Eigen::Matrix2d::Identity();
  Eigen::Matrix2d once = same + motion;
  if (method == sim::Method::rungeKutta) {
    once = same + motion * (same + motion * (same + motion * (same + motion / 4.0) / 3.0) / 2.0);
  } else if (method != sim::Method::forwardEuler) {
    once.row(0) = Eigen::RowVector2d(1.0, 0.0) + step * once.row(1);
  }
  return once.eigenvalues().cwiseAbs().maxCoeff();
}

TEST_CASE("the stable step is the longest there is") {
  // Undamped, lightly, critically and far beyond: m sqrt(2 k / m) = 450 g/s is critical.
  const double damping = GENERATE(0.0, 10.0, 450.0, 2e4);
  const auto method = GENERATE(sim::Method::forwardEuler, sim::Method::velocityVerlet,
                               sim::Method::symplecticEuler, sim::Method::rungeKutta);
  if (method == sim::Method::forwardEuler && damping == 0.0) return;
  INFO(damping << " " << sim::nameOf(method));
  sim::Spectrum spectrum;
  spectrum.highestFrequency = std::sqrt(2e5);
  spectrum.shortestDamping = damping / 1e5;
  spectrum.highestDamping = 2.0 * damping;
  const double step = sim::stableStep(spectrum, {}, method, 1.0);
  CHECK(factorOf(method, std::sqrt(2e5), 2.0 * damping, 0.999 * step) <= 1.0 + 1e-12);
  // Forward Euler's bound is the least of d / k and what symplectic Euler can do, which strong dampers make
  // too careful.
  if (method != sim::Method::forwardEuler || damping < 450.0)
    CHECK(factorOf(method, std::sqrt(2e5), 2.0 * damping, 1.01 * step) > 1.0 + 1e-6);
  // The energy of a steady swing goes up and down by 1 / (1 - 0.9^2) = 5.3 with Verlet, and by 1.8 / 0.2 = 9
  // at 0.8 with symplectic Euler, whose position and velocity are half a step apart.
  CHECK(growth(method, damping, method == sim::Method::symplecticEuler ? 0.8 : 0.9) < 9.1);
}

TEST_CASE("what is soft and damped beside what is stiff and not does not shorten the step") {
  tests::Block stiff{.youngsModulus = 1e9};
  tests::Block soft{.youngsModulus = 1e4, .dampingTime = 1e-2};
  soft.corner = sim::Vec3(10.0, 0.0, 0.0);
  sim::Blueprint both = tests::block(stiff);
  tests::append(both, tests::block(soft));
  const double alone = longestStep(tests::built(tests::block(stiff)), sim::Method::velocityVerlet);
  const double slow = longestStep(tests::built(tests::block(soft)), sim::Method::velocityVerlet);
  const double together = longestStep(tests::built(both), sim::Method::velocityVerlet);
  // It is that of the worse of both, but for the bounds of what is not alike, which are within a half.
  CHECK(together > 0.5 * std::min(alone, slow));
}

TEST_CASE("a fixed step longer than any that is stable is refused, and the longest named") {
  const auto method = GENERATE(sim::Method::forwardEuler, sim::Method::velocityVerlet,
                               sim::Method::symplecticEuler, sim::Method::rungeKutta);
  INFO(sim::nameOf(method));
  const sim::Network pair = tests::built(tests::twoNodes({.damping = 1.0}));
  const double longest = longestStep(pair, method);
  sim::Settings settings = tests::losslessSettings();
  settings.method = method;
  settings.step = 0.999 * longest;
  CHECK(sim::Simulation::create(pair, tests::weightless(), {}, settings).ok());
  settings.step = 1.001 * longest;
  const auto refused = sim::Simulation::create(pair, tests::weightless(), {}, settings);
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.problem().place == "solver.step");
  const std::string line = refused.problem().line();
  INFO(line);
  const auto number = line.find("longer than ");
  REQUIRE(number != std::string::npos);
  CHECK(std::stod(line.substr(number + 12)) == Approx(longest).epsilon(1e-3));
}

TEST_CASE("any fixed step will do for an implicit method") {
  sim::Settings settings = tests::losslessSettings();
  settings.method = GENERATE(sim::Method::implicitEuler, sim::Method::implicitMidpoint);
  settings.step = 1.0;
  CHECK(tests::simulation(tests::twoNodes({}), settings)->step() == 1.0);
}

TEST_CASE("forward Euler needs damping, and a step of at most d / k") {
  sim::Settings settings = tests::losslessSettings();
  settings.method = sim::Method::forwardEuler;
  SECTION("undamped, no step is stable, be it fixed or not") {
    if (GENERATE(false, true)) settings.step = 1e-9;
    const auto undamped =
        sim::Simulation::create(tests::built(tests::twoNodes({})), tests::weightless(), {}, settings);
    REQUIRE_FALSE(undamped.ok());
    CHECK(undamped.problem().place == "solver.method");
  }
  SECTION("damped, a step of nearly d / k is") {
    CHECK(growth(sim::Method::forwardEuler, 10.0, 0.98) < 1.0);
  }
  SECTION("a run stops when a track takes its damping away") {
    sim::Track fading{.target = sim::TrackTarget::dampingScale,
                      .object = sim::kNone,
                      .interpolation = sim::Interpolation::step,
                      .keys = {{0.0, sim::Vec3::UnitX()}, {0.01, sim::Vec3::Zero()}}};
    const auto run =
        tests::simulation(tests::twoNodes({.damping = 1.0}), settings, tests::weightless(), {fading});
    const sim::Status status = run->advanceTo(0.02);
    REQUIRE_FALSE(status.ok());
    INFO(status.problem().line());
    CHECK(status.problem().line().find("no step is stable any more") != std::string::npos);
    CHECK(run->time() == Approx(0.01).margin(run->step() + 1e-3));
  }
}

TEST_CASE("no swing gains energy on its way by forward Euler's automatic step") {
  // A pair has nothing but its stiffest swing, the worst there is. Of 450 g/s, from light to five times
  // critical.
  const double damping = GENERATE(0.5, 5.0, 45.0, 450.0, 2250.0);
  INFO(damping);
  sim::Settings settings = tests::losslessSettings();
  settings.method = sim::Method::forwardEuler;
  settings.safety = 0.9;
  const auto swing = tests::simulation(
      tests::twoNodes({.stiffness = 1e5, .damping = damping, .distance = 1.0 + 1e-6}), settings);
  // The account is looked at in every step here, more often than the program does.
  double lowest = swing->snapshot().ledger.energy.mechanical();
  const double scale = lowest;
  double rise = 0.0;
  for (int n = 0; n < 20000; ++n) {
    REQUIRE(swing->stepOnce().ok());
    const double energy = swing->snapshot().ledger.energy.mechanical();
    lowest = std::min(lowest, energy);
    rise = std::max(rise, energy - lowest);
  }
  CHECK(rise < 0.005 * scale);
  // Where the swing hardly gains, d / k is what counts.
  if (damping == 0.5) CHECK(swing->step() == Approx(0.9 * damping / 1e5).epsilon(1e-9));
}

TEST_CASE("undamped, the leapfrog family keeps its energy however long the step") {
  sim::Settings settings = tests::losslessSettings();
  settings.method = GENERATE(sim::Method::velocityVerlet, sim::Method::symplecticEuler);
  settings.safety = GENERATE(0.5, 0.9);
  INFO(sim::nameOf(settings.method) << " " << settings.safety);
  sim::Blueprint bar = tests::chain(20);
  for (std::size_t n = 0; n < bar.nodes.size(); ++n) bar.nodes[n].velocity.x() = sim::normalAt(1, n);
  const auto run = tests::simulation(std::move(bar), settings);
  for (int n = 0; n < 5000; ++n) REQUIRE(run->stepOnce().ok());
  // A chain that moves along itself is linear: what is left is rounding.
  CHECK(run->maxRise() < 1e-11);
}

TEST_CASE("a fixed step is divided while a track stiffens the scene") {
  sim::Settings settings = tests::losslessSettings();
  sim::Blueprint bar = tests::chain(20);
  for (std::size_t n = 0; n < bar.nodes.size(); ++n) bar.nodes[n].velocity.x() = sim::normalAt(1, n);
  const double step = 0.8 * longestStep(tests::built(bar), settings.method);
  settings.step = step;
  sim::Track stiffer{.target = sim::TrackTarget::stiffnessScale,
                     .object = sim::kNone,
                     .interpolation = sim::Interpolation::step,
                     .keys = {}};
  stiffer.keys = {{0.0, sim::Vec3::UnitX()},
                  {50.0 * step, 100.0 * sim::Vec3::UnitX()},
                  {100.0 * step, sim::Vec3::UnitX()}};
  const auto run = tests::simulation(std::move(bar), settings, tests::weightless(), {stiffer});
  tests::run(*run, 40.0 * step);
  CHECK(run->step() == step);
  tests::run(*run, 60.0 * step);
  // Ten times as stiff in frequency: parts of at most 0.9 of a tenth of the longest.
  CHECK(run->step() == Approx(step / 9.0).epsilon(1e-12));
  tests::run(*run, 200.0 * step);
  CHECK(run->step() == step);
  CHECK(run->maxRise() < 1e-9);
}

/// A little random motion.
void shake(sim::Blueprint& blueprint, double speed) {
  for (std::size_t n = 0; n < blueprint.nodes.size(); ++n) {
    for (std::uint64_t k = 0; k < 3; ++k)
      blueprint.nodes[n].velocity[static_cast<Eigen::Index>(k)] += speed * sim::normalAt(1, 3 * n + k);
  }
}

/// Runs ten thousand steps.
void checkBounded(const sim::Blueprint& blueprint, sim::Settings settings,
                  const sim::Environment& environment = tests::weightless()) {
  const auto run = tests::simulation(blueprint, settings, environment);
  double most = run->snapshot().ledger.energy.mechanical();
  const double start = most;
  for (int n = 0; n < 10000; ++n) {
    const sim::Status status = run->stepOnce();
    INFO((status ? std::string() : status.problem().line()));
    REQUIRE(status.ok());
    if (n % 100 == 0) most = std::max(most, run->snapshot().ledger.energy.mechanical());
  }
  // The stiffest motion's energy goes up and down by 1 / (1 - 0.9^2) = 5.3 at the largest safety factor.
  CHECK(most < 5.5 * start);
}

TEST_CASE("runs at the largest safety factor stay bounded for ten thousand steps") {
  // Undamped, only motion that is small enough to be linear can: at omega h = sqrt(3) any explicit method of
  // this kind resonates with what is quadratic in the motion, three steps a swing. A little damping is enough
  // against that.
  const double damping = GENERATE(0.0, 1e-5);
  sim::Settings settings = tests::losslessSettings();
  settings.safety = 0.9;
  for (const tests::Pattern pattern : kPatterns) {
    INFO(static_cast<int>(pattern));
    sim::Blueprint block = tests::block(
        {.nx = 2, .ny = 2, .nz = 3, .dampingTime = damping, .pattern = pattern, .distortion = 0.3});
    shake(block, damping > 0.0 ? 1.0 : 1e-3);
    checkBounded(block, settings);
  }
}

TEST_CASE("contacts count in the step") {
  // Two blocks pressed together by a floor that the lower lies on and the weight of both: nodes of the lower
  // one's top have their own bonds, the contacts above, and no slack. Stiff contacts would break a step
  // chosen without them.
  const bool damped = GENERATE(false, true);
  sim::Blueprint stack = tests::twoBlocks({.nx = 2, .ny = 2, .nz = 2, .youngsModulus = 1e6}, 0.95, 0.0);
  shake(stack, 5.0);
  sim::Settings settings = tests::losslessSettings();
  settings.contact.length = sim::ContactLength::sum;
  if (damped) settings.contact.dampingRatio = 1.0;
  sim::Environment environment = tests::earth();
  environment.colliders[0].friction = 0.0;
  environment.colliders[0].dampingRatio = damped ? 1.0 : 0.0;
  environment.colliders[0].stiffness = 3e6;
  // Undamped contacts that begin and end between steps add and take energy at random when steps are long.
  settings.safety = damped ? 0.9 : 0.5;
  checkBounded(stack, settings, environment);

  const auto touching = tests::simulation(stack, settings, environment);
  const auto apart = tests::simulation(tests::twoBlocks({.youngsModulus = 1e6}, 50.0, 0.0), settings);
  CHECK(touching->step() < 0.9 * apart->step());
}

}  // namespace
