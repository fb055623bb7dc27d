#include <cmath>

#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/dynamics/reference_frames.h"
#include "tests/support/spring_network.h"

namespace {

constexpr double kBreakStrain = 1e-3;
constexpr double kAllowed = 1e-5;  ///< of the break extension

sim::Vec3 drawn(std::uint64_t seed, std::uint64_t counter) {
  return {sim::normalAt(seed, 3 * counter), sim::normalAt(seed, 3 * counter + 1),
          sim::normalAt(seed, 3 * counter + 2)};
}

/// A distorted bar, and an undistorted one: varied and uniform slots, all at rest in the blueprint.
sim::Network bars() {
  sim::Blueprint both = tests::block({.nx = 6, .ny = 6, .nz = 30, .spacing = 0.5, .dampingTime = 1e-7});
  tests::append(both, tests::block({.nx = 4,
                                    .ny = 5,
                                    .nz = 20,
                                    .spacing = 0.5,
                                    .dampingTime = 1e-7,
                                    .distortion = 0.2,
                                    .corner = sim::Vec3(10.0, 0.0, 0.0)}));
  return tests::built(std::move(both));
}

/// Every bond strained at random by about as much as breaks it, each fragment turned and moved.
sim::Motion strained(const sim::Network& network, const sim::Components& components, std::uint64_t seed,
                     double distance) {
  sim::Motion motion{sim::NodeVectors(network.nodeCount()), sim::NodeVectors(network.nodeCount())};
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const sim::FragmentId fragment = components.of(node);
    const sim::Vec3 axis = drawn(seed + 1, fragment).normalized();
    const Eigen::AngleAxisd turn(distance > 0.0 ? 2.0 * static_cast<double>(seed) : 0.0, axis);
    const sim::Vec3 moved = distance * drawn(seed + 2, fragment).normalized();
    const sim::Vec3 strain = 0.3 * kBreakStrain * 0.5 * drawn(seed, node);
    motion.position.set(node, turn * (network.positions[node] + strain) + moved);
    motion.velocity.set(node, 100.0 * axis + drawn(seed + 3, node));
  }
  return motion;
}

sim::NodeVectors accelerations(sim::KernelStep step, sim::KernelKind kind,
                               const sim::FloatReference* reference, std::size_t nodes, std::size_t blocks) {
  sim::NodeVectors result(nodes);
  for (std::size_t k = 0; k < 3; ++k) step.nextVelocity[k] = result.axis(k);
  step.accelerationOnly = true;
  step.reference = reference;
  std::vector<sim::BlockReport> reports(blocks);
  if (reference == nullptr) {
    sim::stepBlocksFor(kind)(step, 0, blocks, reports.data());
  } else {
    sim::floatKernelFor(kind).displaceBlocks(step, 0, blocks);
    sim::floatKernelFor(kind).stepBlocks(step, 0, blocks, reports.data());
  }
  return result;
}

TEST_CASE("forces in float are right to 1e-5 of the break extension, however a piece has moved and turned") {
  const double distance = GENERATE(0.0, 10.0, 1000.0);
  const std::uint64_t seed = GENERATE(1, 2, 3);
  const sim::Network network = bars();
  const sim::BondLayout layout(network, {}, sim::Precision::float32);
  REQUIRE_FALSE(layout.hasExact());
  const sim::Components components(network, layout);
  REQUIRE(components.births().size() == 2);
  const sim::Activity activity(network, components);
  const sim::Motion motion = strained(network, components, seed, distance);
  sim::ReferenceFrames frames(network, components);
  frames.fit(motion.position, activity);
  sim::AlignedVector<double> unit(sim::NodeVectors::paddedCount(network.nodeCount()), 1.0);
  const std::vector<std::uint8_t> untouched(layout.blockCount(), 0);
  const std::vector<sim::MaterialNow> materials(network.materials.size());
  sim::KernelStep step{};
  layout.describe(step);
  for (std::size_t k = 0; k < 3; ++k) {
    step.now.position[k] = motion.position.axis(k);
    step.now.velocity[k] = motion.velocity.axis(k);
  }
  step.inverseMass = unit.data();
  step.hasExternal = untouched.data();
  step.awake = activity.awakeLanes().data();
  step.materials = materials.data();
  double breaking = 0.0;  // dyn: of the stiffest bond
  for (const sim::BondClass& bond : network.classes)
    breaking = std::max(breaking, bond.stiffness * kBreakStrain * bond.restLength);
  const sim::FloatReference reference = frames.describe(layout, false);
  for (const auto kind : {sim::KernelKind::plain, sim::KernelKind::avx2, sim::KernelKind::avx512}) {
    if (sim::stepBlocksFor(kind) == nullptr) continue;
    INFO(sim::nameOfKernel(kind) << " " << distance << " cm away");
    const auto exact = accelerations(step, kind, nullptr, network.nodeCount(), layout.blockCount());
    const auto inFloat = accelerations(step, kind, &reference, network.nodeCount(), layout.blockCount());
    double squared = 0.0;
    double force = 0.0;
    double worst = 0.0;
    for (std::size_t node = 0; node < network.nodeCount(); ++node) {
      const double error = (exact.get(node) - inFloat.get(node)).norm() / breaking;
      worst = std::max(worst, error);
      squared += error * error;
      force += exact.get(node).squaredNorm() / (breaking * breaking);
    }
    const auto count = static_cast<double>(network.nodeCount());
    INFO("root mean square " << std::sqrt(squared / count) << ", worst " << worst);
    CHECK(std::sqrt(force / count) > 0.1);
    CHECK(worst < kAllowed);
  }
}

}  // namespace
