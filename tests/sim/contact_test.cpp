#include <cmath>
#include <map>

#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/contact/contact_forces.h"
#include "tests/support/spring_network.h"

namespace {

using sim::NodeIndex;
using sim::Vec3;

/// Centre of mass and its velocity of the nodes [first, last).
struct Body {
  Vec3 centre = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
};
Body bodyOf(const sim::Simulation& simulation, std::size_t first, std::size_t last) {
  const sim::Snapshot snapshot = simulation.snapshot();
  Body body;
  double mass = 0.0;
  for (std::size_t n = first; n < last; ++n) {
    mass += simulation.network().masses[n];
    body.centre += simulation.network().masses[n] * snapshot.positions[n];
    body.velocity += simulation.network().masses[n] * snapshot.velocities[n];
  }
  body.centre /= mass;
  body.velocity /= mass;
  return body;
}

/// Pairs of nodes, each a fragment of its own, bonds of length 1 along z, at the given places.
sim::Blueprint rods(const std::vector<Vec3>& places, const std::vector<Vec3>& velocities) {
  sim::Blueprint blueprint;
  blueprint.materials = {{.name = "rod"}};
  blueprint.partNames = {"rods"};
  for (std::size_t r = 0; r < places.size(); ++r) {
    const auto first = static_cast<NodeIndex>(2 * r);
    for (const double height : {0.0, 1.0}) {
      blueprint.nodes.push_back(
          {.position = places[r] + Vec3(0.0, 0.0, height), .velocity = velocities[r], .mass = 1.0});
    }
    blueprint.bonds.push_back({first, first + 1, 1000.0, 1.0, 0.0, 0});
  }
  return blueprint;
}

double gapBetweenRods(const sim::Simulation& simulation) {
  const sim::Snapshot snapshot = simulation.snapshot();
  return (snapshot.positions[2] - snapshot.positions[0]).norm();
}

TEST_CASE("two blocks that meet head on part again, with their momentum and no more energy") {
  const double damping = GENERATE(0.0, 0.3);
  const tests::Block shape{.nx = 2, .ny = 3, .nz = 4, .youngsModulus = 1e6};
  sim::Settings settings = tests::losslessSettings();
  settings.contact.kind = sim::ContactKind::nodes;
  settings.contact.dampingRatio = damping;
  settings.contact.friction = damping;
  const auto crash = tests::simulation(tests::twoBlocks(shape, 1.5, 60.0), settings);
  const std::size_t half = crash->network().nodeCount() / 2;
  const Vec3 momentum = crash->snapshot().ledger.linearMomentum;
  const double kinetic = crash->snapshot().ledger.energy.kinetic;
  double nearest = 10.0;
  while (crash->time() < 0.08) {
    REQUIRE(crash->stepOnce().ok());
    const sim::Snapshot snapshot = crash->snapshot();
    for (std::size_t n = half; n < 2 * half; ++n) {
      for (std::size_t m = 0; m < half; ++m)
        nearest = std::min(nearest, snapshot.positions[n].z() - snapshot.positions[m].z());
    }
  }
  CHECK(nearest < 1.0);  // they touched: contact begins at the spacing of 1
  CHECK(nearest > 0.0);  // and no node of the upper block was ever below one of the lower
  const Body lower = bodyOf(*crash, 0, half);
  const Body upper = bodyOf(*crash, half, 2 * half);
  CHECK(upper.velocity.z() > lower.velocity.z() + 20.0);
  CHECK((crash->snapshot().ledger.linearMomentum - momentum).norm() < 1e-10 * kinetic / 60.0);
  // All energy there is: what neither moves nor swings was damped away.
  const sim::Energy energy = crash->snapshot().ledger.energy;
  CHECK(energy.mechanical() <= kinetic * 1.002);
  CHECK(energy.mechanical() + energy.dissipated == Approx(kinetic).epsilon(0.002));
  CHECK((damping == 0.0 || energy.dissipated > 0.05 * kinetic));
  CHECK(crash->maxRise() < 0.005);
}

TEST_CASE("a pair closer than its natural length when contact begins gets no energy from it") {
  const auto still = tests::simulation(
      rods({Vec3::Zero(), Vec3(0.3, 0.0, 0.0)}, {Vec3::Zero(), Vec3::Zero()}), tests::losslessSettings());
  tests::run(*still, 0.5);
  CHECK(gapBetweenRods(*still) == 0.3);
  CHECK(still->snapshot().ledger.energy.mechanical() == 0.0);

  // Parting, nothing pushes. Coming back, it pushes from where it was furthest: here all at the first touch.
  sim::Settings settings = tests::losslessSettings();
  settings.step = 1e-4;
  const auto nearing = tests::simulation(
      rods({Vec3::Zero(), Vec3(0.5, 0.0, 0.0)}, {Vec3(1.0, 0.0, 0.0), Vec3(-1.0, 0.0, 0.0)}), settings);
  tests::run(*nearing, 0.3);
  // Half a swing of x'' = -k / mu x, twice over as each rod touches with both nodes: pi sqrt(0.5 / 1000).
  CHECK(gapBetweenRods(*nearing) == Approx(0.5 + 2.0 * (0.3 - M_PI * std::sqrt(0.5 / 1000.0))).margin(0.01));
  CHECK(nearing->snapshot().ledger.energy.kinetic == Approx(2.0).epsilon(1e-4));
}

TEST_CASE("the spring between nodes is as long as the nearer spacing, or as both together") {
  struct Case {
    sim::ContactLength length;
    double natural;
  };
  for (const Case& one : {Case{sim::ContactLength::nearest, 1.0}, Case{sim::ContactLength::sum, 2.0}}) {
    sim::Settings settings = tests::losslessSettings();
    settings.contact.length = one.length;
    settings.step = 1e-4;
    const auto meeting = tests::simulation(
        rods({Vec3::Zero(), Vec3(2.5, 0.0, 0.0)}, {Vec3(5.0, 0.0, 0.0), Vec3(-5.0, 0.0, 0.0)}), settings);
    double touched = 0.0;
    while (touched == 0.0 && meeting->time() < 1.0) {
      REQUIRE(meeting->stepOnce().ok());
      if (meeting->snapshot().ledger.energy.contact > 0.0) touched = gapBetweenRods(*meeting);
    }
    // Each node also sees the other rod's far node, at sqrt(x^2 + 1): nearer than 2 only after 1.73.
    CHECK(touched == Approx(one.natural).margin(10.0 * 1e-4));
  }
}

/// A chain bent into a hairpin, whose ends fly at each other.
double nearestOfHairpin(bool self) {
  sim::Blueprint rope;
  rope.materials = {{.name = "rope"}};
  rope.partNames = {"rope"};
  const std::vector<Vec3> places = {{0, 0, 3},      {0, 0, 2}, {0, 0, 1}, {0.5, 0, 0.13},
                                    {1.5, 0, 0.13}, {2, 0, 1}, {2, 0, 2}, {2, 0, 3}};
  for (NodeIndex n = 0; n < places.size(); ++n) {
    rope.nodes.push_back({.position = places[n], .mass = 1.0});
    if (n > 0) rope.bonds.push_back({n - 1, n, 1000.0, (places[n] - places[n - 1]).norm(), 0.0, 0});
  }
  rope.nodes.front().velocity.x() = 5.0;
  rope.nodes.back().velocity.x() = -5.0;
  sim::Settings settings = tests::losslessSettings();
  settings.contact.self = self;
  const auto coil = tests::simulation(rope, settings);
  double nearest = 10.0;
  while (coil->time() < 0.3) {
    REQUIRE(coil->stepOnce().ok());
    const sim::Snapshot snapshot = coil->snapshot();
    nearest = std::min(nearest, (snapshot.positions.back() - snapshot.positions.front()).norm());
  }
  REQUIRE(coil->snapshot().fragments.size() == 1);
  CHECK(coil->maxRise() < 0.005);
  return nearest;
}

TEST_CASE("a rope runs into itself only when asked to") {
  CHECK(nearestOfHairpin(false) < 0.1);
  // Relative speed 10, reduced mass 1/2, k = 1000: let in by at most 10 sqrt(0.5 / 1000) = 0.22.
  CHECK(nearestOfHairpin(true) > 1.0 - 0.25);
}

/// The force on every node as the header states it, from all pairs: the lists of neighbours play no part.
class BruteForce {
 public:
  BruteForce(const sim::Network& network, const sim::ContactSettings& settings)
      : network_(network), settings_(settings) {}

  std::vector<Vec3> forces(const sim::Motion& motion, const sim::Components& components) {
    std::vector<Vec3> forces(network_.nodeCount(), Vec3::Zero());
    for (NodeIndex i = 0; i < network_.nodeCount(); ++i) {
      for (NodeIndex j = i + 1; j < network_.nodeCount(); ++j) {
        if (components.of(i) == components.of(j)) continue;
        const Vec3 push = pushOnSecond(i, j, motion);
        forces[j] += push;
        forces[i] -= push;
      }
    }
    return forces;
  }

 private:
  Vec3 pushOnSecond(NodeIndex i, NodeIndex j, const sim::Motion& motion) {
    const Vec3 apart = motion.position.get(j) - motion.position.get(i);
    const double distance = apart.norm();
    const double first = network_.radii[i];
    const double second = network_.radii[j];
    const bool sum = settings_.length == sim::ContactLength::sum;
    const double natural = sum ? first + second : std::min(first, second);
    const auto [entry, fresh] = rho_.try_emplace({i, j}, std::min(natural, distance));
    double& rho = entry->second;
    if (distance >= rho) rho = std::min(natural, distance);
    if (distance >= rho) return Vec3::Zero();
    constexpr double kStiffness = 1000.0;
    const double damping = 2.0 * settings_.dampingRatio * std::sqrt(kStiffness * 0.5);
    const double separating = (motion.velocity.get(j) - motion.velocity.get(i)).dot(apart) / distance;
    return std::max(0.0, kStiffness * (rho - distance) - damping * separating) * apart / distance;
  }

  const sim::Network& network_;
  sim::ContactSettings settings_;
  std::map<std::pair<NodeIndex, NodeIndex>, double> rho_;
};

TEST_CASE("lists of neighbours find every pair that touches, however nodes move between rebuilds") {
  const std::uint64_t seed = GENERATE(1, 2, 3);
  sim::ContactSettings settings;
  settings.length = GENERATE(sim::ContactLength::nearest, sim::ContactLength::sum);
  settings.friction = 0.0;
  std::vector<Vec3> places;
  for (std::uint64_t r = 0; r < 40; ++r) {
    places.push_back(5.0 * Vec3(sim::uniformAt(seed, 3 * r), sim::uniformAt(seed, 3 * r + 1),
                                sim::uniformAt(seed, 3 * r + 2)));
  }
  const sim::Network network = tests::built(rods(places, std::vector<Vec3>(places.size(), Vec3::Zero())));
  const std::size_t count = network.nodeCount();
  const sim::BondLayout layout(network);
  const sim::Components components(network, layout);
  const sim::Breakage breakage(network);
  sim::Contacts contacts(network, settings);
  BruteForce truth(network, settings);
  sim::Motion motion{sim::NodeVectors(count), sim::NodeVectors(count)};
  for (std::size_t n = 0; n < count; ++n) motion.position.set(n, network.positions[n]);
  sim::ContactForces forces(layout.blockCount());
  const std::vector<sim::MaterialNow> materials(1);
  std::size_t pushing = 0;
  constexpr double kStep = 1e-3;
  constexpr int kSteps = 300;
  for (int step = 0; step < kSteps; ++step) {
    if (contacts.age().stale()) contacts.rebuild(motion, components, breakage, {}, 0.0);
    sim::findContactForces(contacts, {motion, {}, materials, kStep, 0.0}, forces);
    contacts.settle(motion, {}, 0.0);
    const std::vector<Vec3> expected = truth.forces(motion, components);
    double travel = 0.0;
    for (std::size_t n = 0; n < count; ++n) {
      const bool touched = forces.touched[n / sim::kBlockNodes] != 0;
      const Vec3 force = touched ? forces.total.get(n) : Vec3(Vec3::Zero());
      // A few contacts of up to 1e3 dyn are added in another order.
      REQUIRE((force - expected[n]).norm() < 1e-9);
      if (expected[n].norm() > 0.0) ++pushing;
      // Wild motion of its own: speeds change at random, now and then by much.
      Vec3 velocity = 0.97 * motion.velocity.get(n);
      for (std::uint64_t k = 0; k < 3; ++k) {
        const std::uint64_t draw = (static_cast<std::uint64_t>(step) * count + n) * 3 + k;
        velocity[static_cast<Eigen::Index>(k)] += 3.0 * sim::normalAt(seed + 10, draw);
      }
      velocity -= 0.2 * (motion.position.get(n) - Vec3::Constant(2.5));
      travel = std::max(travel, velocity.norm() * kStep);
      motion.velocity.set(n, velocity);
      motion.position.add(n, kStep * velocity);
    }
    contacts.ageByStep(motion, travel);
  }
  CHECK(pushing > 3000);
  // The lists are kept for a while, or this would show nothing.
  CHECK(contacts.rebuilds() < kSteps / 3);
}

TEST_CASE("nodes without bonds have no size and pass each other by") {
  sim::Blueprint dust = rods({Vec3::Zero(), Vec3(1.0, 0.0, 0.0)}, {Vec3(10.0, 0.0, 0.0), Vec3::Zero()});
  dust.bonds.clear();
  const auto passing = tests::simulation(dust, tests::losslessSettings());
  tests::run(*passing, 0.5);
  CHECK(passing->snapshot().positions[0].x() == Approx(5.0));
}

constexpr double kGravity = 981.0;

/// One node that slides on a floor of stiffness 1e6, resting in it as deep as its weight asks.
sim::Blueprint slider(const Vec3& normal, double speed) {
  sim::Blueprint blueprint;
  blueprint.materials = {{.name = "slider"}};
  blueprint.partNames = {"slider"};
  const Vec3 downhill = Vec3(normal.z(), 0.0, -normal.x());
  blueprint.nodes.push_back(
      {.position = -kGravity * normal.z() / 1e6 * normal, .velocity = speed * downhill, .mass = 1.0});
  return blueprint;
}

sim::Environment slope(double angle, double friction) {
  sim::Environment environment = tests::earth();
  environment.colliders[0].rotation = Eigen::AngleAxisd(angle, Vec3::UnitY());
  environment.colliders[0].stiffness = 1e6;
  environment.colliders[0].friction = friction;
  return environment;
}

TEST_CASE("what slides on a floor stops after v^2 / (2 mu g), and then lies still") {
  const bool bySpeed = GENERATE(false, true);
  constexpr double kSpeed = 100.0;
  constexpr double kFriction = 0.4;
  constexpr double kStep = 1e-4;
  sim::Settings settings;
  settings.step = kStep;
  settings.threads = 1;
  if (bySpeed) settings.contact.kind = sim::ContactKind::nodes;
  const auto slide = tests::simulation(slider(Vec3::UnitZ(), kSpeed), settings, slope(0.0, kFriction));
  double slowest = kSpeed;
  while (slide->time() < 1.2 * kSpeed / (kFriction * kGravity)) {
    REQUIRE(slide->stepOnce().ok());
    slowest = std::min(slowest, slide->snapshot().velocities[0].x());
  }
  // Friction is the step's own: off by at most the way of the last step, half a step's slowing at 100 cm/s.
  CHECK(slide->snapshot().positions[0].x() ==
        Approx(kSpeed * kSpeed / (2.0 * kFriction * kGravity)).margin(kStep * kSpeed));
  // What stopped it, a spring of 1e6 with a damper, was stretched by mu times the depth when it did.
  const double depth = kGravity / 1e6;
  CHECK(slowest > (bySpeed ? -1e-12 : -kFriction * depth * 1e3));
  CHECK(slide->snapshot().velocities[0].norm() < 1e-6);
}

TEST_CASE("on a slope it stays below the angle of friction and slides above it") {
  constexpr double kFriction = 0.4;
  constexpr double kStep = 1e-4;
  sim::Settings settings;
  settings.step = kStep;
  settings.threads = 1;
  const auto slidFrom = [&](double angle, double time) {
    const Vec3 normal(std::sin(angle), 0.0, std::cos(angle));
    const auto slide = tests::simulation(slider(normal, 0.0), settings, slope(angle, kFriction));
    tests::run(*slide, time);
    const Vec3 way = slide->snapshot().positions[0];
    return way.dot(Vec3(normal.z(), 0.0, -normal.x()));
  };
  const double limit = std::atan(kFriction);
  // It goes about as far as the spring that holds it must be stretched to carry it, and no further.
  const double early = slidFrom(0.9 * limit, 0.1);
  CHECK(early < 3.0 * kGravity * std::sin(0.9 * limit) / 1e6);
  CHECK(slidFrom(0.9 * limit, 0.5) == Approx(early).epsilon(1e-6));
  const double pull = kGravity * (std::sin(1.2 * limit) - kFriction * std::cos(1.2 * limit));
  CHECK(slidFrom(1.2 * limit, 0.5) == Approx(0.5 * pull * 0.25).epsilon(0.01));
}

TEST_CASE("a soft block slides to a stop like a hard one") {
  constexpr double kSpeed = 60.0;
  tests::Block shape{.nx = 4, .ny = 3, .nz = 2, .youngsModulus = 1e6, .dampingTime = 3e-4};
  shape.corner.z() = 0.0;
  shape.velocity.x() = kSpeed;
  sim::Environment environment = tests::earth();
  environment.colliders[0].friction = 0.5;
  environment.colliders[0].dampingRatio = 0.5;
  sim::Settings settings;
  settings.threads = 1;
  const auto slide = tests::simulation(tests::block(shape), settings, environment);
  const std::size_t count = slide->network().nodeCount();
  const double start = bodyOf(*slide, 0, count).centre.x();
  double slowest = kSpeed;
  while (slide->time() < 0.3) {
    tests::run(*slide, slide->time() + 0.002);
    slowest = std::min(slowest, bodyOf(*slide, 0, count).velocity.x());
  }
  const double way = bodyOf(*slide, 0, count).centre.x() - start;
  // It bounces a little as it settles and leans on its front edge, but pushes with its weight on average.
  CHECK(way == Approx(kSpeed * kSpeed / (2.0 * 0.5 * kGravity)).epsilon(0.05));
  // It stops with a shudder of its springs, and springs back by what friction had stretched; it does not turn
  // back.
  CHECK(slowest > -0.03 * kSpeed);
  CHECK(bodyOf(*slide, 0, count).velocity.norm() < 0.01 * kSpeed);
}

}  // namespace
