#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>

#include "sim/network/network.h"
#include "sim/network/thresholds.h"

namespace sim {
namespace {

/// Constants rounded to 40 bits of mantissa (1e-12 relative): bonds of congruent cells differ by rounding
/// only, and must share a class. Two values that straddle a rounding boundary fall into two classes, which
/// costs speed, not truth.
struct ClassKey {
  std::uint64_t stiffness, restLength, damping;
  MaterialIndex material;
  bool operator==(const ClassKey&) const = default;
};

std::uint64_t rounded(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  constexpr int kDropped = 12;
  return (bits + (1ULL << (kDropped - 1))) >> kDropped;
}

struct ClassKeyHash {
  std::size_t operator()(const ClassKey& key) const {
    std::uint64_t hash = key.stiffness * 0x9e3779b97f4a7c15ULL;
    hash = (hash ^ (hash >> 29) ^ key.restLength) * 0xbf58476d1ce4e5b9ULL;
    hash = (hash ^ (hash >> 31) ^ key.damping ^ (std::uint64_t{key.material} << 48)) * 0x94d049bb133111ebULL;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

std::string bondName(const BlueprintBond& bond) {
  return "the bond between nodes " + std::to_string(bond.a) + " and " + std::to_string(bond.b);
}

std::optional<Problem> checkBonds(const Blueprint& blueprint) {
  for (const BlueprintBond& bond : blueprint.bonds) {
    if (bond.a >= blueprint.nodes.size() || bond.b >= blueprint.nodes.size()) {
      return Problem{"", bondName(bond) + " names a node that is not there",
                     "there are " + std::to_string(blueprint.nodes.size())};
    }
    if (bond.a == bond.b) return Problem{"", bondName(bond) + " joins a node to itself", "leave it out"};
    if (!std::isfinite(bond.stiffness) || bond.stiffness <= 0.0) {
      return Problem{"", bondName(bond) + " has no positive stiffness", "leave out bonds that do nothing"};
    }
    if (!std::isfinite(bond.restLength) || bond.restLength <= 0.0) {
      return Problem{"", bondName(bond) + " has no positive rest length", "move its nodes apart"};
    }
    if (!std::isfinite(bond.damping) || bond.damping < 0.0) {
      return Problem{"", bondName(bond) + " has negative damping", "use 0 or more"};
    }
    if (bond.material >= blueprint.materials.size()) {
      return Problem{"", bondName(bond) + " names a material that is not there",
                     "there are " + std::to_string(blueprint.materials.size())};
    }
  }
  return std::nullopt;
}

void sortBonds(std::vector<BlueprintBond>& bonds) {
  for (BlueprintBond& bond : bonds) {
    if (bond.a > bond.b) std::swap(bond.a, bond.b);
  }
  std::stable_sort(bonds.begin(), bonds.end(), [](const BlueprintBond& left, const BlueprintBond& right) {
    return std::pair(left.a, left.b) < std::pair(right.a, right.b);
  });
}

void copyNodes(const Blueprint& blueprint, Network& network) {
  const std::size_t count = blueprint.nodes.size();
  network.positions.reserve(count);
  network.velocities.reserve(count);
  network.masses.reserve(count);
  network.nodeMaterials.reserve(count);
  network.nodeParts.reserve(count);
  for (const Blueprint::Node& node : blueprint.nodes) {
    network.positions.push_back(node.position);
    network.velocities.push_back(node.velocity);
    network.masses.push_back(node.mass);
    network.nodeMaterials.push_back(node.material);
    network.nodeParts.push_back(node.part);
  }
}

void copyBonds(const Blueprint& blueprint, Network& network) {
  const std::size_t count = blueprint.bonds.size();
  network.firstBond.assign(blueprint.nodes.size() + 1, 0);
  network.bondEnds.reserve(count);
  network.bondClasses.reserve(count);
  std::unordered_map<ClassKey, std::uint32_t, ClassKeyHash> classOf;
  for (const BlueprintBond& bond : blueprint.bonds) {
    ++network.firstBond[bond.a + 1];
    network.bondEnds.push_back(bond.b);
    const ClassKey key{rounded(bond.stiffness), rounded(bond.restLength), rounded(bond.damping),
                       bond.material};
    const auto [entry, fresh] = classOf.try_emplace(key, static_cast<std::uint32_t>(network.classes.size()));
    if (fresh) network.classes.push_back({bond.stiffness, bond.restLength, bond.damping, bond.material});
    network.bondClasses.push_back(entry->second);
  }
  for (std::size_t a = 0; a < blueprint.nodes.size(); ++a) network.firstBond[a + 1] += network.firstBond[a];
}

void findRadii(Network& network) {
  network.radii.assign(network.nodeCount(), std::numeric_limits<float>::max());
  for (NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
      const float length = static_cast<float>(network.bond(b).restLength);
      network.radii[a] = std::min(network.radii[a], length);
      network.radii[network.bondEnds[b]] = std::min(network.radii[network.bondEnds[b]], length);
    }
  }
  for (float& radius : network.radii) {
    if (radius == std::numeric_limits<float>::max()) radius = 0.0F;
  }
}

}  // namespace

Result<Network> buildNetwork(Blueprint blueprint, std::uint64_t seed) {
  if (blueprint.nodes.size() >= kNone || blueprint.bonds.size() >= kNone) {
    return Problem{"", "the network has over four thousand million nodes or bonds", "use larger cells"};
  }
  if (auto problem = checkBonds(blueprint)) return *problem;
  sortBonds(blueprint.bonds);
  const auto twin = std::adjacent_find(
      blueprint.bonds.begin(), blueprint.bonds.end(),
      [](const auto& left, const auto& right) { return left.a == right.a && left.b == right.b; });
  if (twin != blueprint.bonds.end())
    return Problem{"", bondName(*twin) + " stands twice", "keep one bond a pair"};

  Network network;
  network.materials = blueprint.materials;
  network.partNames = blueprint.partNames;
  copyNodes(blueprint, network);
  copyBonds(blueprint, network);
  network.cells = std::move(blueprint.cells);
  network.cells.shrink_to_fit();
  findRadii(network);
  network.thresholds.reserve(network.bondCount());
  for (BondIndex b = 0; b < network.bondCount(); ++b) {
    network.thresholds.push_back(variedThreshold(network.materials[network.bond(b).material], seed, b));
  }
  if (auto fault = network.validate()) return Problem{"", *fault, ""};
  return network;
}

}  // namespace sim
