#include "tests/support/spring_network.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <catch2/catch.hpp>

#include "sim/base/random.h"

namespace tests {
namespace {

using sim::NodeIndex;
using sim::Vec3;

Vec3 randomVector(std::uint64_t seed, std::uint64_t counter) {
  return Vec3(sim::uniformAt(seed, 3 * counter), sim::uniformAt(seed, 3 * counter + 1),
              sim::uniformAt(seed, 3 * counter + 2)) -
         Vec3::Constant(0.5);
}

sim::Blueprint empty(const std::string& name, const sim::Material& material) {
  sim::Blueprint blueprint;
  blueprint.materials = {material};
  blueprint.partNames = {name};
  return blueprint;
}

/// The nodes of a block, numbered with the longest axis innermost.
class Lattice {
 public:
  explicit Lattice(const Block& block) : counts_{block.nx + 1, block.ny + 1, block.nz + 1} {
    std::array<std::size_t, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](auto a, auto b) { return counts_[a] < counts_[b]; });
    stride_[axes[2]] = 1;
    stride_[axes[1]] = counts_[axes[2]];
    stride_[axes[0]] = counts_[axes[2]] * counts_[axes[1]];
  }
  using Place = std::array<unsigned, 3>;
  NodeIndex node(const Place& at) const {
    return at[0] * stride_[0] + at[1] * stride_[1] + at[2] * stride_[2];
  }
  std::size_t size() const { return std::size_t{counts_[0]} * counts_[1] * counts_[2]; }

 private:
  std::array<unsigned, 3> counts_;
  std::array<unsigned, 3> stride_{};
};

/// Relative stiffness of the bond between two corners of a cell, 0 where the pattern has none.
double shareOf(Pattern pattern, unsigned first, unsigned second, const Lattice::Place& cell) {
  const unsigned differ = first ^ second;
  const int axes =
      static_cast<int>(differ & 1U) + static_cast<int>(differ >> 1U & 1U) + static_cast<int>(differ >> 2U);
  const unsigned parity =
      (cell[0] + cell[1] + cell[2] + (first & 1U) + (first >> 1U & 1U) + (first >> 2U)) & 1U;
  if (axes == 1) return 0.6;
  if (axes == 3) return pattern == Pattern::edgesAndBody || pattern == Pattern::full ? 0.15 : 0.0;
  const bool has = pattern == Pattern::edgesAndFaces || pattern == Pattern::full ||
                   (pattern == Pattern::edgesAndHalfFaces && parity == 0);
  return has ? 0.2 : 0.0;
}

void addCell(const Block& block, const Lattice& lattice, const Lattice::Place& at,
             std::set<std::pair<NodeIndex, NodeIndex>>& taken, sim::Blueprint& blueprint) {
  sim::CellCorners corners;
  for (unsigned c = 0; c < 8; ++c)
    corners[c] = lattice.node({at[0] + (c & 1U), at[1] + (c >> 1U & 1U), at[2] + (c >> 2U)});
  blueprint.cells.push_back(corners);
  const double size = block.spacing;
  for (const NodeIndex corner : corners)
    blueprint.nodes[corner].mass += block.density * size * size * size / 8.0;
  for (unsigned i = 0; i < 8; ++i) {
    for (unsigned j = i + 1; j < 8; ++j) {
      const double share = shareOf(block.pattern, i, j, at);
      if (share == 0.0 || !taken.insert(std::minmax(corners[i], corners[j])).second) continue;
      const double stiffness = share * block.youngsModulus * size;
      const double length =
          (blueprint.nodes[corners[i]].position - blueprint.nodes[corners[j]].position).norm();
      blueprint.bonds.push_back(
          {corners[i], corners[j], stiffness, length, stiffness * block.dampingTime, 0});
    }
  }
}

}  // namespace

sim::Blueprint twoNodes(const Pair& pair) {
  sim::Blueprint blueprint = empty("pair", {.name = "spring", .thresholdMean = pair.threshold});
  const Vec3 nearing(0.5 * pair.approach, 0.0, 0.0);
  blueprint.nodes.push_back({.velocity = nearing, .mass = pair.mass});
  blueprint.nodes.push_back(
      {.position = Vec3(pair.distance, 0.0, 0.0), .velocity = -nearing, .mass = pair.mass});
  blueprint.bonds.push_back({0, 1, pair.stiffness, pair.restLength, pair.damping, 0});
  return blueprint;
}

sim::Blueprint chain(unsigned count, double stiffness, double damping) {
  sim::Blueprint blueprint = empty("chain", {.name = "spring"});
  for (unsigned i = 0; i < count; ++i) {
    blueprint.nodes.push_back({.position = Vec3(i, 0.0, 0.0), .mass = 1.0});
    if (i > 0) blueprint.bonds.push_back({i - 1, i, stiffness, 1.0, damping, 0});
  }
  return blueprint;
}

sim::Blueprint block(const Block& block) {
  const Lattice lattice(block);
  sim::Blueprint blueprint = empty("block", block.material);
  blueprint.nodes.resize(lattice.size());
  for (unsigned i = 0; i <= block.nx; ++i) {
    for (unsigned j = 0; j <= block.ny; ++j) {
      for (unsigned k = 0; k <= block.nz; ++k) {
        const NodeIndex node = lattice.node({i, j, k});
        const Vec3 shift = block.distortion * randomVector(block.seed, node);
        blueprint.nodes[node].position = block.corner + block.spacing * (Vec3(i, j, k) + shift);
        blueprint.nodes[node].velocity = block.velocity;
      }
    }
  }
  std::set<std::pair<NodeIndex, NodeIndex>> taken;
  for (unsigned i = 0; i < block.nx; ++i) {
    for (unsigned j = 0; j < block.ny; ++j) {
      for (unsigned k = 0; k < block.nz; ++k) addCell(block, lattice, {i, j, k}, taken, blueprint);
    }
  }
  return blueprint;
}

sim::Blueprint twoBlocks(const Block& lower, double gap, double speed) {
  Block first = lower;
  first.velocity = Vec3(0.0, 0.0, 0.5 * speed);
  Block second = lower;
  second.velocity = -first.velocity;
  second.corner.z() += lower.nz * lower.spacing + gap;
  sim::Blueprint blueprint = block(first);
  append(blueprint, block(second));
  return blueprint;
}

sim::Blueprint randomNetwork(unsigned nodes, std::uint64_t seed, double speed, double strain) {
  sim::Blueprint blueprint = empty("tangle", {.name = "random"});
  for (unsigned n = 0; n < nodes; ++n) {
    blueprint.nodes.push_back({.position = 4.0 * randomVector(seed, n),
                               .velocity = 2.0 * speed * randomVector(seed + 1, n),
                               .mass = 0.5 + sim::uniformAt(seed + 2, n)});
  }
  std::uint64_t draw = 0;
  for (NodeIndex a = 0; a < nodes; ++a) {
    for (NodeIndex b = a + 1; b < nodes; ++b) {
      const double length = (blueprint.nodes[b].position - blueprint.nodes[a].position).norm();
      draw += 4;
      if (length > 1.6 || sim::uniformAt(seed + 3, draw) > 0.7) continue;
      const double stiffness = 100.0 + 900.0 * sim::uniformAt(seed + 3, draw + 1);
      const double rest = length * (1.0 + strain * (2.0 * sim::uniformAt(seed + 3, draw + 2) - 1.0));
      blueprint.bonds.push_back({a, b, stiffness, rest, 2.0 * sim::uniformAt(seed + 3, draw + 3), 0});
    }
  }
  return blueprint;
}

void append(sim::Blueprint& blueprint, const sim::Blueprint& more) {
  const auto nodes = static_cast<NodeIndex>(blueprint.nodes.size());
  const auto materials = static_cast<sim::MaterialIndex>(blueprint.materials.size());
  const auto parts = static_cast<sim::PartIndex>(blueprint.partNames.size());
  for (sim::Blueprint::Node node : more.nodes) {
    node.material = static_cast<sim::MaterialIndex>(node.material + materials);
    node.part = static_cast<sim::PartIndex>(node.part + parts);
    blueprint.nodes.push_back(node);
  }
  for (sim::BlueprintBond bond : more.bonds) {
    bond.a += nodes;
    bond.b += nodes;
    bond.material = static_cast<sim::MaterialIndex>(bond.material + materials);
    blueprint.bonds.push_back(bond);
  }
  for (sim::CellCorners cell : more.cells) {
    for (NodeIndex& corner : cell) corner += nodes;
    blueprint.cells.push_back(cell);
  }
  blueprint.materials.insert(blueprint.materials.end(), more.materials.begin(), more.materials.end());
  blueprint.partNames.insert(blueprint.partNames.end(), more.partNames.begin(), more.partNames.end());
}

sim::Network built(sim::Blueprint blueprint, std::uint64_t seed) {
  return sim::buildNetwork(std::move(blueprint), seed).value();
}

sim::Settings losslessSettings() {
  sim::Settings settings;
  settings.contact.dampingRatio = 0.0;
  settings.contact.friction = 0.0;
  settings.threads = 1;
  return settings;
}

sim::Environment weightless() {
  sim::Environment environment;
  environment.gravity = Vec3::Zero();
  return environment;
}

sim::Environment earth() {
  sim::Environment environment;
  environment.colliders.emplace_back().name = "floor";
  return environment;
}

std::unique_ptr<sim::Simulation> simulation(sim::Blueprint blueprint, const sim::Settings& settings,
                                            sim::Environment environment, std::vector<sim::Track> tracks) {
  return sim::Simulation::create(built(std::move(blueprint), settings.seed), std::move(environment),
                                 std::move(tracks), settings)
      .value();
}

void run(sim::Simulation& simulation, double time) {
  const sim::Status status = simulation.advanceTo(time);
  INFO((status ? std::string() : status.problem().line()));
  REQUIRE(status.ok());
}

}  // namespace tests
