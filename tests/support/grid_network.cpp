#include "tests/support/grid_network.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace tests {

namespace {

using sim::NodeIndex;

void addEdges(const sim::CellCorners& cell, std::set<std::pair<NodeIndex, NodeIndex>>& edges) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    for (const unsigned axis : {1U, 2U, 4U}) {
      if ((corner & axis) == 0) edges.insert(std::minmax(cell[corner], cell[corner | axis]));
    }
  }
}

}  // namespace

sim::Network gridNetwork(unsigned nx, unsigned ny, unsigned nz,
                         const std::function<sim::Vec3(const sim::Vec3&)>& place, bool ringInX) {
  const unsigned columns = ringInX ? nx : nx + 1;
  const auto node = [=](unsigned i, unsigned j, unsigned k) {
    return ((i % columns) * (ny + 1) + j) * (nz + 1) + k;
  };
  sim::Blueprint blueprint;
  blueprint.materials = {sim::Material{.name = "test"}};
  blueprint.partNames = {"block"};
  for (unsigned i = 0; i < columns; ++i) {
    for (unsigned j = 0; j <= ny; ++j) {
      for (unsigned k = 0; k <= nz; ++k) {
        const sim::Vec3 corner(i, j, k);
        blueprint.nodes.push_back({.position = place ? place(corner) : corner, .mass = 1.0});
      }
    }
  }
  std::set<std::pair<NodeIndex, NodeIndex>> edges;
  for (unsigned i = 0; i < nx; ++i) {
    for (unsigned j = 0; j < ny; ++j) {
      for (unsigned k = 0; k < nz; ++k) {
        sim::CellCorners cell;
        for (unsigned c = 0; c < 8; ++c) cell[c] = node(i + (c & 1U), j + (c >> 1U & 1U), k + (c >> 2U));
        blueprint.cells.push_back(cell);
        addEdges(cell, edges);
      }
    }
  }
  for (const auto& [a, b] : edges) {
    const double length = (blueprint.nodes[a].position - blueprint.nodes[b].position).norm();
    blueprint.bonds.push_back({.a = a, .b = b, .stiffness = 1.0, .restLength = length});
  }
  return sim::buildNetwork(std::move(blueprint), 1).value();
}

void breakBetween(const sim::Network& network, double x, sim::Snapshot& moment) {
  sim::Broken broken = *moment.broken;
  const auto isBehind = [&](NodeIndex node) { return network.positions[node].x() > x; };
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    for (auto bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      if (isBehind(node) != isBehind(network.bondEnds[bond])) broken.bonds[bond] = 1;
    }
  }
  for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    for (const NodeIndex node : network.cells[cell]) {
      if (isBehind(node) != isBehind(network.cells[cell][0])) broken.cells[cell] = 1;
    }
  }
  moment.broken = sim::sealed(std::move(broken));
}

}  // namespace tests
