#include "tests/modeling/lattice_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "modeling/shapes/quality.h"

namespace tests {
namespace {

using modeling::Lattice;
using sim::NodeIndex;
using Face = std::array<NodeIndex, 4>;

// Counter-clockwise seen from outside a right-handed cell.
constexpr std::array<std::array<std::size_t, 4>, 6> kFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

std::optional<std::string> brokenNodeRule(const Lattice& lattice) {
  if (lattice.parameters.size() != lattice.nodes.size()) return "parameters and nodes differ in number";
  std::vector<bool> used(lattice.nodes.size(), false);
  for (const auto& cell : lattice.cells)
    for (const NodeIndex corner : cell) {
      if (corner >= lattice.nodes.size()) return "a corner is no node";
      used[corner] = true;
    }
  if (std::find(used.begin(), used.end(), false) != used.end()) return "a node has no cell";
  for (const auto& parameter : lattice.parameters)
    if (!(parameter.minCoeff() >= 0.0 && parameter.maxCoeff() <= 1.0)) return "a parameter is outside [0, 1]";
  // A tenth of the shortest edge: two nodes nearer than that are one node twice.
  const double grain = 0.1 * modeling::measure(lattice).minEdge;
  std::set<std::array<long long, 3>> places;
  for (const auto& node : lattice.nodes) {
    std::array<long long, 3> place{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[axis] = std::llround(node[static_cast<Eigen::Index>(axis)] / grain);
    if (!places.insert(place).second) return "two nodes are in one place";
  }
  return std::nullopt;
}

std::optional<std::string> brokenFaceRule(const Lattice& lattice) {
  std::map<Face, std::pair<int, Face>> faces;
  for (const auto& cell : lattice.cells)
    for (const auto& corners : kFaces) {
      Face face{}, key{};
      for (std::size_t i = 0; i < 4; ++i) face[i] = key[i] = cell[corners[i]];
      std::sort(key.begin(), key.end());
      auto& [count, outline] = faces[key];
      ++count;
      outline = face;
    }
  std::map<std::pair<NodeIndex, NodeIndex>, int> edges;
  for (const auto& [key, entry] : faces) {
    if (entry.first > 2) return "a face belongs to more than two cells";
    if (entry.first == 2) continue;
    for (std::size_t i = 0; i < 4; ++i) ++edges[{entry.second[i], entry.second[(i + 1) % 4]}];
  }
  for (const auto& [edge, count] : edges) {
    const auto opposite = edges.find({edge.second, edge.first});
    if (count != 1 || opposite == edges.end() || opposite->second != 1) return "the surface is not closed";
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> brokenLatticeRule(const Lattice& lattice) {
  if (lattice.cells.empty()) return "no cells";
  if (auto broken = brokenNodeRule(lattice)) return broken;
  if (auto broken = brokenFaceRule(lattice)) return broken;
  if (!(modeling::measure(lattice).minScaledJacobian > 0.0)) return "a cell is turned inside out";
  return std::nullopt;
}

double consecutiveShare(const Lattice& lattice) {
  std::set<std::pair<NodeIndex, NodeIndex>> edges;
  for (const auto& cell : lattice.cells)
    for (std::size_t corner = 0; corner < 8; ++corner)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t other = corner | (std::size_t{1} << axis);
        if (other != corner) edges.insert(std::minmax(cell[corner], cell[other]));
      }
  const auto consecutive = std::count_if(edges.begin(), edges.end(),
                                         [](const auto& edge) { return edge.second == edge.first + 1; });
  return static_cast<double>(consecutive) / static_cast<double>(edges.size());
}

}  // namespace tests
