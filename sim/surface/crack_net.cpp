#include "sim/surface/crack_net.h"

#include <algorithm>
#include <cassert>

#include <Eigen/Geometry>

#include "sim/surface/crack_smoothing.h"

namespace sim {

namespace {

SurfaceMesh wholeMesh(const CellComplex& complex) {
  const Network& network = complex.network();
  SurfaceTopology topology;
  std::vector<std::uint32_t> pointOfNode(network.nodeCount(), kNone);
  for (const std::uint32_t face : complex.outsideFaces()) {
    SurfaceMeshFace& added = topology.faces.emplace_back();
    const SideNodes side = complex.nodesOf(face);
    const auto& nodes = side.nodes;
    added.cornerCount = side.distinct;
    for (std::size_t c = 0; c < 4; ++c) {
      std::uint32_t& point = pointOfNode[nodes[c]];
      if (point == kNone) {
        point = static_cast<std::uint32_t>(topology.pointCount());
        topology.restPoints.push_back(network.positions[nodes[c]]);
        topology.nodeOfPoint.push_back(nodes[c]);
        topology.firstAnchor.push_back(0);
      }
      added.points[c] = point;
    }
  }
  groupNormals(topology);
  return placeSurface(topology, network.positions);
}

std::array<Vec3, 8> cornerPositions(const Network& network, CellIndex cell) {
  std::array<Vec3, 8> corners;
  for (std::size_t c = 0; c < 8; ++c) corners[c] = network.positions[network.cells[cell][c]];
  return corners;
}

/// Where the middle of an outside face is: of a triangle, whose third corner is a whole side, in its
/// centroid.
Vec3 middleOf(const CurvedFaces& curved, std::uint32_t place, bool triangle) {
  return curved.point(place, 0.5, triangle ? 1.0 / 3.0 : 0.5);
}

Vec3 localMiddle(std::uint32_t face) {
  Vec3 at = Vec3::Constant(0.5);
  const std::uint32_t side = face % kCellSides;
  at[side / 2] = side % 2;
  return at;
}

Vec3 middleOfSide(const CurvedFaces& curved, std::uint32_t place, std::uint8_t side) {
  static constexpr std::array<std::array<double, 2>, 4> kMiddles{
      {{0.5, 0.0}, {1.0, 0.5}, {0.5, 1.0}, {0.0, 0.5}}};
  return curved.point(place, kMiddles[side][0], kMiddles[side][1]);
}

}  // namespace

WholeOutside::WholeOutside(const CellComplex& complex) : mesh(wholeMesh(complex)), curved(mesh) {}

Eigen::Matrix3d cellSpans(const std::array<Vec3, 8>& corners, const Vec3& at) {
  Eigen::Matrix3d spans = Eigen::Matrix3d::Zero();
  for (unsigned c = 0; c < 8; ++c) {
    double weight[3];
    for (unsigned axis = 0; axis < 3; ++axis)
      weight[axis] = (c >> axis & 1U) != 0 ? at[axis] : 1.0 - at[axis];
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double sign = (c >> axis & 1U) != 0 ? 1.0 : -1.0;
      spans.col(axis) += sign * weight[(axis + 1) % 3] * weight[(axis + 2) % 3] * corners[c];
    }
  }
  return spans;
}

CrackNet::CrackNet(const CellComplex& complex, const WholeOutside& whole, const CellCuts& cuts,
                   const CellComplex::Body& body)
    : complex_(complex), whole_(whole), cuts_(cuts) {
  for (const CellIndex cell : body.cells) {
    if (!cuts.isCut(cell)) continue;
    addInterfaces(cell);
    addCutSides(cell);
  }
  addFans();
  smoothCracks(complex_, whole_, interfaces_, vertices_);
}

void CrackNet::addInterfaces(CellIndex cell) {
  std::uint8_t next = 0;
  for (const CellEdge& edge : kCellEdges) {
    const std::uint8_t e = next++;
    if (cuts_.pieceOf(cell, edge.low) == cuts_.pieceOf(cell, edge.high)) continue;
    const std::uint32_t middle = edgeVertex(cell, edge);
    const std::uint32_t first = sideVertex(cell * kCellSides + edge.firstSide);
    const std::uint32_t centre = cellVertex(cell);
    const std::uint32_t second = sideVertex(cell * kCellSides + edge.secondSide);
    interfaces_.push_back({cell, e, {middle, first, centre, second}});
  }
}

void CrackNet::addCutSides(CellIndex cell) {
  for (std::uint32_t side = 0; side < kCellSides; ++side) {
    const std::uint32_t face = cell * kCellSides + side;
    const std::uint32_t place = complex_.outsidePlace(face);
    if (place == kNone) continue;
    const auto& corners = kSideCorners[side];
    const std::uint8_t piece = cuts_.pieceOf(cell, corners[0]);
    if (std::all_of(corners.begin(), corners.end(),
                    [&](std::uint8_t corner) { return cuts_.pieceOf(cell, corner) == piece; }))
      continue;
    DividedFace divided{.cut = true};
    divided.centre = sideVertex(face);
    const auto nodes = complex_.nodesOf(face).nodes;
    const Eigen::Matrix3d spans = cellSpans(cornerPositions(complex_.network(), cell), localMiddle(face));
    for (std::size_t c = 0; c < 4; ++c) {
      const NodeIndex next = nodes[(c + 1) % 4];
      if (nodes[c] != next) divided.middles[c] = edgeVertex(nodes[c], next, spans);
    }
    dividedFaces_[place] = divided;
    cutPlaces_.push_back(place);
  }
}

/// Faces that are whole beside one that is cut take part in its divided edge.
void CrackNet::addFans() {
  for (const std::uint32_t place : cutPlaces_) {
    const std::array<std::uint32_t, 4> middles = dividedFaces_.at(place).middles;
    const auto nodes = complex_.nodesOf(complex_.outsideFaces()[place]).nodes;
    for (std::size_t c = 0; c < 4; ++c) {
      if (middles[c] == kNone) continue;
      for (const auto& edge : complex_.outsideEdges(nodes[c], nodes[(c + 1) % 4])) {
        DividedFace& divided = dividedFaces_[edge.face];
        if (divided.cut) continue;
        divided.middles[edge.side] = middles[c];
        if (divided.centre == kNone) divided.centre = sideVertex(complex_.outsideFaces()[edge.face]);
      }
    }
  }
}

std::uint32_t CrackNet::edgeVertex(CellIndex cell, const CellEdge& edge) {
  Vec3 at;
  for (unsigned axis = 0; axis < 3; ++axis)
    at[axis] = 0.5 * ((edge.low >> axis & 1U) + (edge.high >> axis & 1U));
  const CellCorners& corners = complex_.network().cells[cell];
  return edgeVertex(corners[edge.low], corners[edge.high],
                    cellSpans(cornerPositions(complex_.network(), cell), at));
}

std::uint32_t CrackNet::edgeVertex(NodeIndex a, NodeIndex b, const Eigen::Matrix3d& spans) {
  const auto [low, high] = std::minmax(a, b);
  const auto [entry, isNew] = vertexOfEdge_.try_emplace(std::uint64_t{low} << 32U | high, 0);
  if (!isNew) return entry->second;
  const auto& at = complex_.network().positions;
  Vertex vertex;
  vertex.start = 0.5 * (at[low] + at[high]);
  vertex.spans = spans;
  vertex.nodes = {low, high};
  vertex.nodeCount = 2;
  vertex.groups = {0, 1};
  for (const CellIndex cell : complex_.cellsOf(low)) joinGroups(vertex, cell);
  placeOnEdge(vertex, complex_.outsideEdges(low, high));
  return entry->second = addVertex(std::move(vertex));
}

std::uint32_t CrackNet::sideVertex(std::uint32_t face) {
  const SideNodes side = complex_.nodesOf(face);
  if (side.hasCollapsed()) return collapsedVertex(face, side);
  std::uint32_t name = face;
  for (std::uint32_t twin = complex_.twinOf(face); twin != face; twin = complex_.twinOf(twin))
    name = std::min(name, twin);
  const auto [entry, isNew] = vertexOfSide_.try_emplace(name, 0);
  if (!isNew) return entry->second;
  Vertex vertex;
  for (std::uint8_t c = 0; c < side.distinct; ++c) {
    vertex.start += complex_.network().positions[side.nodes[c]] / side.distinct;
    vertex.nodes[c] = side.nodes[c];
    vertex.groups[c] = c;
  }
  vertex.nodeCount = side.distinct;
  vertex.spans = cellSpans(cornerPositions(complex_.network(), face / kCellSides), localMiddle(face));
  joinGroups(vertex, face / kCellSides);
  for (std::uint32_t twin = complex_.twinOf(face); twin != face; twin = complex_.twinOf(twin))
    joinGroups(vertex, twin / kCellSides);
  if (const std::uint32_t place = complex_.outsidePlace(face); place != kNone) {
    vertex.outsideFaces = {place};
    vertex.start = middleOf(whole_.curved, place, side.isTriangle());
    Vec3 normal = Vec3::Zero();
    for (const std::uint32_t n : whole_.mesh.faces[place].normals) normal += whole_.mesh.normals[n];
    vertex.outside = true;
    vertex.direction = normal.stableNormalized();
  }
  return entry->second = addVertex(std::move(vertex));
}

/// The middle of the edge that is left of the side: asked for beside an edge with two ends, it has two nodes.
std::uint32_t CrackNet::collapsedVertex(std::uint32_t face, const SideNodes& side) {
  const auto other = std::find_if(side.nodes.begin(), side.nodes.end(),
                                  [&](NodeIndex node) { return node != side.nodes[0]; });
  assert(other != side.nodes.end());
  const Eigen::Matrix3d spans =
      cellSpans(cornerPositions(complex_.network(), face / kCellSides), localMiddle(face));
  return edgeVertex(side.nodes[0], *other, spans);
}

std::uint32_t CrackNet::cellVertex(CellIndex cell) {
  const auto [entry, isNew] = vertexOfCell_.try_emplace(cell, 0);
  if (!isNew) return entry->second;
  Vertex vertex;
  const auto corners = cornerPositions(complex_.network(), cell);
  for (const Vec3& corner : corners) vertex.start += 0.125 * corner;
  for (const NodeIndex node : DistinctCorners(complex_.network().cells[cell])) {
    vertex.groups[vertex.nodeCount] = vertex.nodeCount;
    vertex.nodes[vertex.nodeCount++] = node;
  }
  vertex.spans = cellSpans(corners, Vec3::Constant(0.5));
  joinGroups(vertex, cell);
  return entry->second = addVertex(std::move(vertex));
}

std::uint32_t CrackNet::addVertex(Vertex vertex) {
  vertex.position = vertex.start;
  for (std::uint8_t i = 0; i < vertex.nodeCount; ++i) {
    const NodeIndex node = vertex.nodes[i];
    if (cuts_.isLoose(node) && cuts_.carrierOf(node) == node) vertex.reach = kShardReach;
  }
  vertices_.push_back(std::move(vertex));
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

void CrackNet::placeOnEdge(Vertex& vertex, std::span<const CellComplex::OutsideEdge> edges) const {
  if (edges.empty()) return;
  vertex.outside = true;
  Vec3 normal = Vec3::Zero();
  for (const auto& edge : edges) {
    vertex.outsideFaces.push_back(edge.face);
    const auto& normals = whole_.mesh.faces[edge.face].normals;
    normal += whole_.mesh.normals[normals[edge.side]] + whole_.mesh.normals[normals[(edge.side + 1U) % 4]];
  }
  vertex.direction = normal.stableNormalized();
  vertex.start = middleOfSide(whole_.curved, edges[0].face, edges[0].side);
  vertex.fixed = edges.size() != 2;
  if (vertex.fixed) return;
  // Smooth where both faces have the same normals at both ends.
  const auto normalsAt = [&](const CellComplex::OutsideEdge& edge) {
    const auto& normals = whole_.mesh.faces[edge.face].normals;
    return std::minmax(normals[edge.side], normals[(edge.side + 1U) % 4]);
  };
  if (normalsAt(edges[0]) == normalsAt(edges[1])) return;
  vertex.creaseSide = edges[0].side;
  const auto& at = complex_.network().positions;
  vertex.direction = (at[vertex.nodes[1]] - at[vertex.nodes[0]]).stableNormalized();
}

void CrackNet::joinGroups(Vertex& vertex, CellIndex cell) const {
  const CellCorners& corners = complex_.network().cells[cell];
  std::array<std::uint32_t, kCellCorners> pieces{};
  for (std::uint8_t i = 0; i < vertex.nodeCount; ++i) {
    const auto found = std::find(corners.begin(), corners.end(), vertex.nodes[i]);
    pieces[i] = found == corners.end()
                    ? kNone
                    : cuts_.pieceOf(cell, static_cast<std::uint32_t>(found - corners.begin()));
  }
  for (std::uint8_t i = 0; i < vertex.nodeCount; ++i) {
    for (std::uint8_t j = 0; j < i; ++j) {
      if (pieces[i] == kNone || pieces[i] != pieces[j] || vertex.groups[i] == vertex.groups[j]) continue;
      const std::uint8_t kept = std::min(vertex.groups[i], vertex.groups[j]);
      const std::uint8_t dropped = std::max(vertex.groups[i], vertex.groups[j]);
      std::replace(vertex.groups.begin(), vertex.groups.begin() + vertex.nodeCount, dropped, kept);
    }
  }
}

}  // namespace sim
