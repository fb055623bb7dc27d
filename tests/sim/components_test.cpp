#include "sim/fracture/components.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "tests/support/spring_network.h"

namespace {

using sim::BondIndex;
using sim::FragmentId;
using sim::NodeIndex;

/// A network whose bonds are taken out one by one.
class Crumbling {
 public:
  explicit Crumbling(sim::Blueprint blueprint)
      : network(tests::built(std::move(blueprint))), layout(network), components(network, layout) {
    whole_.resize(network.bondCount());
    std::iota(whole_.begin(), whole_.end(), 0U);
  }

  /// Takes out `count` whole bonds at random.
  bool remove(std::size_t count, std::uint64_t seed, double time) {
    std::vector<sim::BreakEvent> events;
    for (std::size_t k = 0; k < count && !whole_.empty(); ++k) {
      const auto at = static_cast<std::size_t>(sim::uniformAt(seed, k) * static_cast<double>(whole_.size()));
      events.push_back(take(at, time));
    }
    return components.relabel(layout, events, time);
  }

  sim::BreakEvent take(std::size_t at, double time) {
    const BondIndex bond = whole_[at];
    whole_[at] = whole_.back();
    whole_.pop_back();
    layout.remove(network, bond);
    return {time, bond, network.bondStart(bond), network.bondEnds[bond], 0.0F, sim::kNone};
  }

  /// The lowest node of each node's component, by the plainest of searches.
  std::vector<NodeIndex> lowestNodes() const {
    std::vector<NodeIndex> lowest(network.nodeCount());
    std::iota(lowest.begin(), lowest.end(), 0U);
    for (bool changed = true; changed;) {
      changed = false;
      for (const BondIndex bond : whole_) {
        const NodeIndex a = network.bondStart(bond);
        const NodeIndex b = network.bondEnds[bond];
        const NodeIndex low = std::min(lowest[a], lowest[b]);
        changed = changed || lowest[a] != low || lowest[b] != low;
        lowest[a] = lowest[b] = low;
      }
    }
    return lowest;
  }

  std::size_t wholeCount() const { return whole_.size(); }

  sim::Network network;
  sim::BondLayout layout;
  sim::Components components;

 private:
  std::vector<BondIndex> whole_;
};

/// Labels say of any two nodes what the plain search says, and the births keep count.
void checkLabels(const Crumbling& crumbling) {
  const std::vector<NodeIndex> lowest = crumbling.lowestNodes();
  std::map<NodeIndex, FragmentId> labelOf;
  std::map<FragmentId, std::uint32_t> nodesOf;
  for (NodeIndex node = 0; node < lowest.size(); ++node) {
    const FragmentId label = crumbling.components.of(node);
    REQUIRE(labelOf.try_emplace(lowest[node], label).first->second == label);
    ++nodesOf[label];
  }
  REQUIRE(nodesOf.size() == labelOf.size());
  const auto& births = crumbling.components.births();
  REQUIRE(nodesOf.size() == births.size());  // no fragment ever loses its last node
  for (const auto& [label, count] : nodesOf) REQUIRE(births[label].nodeCount == count);
}

TEST_CASE("labels are those of a search of everything, whatever breaks") {
  const std::uint64_t seed = GENERATE(range(1, 13));
  // From thinly to densely bonded, and a body of cells.
  const auto size = static_cast<unsigned>(20 + 10 * seed);
  Crumbling crumbling(seed % 4 == 0 ? tests::block({.nx = 2, .ny = 3, .nz = 4})
                                    : tests::randomNetwork(size, seed));
  checkLabels(crumbling);
  for (std::uint64_t batch = 0; crumbling.wholeCount() > 0; ++batch) {
    const double time = static_cast<double>(batch);
    const std::vector<FragmentId> before = crumbling.components.fragmentOfNode();
    const std::size_t fragments = crumbling.components.births().size();
    const std::size_t batchSize = 1 + static_cast<std::size_t>(sim::uniformAt(seed + 50, batch) * 12.0);
    const bool born = crumbling.remove(batchSize, seed * 1000 + batch, time);
    checkLabels(crumbling);
    const auto& births = crumbling.components.births();
    REQUIRE(born == (births.size() > fragments));
    for (NodeIndex node = 0; node < before.size(); ++node) {
      const FragmentId now = crumbling.components.of(node);
      if (now == before[node]) continue;
      // A node that changed its fragment is in a newborn one, a child of the one it was in.
      REQUIRE(now >= fragments);
      REQUIRE(births[now].parent == before[node]);
      REQUIRE(births[now].born == time);
    }
  }
}

TEST_CASE("the larger part keeps the name") {
  Crumbling row(tests::chain(100));
  const sim::BreakEvent event = row.take(9, 1.0);
  REQUIRE(row.components.relabel(row.layout, std::vector<sim::BreakEvent>{event}, 1.0));
  CHECK(row.components.of(0) == 1);
  CHECK(row.components.of(50) == 0);
  CHECK(row.components.births()[1].nodeCount == 10);
  CHECK(row.components.births()[1].parent == 0);
}

TEST_CASE("only fragments in which something broke are labelled again") {
  sim::Blueprint three = tests::chain(30);
  tests::append(three, tests::chain(30));
  tests::append(three, tests::chain(30));
  Crumbling rows(std::move(three));
  REQUIRE(rows.components.births().size() == 3);
  CHECK(rows.components.relabelings() == 0);
  const std::vector<sim::BreakEvent> events{rows.take(3, 0.0), rows.take(5, 0.0), rows.take(40, 0.0)};
  rows.components.relabel(rows.layout, events, 0.0);
  CHECK(rows.components.relabelings() == 2);
  rows.components.relabel(rows.layout, {}, 0.0);
  CHECK(rows.components.relabelings() == 2);
  checkLabels(rows);
}

TEST_CASE("a run labels as often as fragments broke, and never where nothing does") {
  tests::Block shape{.nx = 2, .ny = 2, .nz = 6, .youngsModulus = 1e7};
  shape.material.thresholdMean = 0.02;
  sim::Blueprint bar = tests::block(shape);
  for (sim::Blueprint::Node& node : bar.nodes) node.velocity.z() = 80.0 * (node.position.z() - 3.0);
  const auto pulled = tests::simulation(std::move(bar), tests::losslessSettings());
  std::uint64_t breakingSteps = 0;
  while (pulled->time() < 0.004) {
    const std::uint64_t before = pulled->work().labelings;
    REQUIRE(pulled->stepOnce().ok());
    if (pulled->drainBreakEvents().empty()) {
      REQUIRE(pulled->work().labelings == before);
    } else {
      ++breakingSteps;
      REQUIRE(pulled->work().labelings > before);
    }
  }
  CHECK(breakingSteps > 0);
}

TEST_CASE("fragments are described by their nodes") {
  tests::Block shape{.nx = 1, .ny = 1, .nz = 1};
  sim::Blueprint two = tests::twoBlocks(shape, 3.0, 10.0);
  const auto still = tests::simulation(std::move(two), tests::losslessSettings());
  const sim::Snapshot snapshot = still->snapshot();
  REQUIRE(snapshot.fragments.size() == 2);
  REQUIRE(snapshot.broken->fragments.size() == 2);
  const sim::Fragment& second = snapshot.broken->fragments[1];
  CHECK(second.id == 1);
  CHECK(second.parent == sim::kNone);
  CHECK(second.nodeCount == 8);
  CHECK(second.mass == Approx(1.0));
  const sim::MovingFragment& upper = snapshot.fragments[1];
  CHECK(upper.id == 1);
  CHECK((upper.centre - sim::Vec3(0.5, 0.5, 4.5)).norm() < 1e-12);
  CHECK((upper.velocity - sim::Vec3(0.0, 0.0, -5.0)).norm() < 1e-12);
  CHECK((upper.boxMin - sim::Vec3(0.0, 0.0, 4.0)).norm() < 1e-12);
  CHECK((upper.boxMax - sim::Vec3(1.0, 1.0, 5.0)).norm() < 1e-12);
}

}  // namespace
