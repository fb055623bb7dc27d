#include "sim/surface/surface_mesh.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "sim/surface/body_surface.h"

namespace sim {

namespace {

/// Whether all that a body's surface depends on is equal in two moments.
bool isAsBefore(const CellComplex& complex, const CellComplex::Body& body, const Broken& before,
                const Broken& now) {
  const Network& network = complex.network();
  for (const CellIndex cell : body.cells) {
    if (before.hasLostCell(cell) != now.hasLostCell(cell)) return false;
  }
  for (const NodeIndex node : body.nodes) {
    if (before.fragmentOfNode[node] != now.fragmentOfNode[node]) return false;
    for (BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      if (before.hasLostBond(bond) != now.hasLostBond(bond)) return false;
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
  BrokenPointer before;             ///< of the last call; null before the first
  std::vector<SurfaceTopology> bodies;
  SurfaceTopology all;  ///< of the bodies and of what no body has
  std::size_t rebuilt = 0;

  void update(const Broken& broken);
};

SurfaceBuilder::SurfaceBuilder(const Network& network, LooseNodes looseNodes)
    : parts_(std::make_unique<Parts>(network, looseNodes)) {}
SurfaceBuilder::~SurfaceBuilder() = default;
SurfaceBuilder::SurfaceBuilder(SurfaceBuilder&&) noexcept = default;
SurfaceBuilder& SurfaceBuilder::operator=(SurfaceBuilder&&) noexcept = default;

std::size_t SurfaceBuilder::bodiesRebuilt() const {
  return parts_->rebuilt;
}

const SurfaceTopology& SurfaceBuilder::topology(const BrokenPointer& broken) {
  Parts& parts = *parts_;
  assert(broken->fragmentOfNode.size() == parts.complex.network().nodeCount());
  if (parts.before && parts.before->version == broken->version) {
    parts.rebuilt = 0;
  } else {
    parts.update(*broken);
    parts.before = broken;
  }
  return parts.all;
}

void SurfaceBuilder::Parts::update(const Broken& broken) {
  const Network& network = complex.network();
  const std::vector<CellComplex::Body>& places = complex.bodies();
  std::vector<std::size_t> changed;
  for (std::size_t body = 0; body < places.size(); ++body) {
    if (!before || !isAsBefore(complex, places[body], *before, broken)) changed.push_back(body);
  }
  bodies.resize(places.size());
  rebuilt = changed.size();
  const std::vector<float> damage = damageOfNodes(network, broken);
  const CellCuts cuts(complex, broken, looseNodes);
  const bool spheres = looseNodes == LooseNodes::spheres;
  for (const std::size_t body : changed) {
    SurfaceTopology& made = bodies[body];
    made = bodySurface(complex, whole, cuts, places[body], broken, looseNodes, damage);
    if (spheres || looseNodes == LooseNodes::tetrahedra) {
      for (const NodeIndex node : places[body].nodes) {
        if (cuts.isLoose(node))
          addLooseBody(network, broken, node, spheres, volumeAt(node), damage[node], made);
      }
    }
    finishTopology(made);
  }

  all = {};
  for (const SurfaceTopology& body : bodies) appendTopology(all, body);
  SurfaceTopology bare;
  for (const NodeIndex node : complex.bareNodes()) {
    if (cuts.isLoose(node)) addLooseBody(network, broken, node, spheres, volumeAt(node), damage[node], bare);
  }
  finishTopology(bare);
  appendTopology(all, bare);
}

SurfaceMesh SurfaceBuilder::build(const Snapshot& moment) {
  assert(moment.positions.size() == parts_->complex.network().nodeCount());
  return placeSurface(topology(moment.broken), moment.positions);
}

Snapshot momentAtRest(const Network& network) {
  Snapshot moment;
  moment.positions = network.positions;
  moment.velocities = network.velocities;
  Broken broken;
  broken.bonds.assign(network.bondCount(), 0);
  broken.cells.assign(network.cellCount(), 0);
  broken.fragmentOfNode.resize(network.nodeCount());
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
    broken.fragmentOfNode[node] = first == node ? next++ : broken.fragmentOfNode[first];
  }
  moment.broken = sealed(std::move(broken));
  return moment;
}

}  // namespace sim
