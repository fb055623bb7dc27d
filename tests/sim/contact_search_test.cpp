#include <set>

#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/contact/contacts.h"
#include "sim/contact/fragment_boxes.h"
#include "sim/contact/shared_motion.h"
#include "tests/support/spring_network.h"

namespace {

using sim::FragmentId;
using sim::NodeIndex;
using sim::Vec3;

TEST_CASE("boxes find every node that is near a node of another fragment") {
  constexpr std::size_t kNodes = 300;
  constexpr std::size_t kFragments = 40;
  constexpr double kDistance = 0.4;
  sim::NodeVectors positions(kNodes);
  std::vector<FragmentId> fragments(kNodes);
  for (std::size_t n = 0; n < kNodes; ++n) {
    fragments[n] = static_cast<FragmentId>(n % kFragments);
    // Small clouds around random places.
    for (std::size_t k = 0; k < 3; ++k)
      positions.axis(k)[n] =
          6.0 * sim::uniformAt(1, 3 * fragments[n] + k) + 0.5 * sim::uniformAt(2, 3 * n + k);
  }
  const auto meetings = sim::FragmentBoxes(positions, fragments, kFragments).meetings(kDistance);
  std::size_t near = 0;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < kNodes; ++i) {
    bool meets = false;
    for (std::size_t j = 0; j < kNodes; ++j)
      meets |= fragments[i] != fragments[j] && (positions.get(i) - positions.get(j)).norm() < kDistance;
    const bool found = meetings[fragments[i]].contains(positions.get(i));
    REQUIRE((found || !meets));
    if (meets) ++near;
    if (found) ++compared;
  }
  CHECK(near > 10);
  CHECK(compared < kNodes);  // or looking at boxes first would spare nothing
}

TEST_CASE("rows hold every pair that is near enough, and nodes are compared only where boxes meet") {
  // Sixty small blocks at random: some near each other, most not.
  sim::Blueprint heap;
  for (std::uint64_t b = 0; b < 60; ++b) {
    const Vec3 corner =
        14.0 * Vec3(sim::uniformAt(3, 3 * b), sim::uniformAt(3, 3 * b + 1), sim::uniformAt(3, 3 * b + 2));
    tests::append(heap, tests::block({.nx = 1, .ny = 1, .nz = 1, .corner = corner}));
  }
  const sim::Network network = tests::built(heap);
  const sim::BondLayout layout(network);
  const sim::Components components(network, layout);
  const sim::Breakage breakage(network);
  sim::Motion motion{sim::NodeVectors(network.nodeCount()), sim::NodeVectors(network.nodeCount())};
  for (std::size_t n = 0; n < network.nodeCount(); ++n) motion.position.set(n, network.positions[n]);
  sim::Contacts contacts(network, sim::ContactSettings{.kind = sim::ContactKind::nodes});
  contacts.rebuild(motion, components, breakage, {}, 0.0);
  std::set<std::pair<NodeIndex, NodeIndex>> found;
  contacts.forEachNearPair([&](NodeIndex i, NodeIndex j) { found.emplace(i, j); });
  std::set<std::pair<NodeIndex, NodeIndex>> expected;
  for (NodeIndex i = 0; i < network.nodeCount(); ++i) {
    for (NodeIndex j = i + 1; j < network.nodeCount(); ++j) {
      const double reach = contacts.model().naturalLength(i, j) + contacts.model().pairSkin();
      if (components.of(i) != components.of(j) &&
          (network.positions[j] - network.positions[i]).norm() < reach)
        expected.emplace(i, j);
    }
  }
  CHECK(expected.size() > 20);
  CHECK(found == expected);

  const sim::FragmentBoxes boxes(motion.position, components.fragmentOfNode(), components.births().size());
  const sim::ContactScene scene{motion, components, breakage, {}, boxes, contacts.outside()};
  CHECK(sim::nodesToCompare(contacts.model(), scene).size() < network.nodeCount());
}

TEST_CASE("while fragments are far apart, none of their nodes are compared") {
  const tests::Block shape{.nx = 2, .ny = 2, .nz = 2, .youngsModulus = 1e6};
  sim::Settings settings = tests::losslessSettings();
  settings.contact.kind = sim::ContactKind::nodes;
  const auto crash = tests::simulation(tests::twoBlocks(shape, 6.0, 200.0), settings, tests::earth());
  tests::run(*crash, 0.1);
  CHECK(crash->work().contactPairs > 0);
  CHECK(crash->work().contactSearches > 0);
  CHECK(crash->work().contactSearches < crash->work().neighbourLists);
}

/// A block of stoneware that falls at a speed, seen to the end of the impact; its lowest node, cm.
double lowestOfImpact(double speed, const sim::Environment& environment) {
  sim::Blueprint blueprint = tests::block(
      {.nx = 3, .ny = 3, .nz = 3, .youngsModulus = 6.5e11, .density = 2.4, .corner = Vec3(0.0, 0.0, 0.5)});
  for (sim::Blueprint::Node& node : blueprint.nodes) node.velocity.z() = -speed;
  sim::Settings settings;
  settings.threads = 1;
  const auto impact = tests::simulation(blueprint, settings, environment);
  double lowest = 10.0;
  while (impact->time() < 1.5 / speed) {
    REQUIRE(impact->stepOnce().ok());
    for (const Vec3& position : impact->snapshot().positions) lowest = std::min(lowest, position.z());
  }
  CHECK(impact->maxRise() < 0.005);
  CHECK(impact->snapshot().ledger.linearMomentum.z() > 0.0);  // thrown back as a whole
  return lowest;
}

TEST_CASE("stoneware passes neither through the floor nor through a thin plate at 100 m/s") {
  constexpr double kSpeed = 1e4;
  sim::Environment plate = tests::weightless();
  sim::Collider& box = plate.colliders.emplace_back();
  box.shape = sim::BoxShape{Vec3(10.0, 10.0, 0.25)};
  box.position = Vec3(1.5, 1.5, -0.25);
  // Let in by v / omega of the corner nodes, 0.05, and twice that as the block goes on pressing.
  CHECK(lowestOfImpact(kSpeed, tests::earth()) > -0.25);
  CHECK(lowestOfImpact(kSpeed, plate) > -0.25);
}

TEST_CASE("a step never takes a node further than a quarter of its size where it may hit something") {
  // Sound travels at 1000 cm/s in it: by itself the lattice would allow steps of half a cell's length and
  // more.
  constexpr double kSpeed = 1e4;
  sim::Blueprint soft = tests::block({.youngsModulus = 1e6, .corner = Vec3(0.0, 0.0, 2.0)});
  for (sim::Blueprint::Node& node : soft.nodes) node.velocity.z() = -kSpeed;
  sim::Settings settings;
  settings.threads = 1;
  const auto fall = tests::simulation(soft, settings, tests::earth());
  REQUIRE(fall->stepOnce().ok());
  CHECK(fall->time() * kSpeed <= 0.25 * (1.0 + 1e-12));
  const auto flight = tests::simulation(soft, settings);
  REQUIRE(flight->stepOnce().ok());
  CHECK(flight->time() * kSpeed > 1.0);
}

/// Of the same material and part.
void addFragment(sim::Blueprint& heap, const sim::Blueprint& fragment) {
  const auto first = static_cast<NodeIndex>(heap.nodes.size());
  heap.materials = fragment.materials;
  heap.partNames = fragment.partNames;
  heap.nodes.insert(heap.nodes.end(), fragment.nodes.begin(), fragment.nodes.end());
  for (sim::BlueprintBond bond : fragment.bonds) {
    bond.a += first;
    bond.b += first;
    heap.bonds.push_back(bond);
  }
}

TEST_CASE("a thousand fragments on a heap stay finite and keep out of the floor") {
  sim::Blueprint heap;
  for (unsigned n = 0; n < 1000; ++n) {
    const Vec3 place(static_cast<double>(n % 10), static_cast<double>(n / 10 % 10),
                     static_cast<double>(n / 100));
    const Vec3 shake(sim::uniformAt(1, 3 * n), sim::uniformAt(1, 3 * n + 1), sim::uniformAt(1, 3 * n + 2));
    const sim::Blueprint cube = tests::block({.nx = 1,
                                              .ny = 1,
                                              .nz = 1,
                                              .youngsModulus = 1e7,
                                              .corner = 1.9 * place + 0.2 * shake + Vec3(0.0, 0.0, 0.3),
                                              .velocity = 400.0 * (Vec3::Constant(0.5) - shake)});
    addFragment(heap, cube);
  }
  sim::Settings settings;
  settings.threads = 2;
  const auto fall = tests::simulation(heap, settings, tests::earth());
  tests::run(*fall, 0.012);
  CHECK(fall->snapshot().fragments.size() == 1000);
  double lowest = 10.0;
  for (const Vec3& position : fall->snapshot().positions) {
    REQUIRE(position.allFinite());
    lowest = std::min(lowest, position.z());
  }
  // A column of ten cubes that come down at 400 cm/s; one node is let in by v / omega = 0.1.
  CHECK(lowest > -0.5);
  CHECK(fall->maxRise() < 0.005);
}

}  // namespace

namespace {

constexpr std::size_t kScattered = 400;

Vec3 scattered(std::uint64_t seed, std::uint64_t node) {
  return {sim::uniformAt(seed, 3 * node), sim::uniformAt(seed, 3 * node + 1),
          sim::uniformAt(seed, 3 * node + 2)};
}

}  // namespace

TEST_CASE("what nodes share of a motion brings none together, and no two are nearer than is said",
          "[contact]") {
  const Eigen::Matrix3d spin = Eigen::AngleAxisd(2.5, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  for (const double noise : {0.0, 0.01, 0.1}) {
    for (const double growth : {1.0, 3.0, 0.9}) {
      sim::NodeVectors from(kScattered);
      sim::NodeVectors to(kScattered);
      for (std::size_t node = 0; node < kScattered; ++node) {
        from.set(node, scattered(1, node));
        to.set(node,
               Vec3(5.0, -7.0, 11.0) + growth * (spin * scattered(1, node)) + noise * scattered(2, node));
      }
      const sim::SharedMotion shared(from, to);
      // Turned, carried away and blown up, nodes are no nearer to each other; the fit is right to 1e-5 of the
      // extent, since it is steadied by 1e-6 of its square.
      if (noise == 0.0) CHECK(shared.nearest(0.2) > std::min(growth, 1.0) * 0.2 - 1e-4);
      std::size_t wrong = 0;
      for (std::size_t a = 0; a < kScattered; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          const double before = (from.get(a) - from.get(b)).norm();
          if ((to.get(a) - to.get(b)).norm() < shared.nearest(before) - 1e-12) ++wrong;
        }
      }
      CHECK(wrong == 0);
    }
  }
}
