#include "sim/network/network.h"

#include <algorithm>
#include <cmath>

#include "sim/network/wedge.h"

namespace sim {
namespace {

std::string numbered(const char* kind, std::size_t index, const std::string& rest) {
  return std::string(kind) + " " + std::to_string(index) + " " + rest;
}

bool finite(const Vec3& vector) {
  return vector.allFinite();
}

std::optional<std::string> checkNodes(const Network& network) {
  const std::size_t count = network.nodeCount();
  if (network.velocities.size() != count || network.masses.size() != count || network.radii.size() != count ||
      network.nodeMaterials.size() != count || network.nodeParts.size() != count) {
    return "the node arrays differ in length";
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!finite(network.positions[i])) return numbered("node", i, "has no finite position");
    if (!finite(network.velocities[i])) return numbered("node", i, "has no finite velocity");
    if (!(network.masses[i] > 0.0)) return numbered("node", i, "has no positive mass");
    if (!(network.radii[i] >= 0.0F) || !std::isfinite(network.radii[i]))
      return numbered("node", i, "has no proper radius");
    if (network.nodeMaterials[i] >= network.materials.size()) return numbered("node", i, "names no material");
    if (network.nodeParts[i] >= network.partNames.size()) return numbered("node", i, "names no part");
  }
  return std::nullopt;
}

std::optional<std::string> checkBonds(const Network& network) {
  const std::size_t nodes = network.nodeCount();
  const std::size_t bonds = network.bondCount();
  if (network.bondClasses.size() != bonds || network.thresholds.size() != bonds)
    return "the bond arrays differ in length";
  if (network.firstBond.size() != nodes + 1 || network.firstBond.front() != 0 ||
      network.firstBond.back() != bonds) {
    return "the rows of bonds do not cover the bonds";
  }
  for (std::size_t a = 0; a < nodes; ++a) {
    if (network.firstBond[a] > network.firstBond[a + 1] || network.firstBond[a + 1] > bonds)
      return numbered("node", a, "has a row of bonds that is none");
    NodeIndex previous = static_cast<NodeIndex>(a);
    for (BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
      if (network.bondEnds[b] <= previous) return numbered("bond", b, "is out of order or stands twice");
      if (network.bondEnds[b] >= nodes) return numbered("bond", b, "names a node that is not there");
      if (network.bondClasses[b] >= network.classes.size()) return numbered("bond", b, "names no class");
      if (!(network.thresholds[b] > 0.0F)) return numbered("bond", b, "has no positive threshold");
      previous = network.bondEnds[b];
    }
  }
  return std::nullopt;
}

std::optional<std::string> checkConstants(const Network& network) {
  for (std::size_t c = 0; c < network.classes.size(); ++c) {
    const BondClass& bond = network.classes[c];
    const bool proper = std::isfinite(bond.stiffness) && bond.stiffness > 0.0 &&
                        std::isfinite(bond.restLength) && bond.restLength > 0.0 &&
                        std::isfinite(bond.damping) && bond.damping >= 0.0 &&
                        bond.material < network.materials.size();
    if (!proper) return numbered("bond class", c, "has a constant that is not finite and positive");
  }
  for (std::size_t m = 0; m < network.materials.size(); ++m) {
    const Material& material = network.materials[m];
    const bool proper = material.thresholdMean > 0.0 && material.thresholdSpread >= 0.0 &&
                        material.yieldStrain > 0.0 && material.flowRate >= 0.0 &&
                        std::isfinite(material.thresholdSpread) && std::isfinite(material.flowRate);
    if (!proper) return numbered("material", m, "has a constant out of range");
  }
  return std::nullopt;
}

std::optional<std::string> checkCells(const Network& network) {
  for (std::size_t c = 0; c < network.cellCount(); ++c) {
    const CellCorners& corners = network.cells[c];
    if (*std::max_element(corners.begin(), corners.end()) >= network.nodeCount())
      return numbered("cell", c, "names a node that is not there");
    if (!isProperWedge(corners))
      return numbered("cell", c, "names a node at corners that are not neighbours");
  }
  return std::nullopt;
}

}  // namespace

Network::Network() = default;
Network::Network(const Network& other) = default;
Network::Network(Network&& other) noexcept = default;
Network& Network::operator=(const Network& other) = default;
Network& Network::operator=(Network&& other) noexcept = default;
Network::~Network() = default;

NodeIndex Network::bondStart(BondIndex bond) const {
  const auto after = std::upper_bound(firstBond.begin(), firstBond.end(), bond);
  return static_cast<NodeIndex>(after - firstBond.begin()) - 1;
}

BondIndex Network::findBond(NodeIndex a, NodeIndex b) const {
  if (a > b) std::swap(a, b);
  const auto first = bondEnds.begin() + firstBond[a];
  const auto last = bondEnds.begin() + firstBond[a + 1];
  const auto found = std::lower_bound(first, last, b);
  if (found == last || *found != b) return kNone;
  return static_cast<BondIndex>(found - bondEnds.begin());
}

std::optional<std::string> Network::validate() const {
  for (const auto check : {checkNodes, checkBonds, checkConstants, checkCells}) {
    if (auto fault = check(*this)) return fault;
  }
  return std::nullopt;
}

std::size_t Network::memoryBytes() const {
  const auto bytes = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return bytes(positions) + bytes(velocities) + bytes(masses) + bytes(radii) + bytes(nodeMaterials) +
         bytes(nodeParts) + bytes(firstBond) + bytes(bondEnds) + bondClasses.memoryBytes() +
         bytes(thresholds) + bytes(classes) + bytes(cells);
}

}  // namespace sim
