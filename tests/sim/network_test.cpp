#include "sim/network/network.h"

#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "tests/support/spring_network.h"

namespace {

using sim::BondIndex;
using sim::NodeIndex;
using sim::Vec3;

std::string fault(const sim::Result<sim::Network>& result) {
  return result.ok() ? std::string("none") : result.problem().line();
}

TEST_CASE("a built network holds its blueprint's bonds, each once, in order") {
  const sim::Blueprint blueprint = tests::randomNetwork(70, 4);
  const sim::Network network = tests::built(blueprint);
  CHECK_FALSE(network.validate().has_value());
  REQUIRE(network.bondCount() == blueprint.bonds.size());
  for (const sim::BlueprintBond& bond : blueprint.bonds) {
    const BondIndex found = network.findBond(bond.b, bond.a);
    REQUIRE(found != sim::kNone);
    REQUIRE(network.bondStart(found) == std::min(bond.a, bond.b));
    REQUIRE(network.bondEnds[found] == std::max(bond.a, bond.b));
    REQUIRE(network.bond(found).stiffness == Approx(bond.stiffness).epsilon(1e-12));
    REQUIRE(network.bond(found).restLength == Approx(bond.restLength).epsilon(1e-12));
    REQUIRE(network.bond(found).damping == Approx(bond.damping).epsilon(1e-12));
  }
  // And no pair besides.
  std::set<std::pair<NodeIndex, NodeIndex>> pairs;
  for (const sim::BlueprintBond& bond : blueprint.bonds) pairs.insert(std::minmax(bond.a, bond.b));
  for (NodeIndex a = 0; a < 70; ++a) {
    for (NodeIndex b = a + 1; b < 70; ++b)
      REQUIRE((network.findBond(a, b) != sim::kNone) == (pairs.count({a, b}) > 0));
  }
}

TEST_CASE("a regular block has a few classes of bonds, whatever its size") {
  const sim::Network network = tests::built(tests::block({.nx = 5, .ny = 6, .nz = 7, .spacing = 0.1}));
  CHECK(network.bondCount() > 2000);
  CHECK(network.classes.size() <= 6);  // three kinds, and those whose lengths round to the other side
}

TEST_CASE("the full pattern has 28 bonds a cell, the others what the paper draws") {
  const auto bonds = [](tests::Pattern pattern) {
    return tests::built(tests::block({.nx = 1, .ny = 1, .nz = 1, .pattern = pattern})).bondCount();
  };
  CHECK(bonds(tests::Pattern::full) == 28);
  CHECK(bonds(tests::Pattern::edgesAndBody) == 16);
  CHECK(bonds(tests::Pattern::edgesAndHalfFaces) == 18);
  CHECK(bonds(tests::Pattern::edgesAndFaces) == 24);
}

TEST_CASE("a node's radius is the distance to its nearest bonded neighbour at rest") {
  sim::Blueprint row = tests::chain(4);
  row.bonds[1].restLength = 0.25;
  row.nodes.push_back({.position = Vec3(9.0, 9.0, 9.0), .mass = 1.0});
  const sim::Network network = tests::built(row);
  CHECK(network.radii == std::vector<float>{1.0F, 0.25F, 0.25F, 1.0F, 0.0F});
}

TEST_CASE("what cannot be a network is refused, and the offender named") {
  const auto refused = [](auto&& spoil) {
    sim::Blueprint row = tests::chain(6);
    spoil(row);
    return fault(sim::buildNetwork(std::move(row), 1));
  };
  using Blueprint = sim::Blueprint;
  CHECK(refused([](Blueprint&) {}) == "none");
  CHECK_THAT(refused([](Blueprint& row) {
               row.bonds.push_back({2, 1, 1.0, 1.0, 0.0, 0});
             }),
             Catch::Contains("between nodes 1 and 2") && Catch::Contains("twice"));
  CHECK_THAT(refused([](Blueprint& row) { row.bonds[3].b = 6; }), Catch::Contains("between nodes 3 and 6"));
  CHECK_THAT(refused([](Blueprint& row) { row.bonds[3].b = 3; }), Catch::Contains("to itself"));
  CHECK_THAT(refused([](Blueprint& row) { row.bonds[2].stiffness = -1.0; }), Catch::Contains("stiffness"));
  CHECK_THAT(refused([](Blueprint& row) { row.bonds[2].stiffness = NAN; }), Catch::Contains("stiffness"));
  CHECK_THAT(refused([](Blueprint& row) { row.bonds[2].restLength = 0.0; }), Catch::Contains("rest length"));
  CHECK_THAT(refused([](Blueprint& row) { row.bonds[2].damping = -1.0; }), Catch::Contains("damping"));
  CHECK_THAT(refused([](Blueprint& row) { row.bonds[2].material = 3; }), Catch::Contains("material"));
  CHECK_THAT(refused([](Blueprint& row) { row.nodes[4].mass = 0.0; }), Catch::Contains("node 4"));
  CHECK_THAT(refused([](Blueprint& row) { row.nodes[4].position.y() = INFINITY; }),
             Catch::Contains("node 4"));
  CHECK_THAT(refused([](Blueprint& row) { row.nodes[4].velocity.y() = NAN; }), Catch::Contains("node 4"));
  CHECK_THAT(refused([](Blueprint& row) { row.nodes[4].part = 1; }), Catch::Contains("node 4"));
  CHECK_THAT(refused([](Blueprint& row) { row.nodes[4].material = 1; }), Catch::Contains("node 4"));
  CHECK_THAT(refused([](Blueprint& row) { row.materials[0].yieldStrain = -1.0; }),
             Catch::Contains("material 0"));
  CHECK_THAT(refused([](Blueprint& row) {
               row.cells.push_back({0, 1, 2, 3, 4, 5, 6, 7});
             }),
             Catch::Contains("cell 0"));
  CHECK_THAT(refused([](Blueprint& row) {
               row.cells.push_back({0, 1, 2, 3, 4, 5, 5, 1});
             }),
             Catch::Contains("cell 0"));
}

TEST_CASE("class indices are kept whether two bytes can hold them or not") {
  const std::vector<std::uint32_t> small = {3, 0, 65535};
  const std::vector<std::uint32_t> large = {3, 0, 65536, 7};
  const std::vector<std::uint32_t> largeFirst = {4000000000, 1};
  for (const std::vector<std::uint32_t>& indices : {small, large, largeFirst}) {
    sim::ClassIndices kept(indices);
    REQUIRE(kept.size() == indices.size());
    CHECK(kept.inFull() == indices);
    for (std::size_t i = 0; i < indices.size(); ++i) CHECK(kept[i] == indices[i]);
    kept.set(1, 70000);
    CHECK(kept[0] == indices[0]);
    CHECK(kept[1] == 70000);
  }
  CHECK(sim::ClassIndices(small).memoryBytes() < sim::ClassIndices(large).memoryBytes());
}

TEST_CASE("an invariant broken by hand is found") {
  const sim::Network sound = tests::built(tests::block({}));
  const auto found = [&](auto&& spoil) {
    sim::Network network = sound;
    spoil(network);
    return network.validate().has_value();
  };
  CHECK_FALSE(found([](sim::Network&) {}));
  CHECK(found([](sim::Network& network) { network.radii.pop_back(); }));
  CHECK(found([](sim::Network& network) { std::swap(network.bondEnds[0], network.bondEnds[1]); }));
  CHECK(found([](sim::Network& network) { network.firstBond[3] = network.firstBond[4] + 1; }));
  CHECK(found([](sim::Network& network) { network.bondClasses.set(5, 1000); }));
  CHECK(found([](sim::Network& network) { network.thresholds[5] = 0.0F; }));
  CHECK(found([](sim::Network& network) { network.masses[5] = NAN; }));
  CHECK(found([](sim::Network& network) { network.cells[0][3] = network.cells[0][0]; }));
}

}  // namespace
