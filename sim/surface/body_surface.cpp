#include "sim/surface/body_surface.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <tuple>

#include <Eigen/LU>

namespace sim {

namespace {

class BodySurface {
 public:
  BodySurface(const CellComplex& complex, const WholeOutside& whole, const CellCuts& cuts,
              const CellComplex::Body& body, const Broken& broken, LooseNodes looseNodes,
              const std::vector<float>& damage)
      : complex_(complex),
        cuts_(cuts),
        broken_(broken),
        dropsLoose_(looseNodes == LooseNodes::tetrahedra || looseNodes == LooseNodes::spheres),
        damage_(damage),
        net_(complex, whole, cuts, body),
        pointsOfVertex_(net_.vertices().size()) {
    for (auto& points : pointsOfVertex_) points.fill(kNone);
    for (const std::uint32_t place : body.outsideFaces) addOutside(place);
    for (const CrackNet::Interface& interface : net_.interfaces()) addInterface(interface);
  }

  SurfaceTopology take() { return std::move(topology_); }

 private:
  /// What a face is of.
  enum class Ground : std::uint8_t { seen, covered, broken };

  bool isDropped(NodeIndex node) const { return dropsLoose_ && cuts_.isLoose(node); }

  void addOutside(std::uint32_t place) {
    const std::uint32_t face = complex_.outsideFaces()[place];
    const CellIndex cell = face / kCellSides;
    const Ground ground = complex_.isCovered(face) ? Ground::covered : Ground::seen;
    const SideNodes nodes = complex_.nodesOf(face);
    const CrackNet::DividedFace* divided = net_.dividedFace(place);
    if (divided != nullptr && divided->cut) {
      addQuarters(*divided, cell, nodes, ground);
    } else if (isDropped(nodes.nodes[0])) {
      // A loose node is a piece of its own: none of the others is in one with it.
      return;
    } else if (divided != nullptr) {
      addFan(*divided, cell, nodes, ground);
    } else {
      const auto& [a, b, c, d] = nodes.nodes;
      addFace({pointOf(a), pointOf(b), pointOf(c), pointOf(d)}, cell, a, ground);
    }
  }

  void addQuarters(const CrackNet::DividedFace& divided, CellIndex cell, const SideNodes& nodes,
                   Ground ground) {
    for (std::size_t c = 0; c < nodes.distinct; ++c) {
      const NodeIndex node = nodes.nodes[c];
      if (isDropped(node)) continue;
      const std::size_t after = nodes.isTriangle() && c == 2 ? 3 : c;
      addFace({pointOf(node), pointOf(divided.middles[after], node), pointOf(divided.centre, node),
               pointOf(divided.middles[(c + 3) % 4], node)},
              cell, node, ground);
    }
  }

  void addFan(const CrackNet::DividedFace& divided, CellIndex cell, const SideNodes& nodes, Ground ground) {
    std::vector<std::uint32_t> around;
    for (std::size_t c = 0; c < 4; ++c) {
      if (c < nodes.distinct) around.push_back(pointOf(nodes.nodes[c]));
      if (divided.middles[c] != kNone) around.push_back(pointOf(divided.middles[c], nodes.nodes[c]));
    }
    const std::uint32_t centre = pointOf(divided.centre, nodes.nodes[0]);
    for (std::size_t i = 0; i < around.size(); ++i) {
      const std::uint32_t next = around[(i + 1) % around.size()];
      addFace({centre, around[i], next, next}, cell, nodes.nodes[0], ground);
    }
  }

  void addInterface(const CrackNet::Interface& interface) {
    const CellEdge& edge = kCellEdges[interface.edge];
    const CellCorners& corners = complex_.network().cells[interface.cell];
    for (const bool low : {true, false}) {
      const NodeIndex node = corners[low ? edge.low : edge.high];
      if (isDropped(node)) continue;
      std::array<std::uint32_t, 4> points{};
      for (std::size_t c = 0; c < 4; ++c)
        points[low ? c : (4 - c) % 4] = pointOf(interface.vertices[c], node);
      addFace(points, interface.cell, node, Ground::broken);
    }
  }

  /// Neighbouring points may be equal: of wedges, three make a triangle, and fewer nothing.
  void addFace(const std::array<std::uint32_t, 4>& around, CellIndex cell, NodeIndex owner, Ground ground) {
    std::array<std::uint32_t, 4> points{};
    std::uint8_t count = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      if (around[c] != around[(c + 1) % 4]) points[count++] = around[c];
    }
    if (count < 3) return;
    if (count == 3) points[3] = points[2];
    SurfaceMeshFace& face = topology_.faces.emplace_back();
    face.points = points;
    face.cornerCount = count;
    face.inside = ground == Ground::broken;
    face.covered = ground == Ground::covered;
    face.cell = cell;
    face.material = complex_.materialOf(cell);
    face.part = complex_.partOf(cell);
    face.fragment = broken_.fragmentOfNode[cuts_.carrierOf(owner)];
  }

  std::uint32_t pointOf(NodeIndex node) {
    const auto [entry, isNew] = pointOfNode_.try_emplace(node, 0);
    if (!isNew) return entry->second;
    const NodeIndex carrier = cuts_.carrierOf(node);
    addAnchors({&node, 1}, complex_.network().positions[node], carrier != node);
    return entry->second = static_cast<std::uint32_t>(topology_.pointCount() - 1);
  }

  /// The point that the piece of `node` has at a vertex.
  std::uint32_t pointOf(std::uint32_t vertex, NodeIndex node) {
    const CrackNet::Vertex& at = net_.vertices()[vertex];
    std::uint8_t group = 0;
    while (at.nodes[group] != node) ++group;
    group = at.groups[group];
    std::uint32_t& point = pointsOfVertex_[vertex][group];
    if (point != kNone) return point;
    std::vector<NodeIndex> nodes;
    for (std::uint8_t i = 0; i < at.nodeCount; ++i) {
      if (at.groups[i] == group) nodes.push_back(at.nodes[i]);
    }
    addAnchors(nodes, at.position, true);
    return point = static_cast<std::uint32_t>(topology_.pointCount() - 1);
  }

  void addAnchors(std::span<const NodeIndex> nodes, const Vec3& restPoint, bool fitted) {
    topology_.restPoints.push_back(restPoint);
    topology_.nodeOfPoint.push_back(cuts_.carrierOf(nodes[0]));
    float damage = 0.0F;
    for (const NodeIndex node : nodes) {
      damage += damage_[node] / static_cast<float>(nodes.size());
      if (!fitted) continue;
      const NodeIndex carrier = cuts_.carrierOf(node);
      topology_.anchors.push_back(
          {carrier, fitOf(carrier), restPoint - complex_.network().positions[carrier]});
    }
    topology_.damage.push_back(damage);
    topology_.firstAnchor.push_back(static_cast<std::uint32_t>(topology_.anchors.size()));
  }

  std::uint32_t fitOf(NodeIndex node) {
    const auto [entry, isNew] =
        fitOfNode_.try_emplace(node, static_cast<std::uint32_t>(topology_.fits.size()));
    if (!isNew) return entry->second;
    SurfaceTopology::Fit fit;
    fit.node = node;
    fit.rigid = cuts_.isLoose(node) || cuts_.carriesOthers(node);
    fit.firstSupport = static_cast<std::uint32_t>(topology_.supports.size());
    addSupports(node, cuts_.isLoose(node), fit.rigid);
    // What hangs on a bond alone, in line or in a plane with what it hangs on, has no gradient.
    if (fit.firstSupport == topology_.supports.size()) {
      fit.rigid = true;
      addSupports(node, true, true);
    }
    fit.lastSupport = static_cast<std::uint32_t>(topology_.supports.size());
    topology_.fits.push_back(fit);
    return entry->second;
  }

  /// The other nodes of the cells about a node, with their offsets or the gradients of their least-squares
  /// fit.
  void addSupports(NodeIndex node, bool ofBrokenCells, bool rigid) {
    std::vector<NodeIndex> others;
    for (const CellIndex cell : complex_.cellsOf(node)) {
      if (!ofBrokenCells && cuts_.isBroken(cell)) continue;
      for (const NodeIndex other : complex_.network().cells[cell]) {
        if (other != node) others.push_back(other);
      }
    }
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    const auto& at = complex_.network().positions;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const NodeIndex other : others)
      spread += (at[other] - at[node]) * (at[other] - at[node]).transpose();
    const double scale = spread.trace() / 3.0;
    // A flat spread has determinant 0: below this share of a round one's, gradients would be noise.
    if (!rigid && !(spread.determinant() > 1e-6 * scale * scale * scale)) return;
    const Eigen::Matrix3d inverse = rigid ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : spread.inverse();
    for (const NodeIndex other : others)
      topology_.supports.push_back({other, inverse * (at[other] - at[node])});
  }

  const CellComplex& complex_;
  const CellCuts& cuts_;
  const Broken& broken_;
  bool dropsLoose_;
  const std::vector<float>& damage_;
  CrackNet net_;
  SurfaceTopology topology_;
  std::vector<std::array<std::uint32_t, kCellCorners>> pointsOfVertex_;  ///< by group
  std::unordered_map<NodeIndex, std::uint32_t> pointOfNode_;
  std::unordered_map<NodeIndex, std::uint32_t> fitOfNode_;
};

}  // namespace

SurfaceTopology bodySurface(const CellComplex& complex, const WholeOutside& whole, const CellCuts& cuts,
                            const CellComplex::Body& body, const Broken& broken, LooseNodes looseNodes,
                            const std::vector<float>& damage) {
  return BodySurface(complex, whole, cuts, body, broken, looseNodes, damage).take();
}

std::vector<float> damageOfNodes(const Network& network, const Broken& gone) {
  std::vector<std::uint32_t> all(network.nodeCount(), 0);
  std::vector<std::uint32_t> broken(network.nodeCount(), 0);
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    for (BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      const bool isBroken = gone.hasLostBond(bond);
      for (const NodeIndex end : {node, network.bondEnds[bond]}) {
        ++all[end];
        if (isBroken) ++broken[end];
      }
    }
  }
  std::vector<float> damage(network.nodeCount(), 0.0F);
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    if (all[node] > 0) damage[node] = static_cast<float>(broken[node]) / static_cast<float>(all[node]);
  }
  return damage;
}

void finishTopology(SurfaceTopology& topology) {
  std::stable_sort(topology.faces.begin(), topology.faces.end(), [](const auto& a, const auto& b) {
    return std::tie(a.fragment, a.cell) < std::tie(b.fragment, b.cell);
  });
  groupNormals(topology);
}

}  // namespace sim
