#include "sim/surface/surface_mesh.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "sim/surface/body_surface.h"

namespace sim {

namespace {

/// Whether all that a body's surface depends on is equal in two moments.
bool isAsBefore(const CellComplex& complex, const CellComplex::Body& body, const Snapshot& before,
                const Snapshot& now) {
  const auto equal = [](const auto& a, const auto& b, std::size_t i) {
    return (a.empty() ? std::uint8_t{0} : a[i]) == (b.empty() ? std::uint8_t{0} : b[i]);
  };
  const Network& network = complex.network();
  for (const CellIndex cell : body.cells) {
    if (!equal(before.brokenCells, now.brokenCells, cell)) return false;
  }
  for (const NodeIndex node : body.nodes) {
    if (before.fragmentOfNode[node] != now.fragmentOfNode[node]) return false;
    for (BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      if (!equal(before.brokenBonds, now.brokenBonds, bond)) return false;
    }
  }
  return true;
}

}  // namespace

struct SurfaceBuilder::Parts {
  Parts(const Network& network, LooseNodes loose) : complex(network), whole(complex), looseNodes(loose) {
    if (loose == LooseNodes::spheres || loose == LooseNodes::tetrahedra)
      nodeVolumes = volumesOfNodes(network);
  }
  /// Of what is drawn at a loose node.
  double volumeAt(NodeIndex node) const { return nodeVolumes.empty() ? 0.0 : nodeVolumes[node]; }

  CellComplex complex;
  WholeOutside whole;
  LooseNodes looseNodes;
  std::vector<double> nodeVolumes;  ///< only for bodies drawn in place of shards
  Snapshot before;                  ///< what is broken, and fragments, of the last call; no positions
  std::vector<SurfaceTopology> bodies;
  std::size_t rebuilt = 0;
};

SurfaceBuilder::SurfaceBuilder(const Network& network, LooseNodes looseNodes)
    : parts_(std::make_unique<Parts>(network, looseNodes)) {}
SurfaceBuilder::~SurfaceBuilder() = default;
SurfaceBuilder::SurfaceBuilder(SurfaceBuilder&&) noexcept = default;
SurfaceBuilder& SurfaceBuilder::operator=(SurfaceBuilder&&) noexcept = default;

std::size_t SurfaceBuilder::bodiesRebuilt() const {
  return parts_->rebuilt;
}

SurfaceTopology SurfaceBuilder::topology(const Snapshot& moment) {
  Parts& parts = *parts_;
  const Network& network = parts.complex.network();
  assert(moment.fragmentOfNode.size() == network.nodeCount());
  const auto& bodies = parts.complex.bodies();
  std::vector<std::size_t> changed;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    if (parts.bodies.empty() || !isAsBefore(parts.complex, bodies[body], parts.before, moment))
      changed.push_back(body);
  }
  parts.bodies.resize(bodies.size());
  parts.rebuilt = changed.size();
  const std::vector<float> damage = damageOfNodes(network, moment);
  const CellCuts cuts(parts.complex, moment, parts.looseNodes);
  const bool spheres = parts.looseNodes == LooseNodes::spheres;
  for (const std::size_t body : changed) {
    SurfaceTopology& made = parts.bodies[body];
    made = bodySurface(parts.complex, parts.whole, cuts, bodies[body], moment, parts.looseNodes, damage);
    if (spheres || parts.looseNodes == LooseNodes::tetrahedra) {
      for (const NodeIndex node : bodies[body].nodes) {
        if (cuts.isLoose(node))
          addLooseBody(network, moment, node, spheres, parts.volumeAt(node), damage[node], made);
      }
    }
    finishTopology(made);
  }
  parts.before.brokenBonds = moment.brokenBonds;
  parts.before.brokenCells = moment.brokenCells;
  parts.before.fragmentOfNode = moment.fragmentOfNode;

  SurfaceTopology all;
  for (const SurfaceTopology& body : parts.bodies) appendTopology(all, body);
  SurfaceTopology bare;
  for (const NodeIndex node : parts.complex.bareNodes()) {
    if (cuts.isLoose(node))
      addLooseBody(network, moment, node, spheres, parts.volumeAt(node), damage[node], bare);
  }
  finishTopology(bare);
  appendTopology(all, bare);
  return all;
}

SurfaceMesh SurfaceBuilder::build(const Snapshot& moment) {
  assert(moment.positions.size() == parts_->complex.network().nodeCount());
  return placeSurface(topology(moment), moment.positions);
}

Snapshot momentAtRest(const Network& network) {
  Snapshot moment;
  moment.positions = network.positions;
  moment.velocities = network.velocities;
  moment.brokenBonds.assign(network.bondCount(), 0);
  moment.brokenCells.assign(network.cellCount(), 0);
  moment.fragmentOfNode.resize(network.nodeCount());
  std::vector<NodeIndex> root(network.nodeCount());
  std::iota(root.begin(), root.end(), NodeIndex{0});
  const auto find = [&root](NodeIndex node) {
    while (root[node] != node) node = root[node] = root[root[node]];
    return node;
  };
  const auto join = [&](NodeIndex a, NodeIndex b) {
    const auto [low, high] = std::minmax({find(a), find(b)});
    root[high] = low;
  };
  for (NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (BondIndex bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond) {
      join(a, network.bondEnds[bond]);
    }
  }
  FragmentId next = 0;
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const NodeIndex first = find(node);
    moment.fragmentOfNode[node] = first == node ? next++ : moment.fragmentOfNode[first];
  }
  return moment;
}

}  // namespace sim
