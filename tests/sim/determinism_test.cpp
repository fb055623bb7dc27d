#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/kernel/bond_layout.h"
#include "sim/methods/method_names.h"
#include "sim/state/motion.h"
#include "tests/support/crash.h"
#include "tests/support/kernels.h"
#include "tests/support/spring_network.h"

namespace {

using sim::KernelKind;

TEST_CASE("a breaking, touching, flowing run is the same on any number of threads") {
  std::uint64_t expected = 0;
  for (const int threads : {1, 2, 3, 7}) {
    const auto crash = tests::crash({.large = true, .threads = threads});
    tests::run(*crash, 0.003);
    CHECK(crash->brokenBondCount() > 100);
    CHECK(crash->snapshot().ledger.energy.contact > 0.0);
    if (threads == 1) expected = crash->stateHash();
    CHECK(crash->stateHash() == expected);
  }
}

TEST_CASE("with every kernel and method a run is the same on any number of threads") {
  const std::string kernel = GENERATE(from_range(tests::kernelsHere()));
  const auto method = GENERATE(sim::Method::forwardEuler, sim::Method::symplecticEuler,
                               sim::Method::velocityVerlet, sim::Method::rungeKutta);
  INFO(kernel << " " << sim::nameOf(method));
  const tests::ChosenKernel chosen(kernel);
  std::uint64_t expected = 0;
  for (const int threads : {1, 3}) {
    const auto crash = tests::crash({.threads = threads, .method = method});
    tests::run(*crash, 8e-4);
    CHECK(crash->brokenBondCount() > 10);
    if (threads == 1) expected = crash->stateHash();
    CHECK(crash->stateHash() == expected);
  }
}

TEST_CASE("looking at a run does not change it") {
  const auto watched = tests::crash({});
  const auto alone = tests::crash({});
  while (watched->time() < 0.003) {
    REQUIRE(watched->stepOnce().ok());
    watched->snapshot();
    watched->drainBreakEvents();
  }
  tests::run(*alone, 0.003);
  CHECK(watched->stateHash() == alone->stateHash());
}

/// Uniform and varied, contiguous and gathered, elastic and plastic slots in one network.
sim::Network mixedNetwork() {
  sim::Blueprint mixed = tests::block({.nx = 3, .ny = 2, .nz = 20, .dampingTime = 1e-4});
  tests::Block varied{.nx = 2, .ny = 2, .nz = 17, .dampingTime = 1e-5, .distortion = 0.3};
  varied.material.thresholdMean = 0.02;
  tests::append(mixed, tests::block(varied));
  sim::Blueprint plastic = tests::randomNetwork(70, 9, 1.0, 0.2);
  plastic.materials[0].yieldStrain = 0.05;
  plastic.materials[0].flowRate = 100.0;
  tests::append(mixed, plastic);
  tests::append(mixed, tests::randomNetwork(55, 10));
  return tests::built(std::move(mixed));
}

/// What a kernel leaves behind, bit by bit.
struct Outcome {
  std::vector<double> numbers;
  std::vector<bool> suspect;
  bool operator==(const Outcome& other) const {
    return suspect == other.suspect && numbers.size() == other.numbers.size() &&
           std::memcmp(numbers.data(), other.numbers.data(), numbers.size() * sizeof(double)) == 0;
  }
};

/// `stretch`: blocks a call of the kernel.
Outcome stepsOf(KernelKind kind, const sim::Network& network, bool oldVelocity, std::size_t stretch) {
  const std::size_t count = network.nodeCount();
  sim::BondLayout layout(network);
  for (sim::BondIndex bond = 0; bond < network.bondCount(); bond += 17) layout.remove(network, bond);
  std::array<sim::Motion, 2> motion;
  for (sim::Motion& one : motion) one = {sim::NodeVectors(count), sim::NodeVectors(count)};
  sim::NodeVectors total(count);
  sim::NodeVectors lossy(count);
  std::vector<std::uint8_t> touched(layout.blockCount(), 0);
  sim::AlignedVector<double> inverseMass(sim::NodeVectors::paddedCount(count), 0.0);
  for (std::size_t n = 0; n < count; ++n) {
    inverseMass[n] = n % 29 == 0 ? 0.0 : 1.0 / network.masses[n];
    touched[n / sim::kBlockNodes] = (n / sim::kBlockNodes) % 3 == 0;
    motion[0].position.set(n, network.positions[n]);
    const auto draw = [&](std::uint64_t k) { return sim::normalAt(3, 9 * n + k); };
    motion[0].velocity.set(n, 10.0 * sim::Vec3(draw(0), draw(1), draw(2)));
    lossy.set(n, sim::Vec3(draw(3), draw(4), draw(5)));
    total.set(n, lossy.get(n) + sim::Vec3(draw(6), draw(7), draw(8)));
  }
  std::vector<sim::MaterialNow> materials(network.materials.size());
  for (std::size_t m = 0; m < materials.size(); ++m)
    materials[m] = {1.1, 0.9, network.materials[m].yieldStrain, 0.1};
  std::vector<sim::BlockReport> reports(layout.blockCount());
  const std::vector<std::uint16_t> awake(layout.blockCount(), 0xffff);
  Outcome outcome;
  for (std::size_t n = 0; n < 20; ++n) {
    const sim::Motion& from = motion[n % 2];
    sim::Motion& to = motion[1 - n % 2];
    sim::KernelStep step{};
    layout.describe(step);
    for (std::size_t k = 0; k < 3; ++k) {
      step.now.position[k] = from.position.axis(k);
      step.now.velocity[k] = from.velocity.axis(k);
      step.nextPosition[k] = to.position.axis(k);
      step.nextVelocity[k] = to.velocity.axis(k);
      step.external[k] = total.axis(k);
      step.externalLossy[k] = lossy.axis(k);
    }
    step.inverseMass = inverseMass.data();
    step.hasExternal = touched.data();
    step.awake = awake.data();
    step.gravity[2] = -981.0;
    step.kick = step.drift = 1e-4;
    step.driftByOldVelocity = oldVelocity;
    step.flowing = true;
    step.materials = materials.data();
    for (std::size_t first = 0; first < layout.blockCount(); first += stretch) {
      const std::size_t last = std::min(layout.blockCount(), first + stretch);
      sim::stepBlocksFor(kind)(step, first, last, reports.data());
    }
    for (const sim::BlockReport& report : reports) {
      outcome.numbers.insert(outcome.numbers.end(), {report.dissipated, report.largestSpeedSquared});
      outcome.suspect.push_back(report.suspect);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    for (const sim::NodeVectors* vectors : {&motion[0].position, &motion[0].velocity})
      outcome.numbers.insert(outcome.numbers.end(), vectors->axis(k), vectors->axis(k) + count);
  }
  const std::vector<double> restLengths = layout.plasticRestLengths();
  outcome.numbers.insert(outcome.numbers.end(), restLengths.begin(), restLengths.end());
  return outcome;
}

TEST_CASE(
    "every kernel of this processor gives the same motion, and its own bits however blocks are shared out") {
  const bool oldVelocity = GENERATE(false, true);
  const sim::Network network = mixedNetwork();
  const Outcome plain = stepsOf(KernelKind::plain, network, oldVelocity, 1000);
  CHECK(std::count(plain.suspect.begin(), plain.suspect.end(), true) > 0);
  for (const KernelKind kind : {KernelKind::plain, KernelKind::avx2, KernelKind::avx512}) {
    if (sim::stepBlocksFor(kind) == nullptr) continue;
    INFO(sim::nameOfKernel(kind));
    const Outcome outcome = stepsOf(kind, network, oldVelocity, 1000);
    CHECK(stepsOf(kind, network, oldVelocity, 3) == outcome);
    CHECK(outcome.suspect == plain.suspect);
    REQUIRE(outcome.numbers.size() == plain.numbers.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < plain.numbers.size(); ++i) {
      const double apart = std::abs(outcome.numbers[i] - plain.numbers[i]);
      worst = std::max(worst, apart / (1.0 + std::abs(plain.numbers[i])));
    }
    // They round differently, by 1e-16 an operation; twenty steps of networks this stiff amplify that.
    CHECK(worst < 1e-11);
  }
}

}  // namespace
