#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/network/surface_mesh.h"
#include "tests/support/grid_network.h"

namespace {

using sim::Network;
using sim::NodeIndex;
using sim::Snapshot;
using sim::SurfaceFace;
using sim::SurfaceMesh;
using sim::Vec3;
using tests::gridNetwork;

/// Two-point Gauss abscissae on [0, 1]: exact for the degree-2 integrands of trilinear cells and their faces.
constexpr double kGauss[2] = {0.21132486540518713, 0.78867513459481287};

/// Volume under a bilinear face, by the divergence theorem: integral of r . (r_u x r_v) / 3.
double fluxThrough(const std::array<NodeIndex, 4>& quad, const std::vector<Vec3>& at) {
  double flux = 0.0;
  for (const double u : kGauss) {
    for (const double v : kGauss) {
      const Vec3 r = (1 - u) * (1 - v) * at[quad[0]] + u * (1 - v) * at[quad[1]] + u * v * at[quad[2]] +
                     (1 - u) * v * at[quad[3]];
      const Vec3 ru = (1 - v) * (at[quad[1]] - at[quad[0]]) + v * (at[quad[2]] - at[quad[3]]);
      const Vec3 rv = (1 - u) * (at[quad[3]] - at[quad[0]]) + u * (at[quad[2]] - at[quad[1]]);
      flux += r.dot(ru.cross(rv)) / 12.0;
    }
  }
  return flux;
}

double cellVolume(const sim::CellCorners& cell, const std::vector<Vec3>& at) {
  double volume = 0.0;
  for (unsigned point = 0; point < 8; ++point) {
    const double x[3] = {kGauss[point & 1U], kGauss[point >> 1U & 1U], kGauss[point >> 2U]};
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    for (unsigned c = 0; c < 8; ++c) {
      double weight[3];
      for (unsigned axis = 0; axis < 3; ++axis)
        weight[axis] = (c >> axis & 1U) != 0 ? x[axis] : 1.0 - x[axis];
      for (unsigned axis = 0; axis < 3; ++axis) {
        const double sign = (c >> axis & 1U) != 0 ? 1.0 : -1.0;
        jacobian.col(axis) += sign * weight[(axis + 1) % 3] * weight[(axis + 2) % 3] * at[cell[c]];
      }
    }
    volume += jacobian.determinant() / 8.0;
  }
  return volume;
}

/// How often each directed edge occurs; a closed surface has as many one way as the other.
std::map<std::pair<NodeIndex, NodeIndex>, int> directedEdges(const std::vector<SurfaceFace>& faces) {
  std::map<std::pair<NodeIndex, NodeIndex>, int> edges;
  for (const SurfaceFace& face : faces) {
    for (unsigned c = 0; c < 4; ++c) ++edges[{face.nodes[c], face.nodes[(c + 1) % 4]}];
  }
  return edges;
}

/// A block whose corners are moved at random by up to a fifth of a cell.
Network shakenBlock(unsigned nx, unsigned ny, unsigned nz, std::uint64_t seed) {
  std::uint64_t counter = 0;
  return gridNetwork(nx, ny, nz, [&](const Vec3& corner) {
    const auto next = [&] { return 0.4 * (sim::uniformAt(seed, counter++) - 0.5); };
    return Vec3(corner + Vec3(next(), next(), next()));
  });
}

/// Breaks cells, every bond all of whose cells are broken (P15), and relabels the fragments.
Snapshot broken(const Network& network, const std::set<sim::CellIndex>& cells) {
  Snapshot moment = sim::momentAtRest(network);
  std::vector<int> liveCells(network.bondCount(), 0);
  for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    moment.brokenCells[cell] = cells.contains(cell) ? 1 : 0;
    if (cells.contains(cell)) continue;
    for (const NodeIndex a : network.cells[cell]) {
      for (const NodeIndex b : network.cells[cell]) {
        if (const auto bond = a < b ? network.findBond(a, b) : sim::kNone; bond != sim::kNone)
          ++liveCells[bond];
      }
    }
  }
  for (sim::BondIndex bond = 0; bond < network.bondCount(); ++bond) {
    moment.brokenBonds[bond] = liveCells[bond] == 0 ? 1 : 0;
  }
  std::vector<NodeIndex> label(network.nodeCount());
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) label[node] = node;
  for (bool changed = true; changed;) {
    changed = false;
    for (NodeIndex a = 0; a < network.nodeCount(); ++a) {
      for (auto bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond) {
        const NodeIndex b = network.bondEnds[bond];
        if (moment.brokenBonds[bond] != 0 || label[a] == label[b]) continue;
        label[a] = label[b] = std::min(label[a], label[b]);
        changed = true;
      }
    }
  }
  moment.fragmentOfNode.assign(label.begin(), label.end());
  return moment;
}

TEST_CASE("a whole slab shows its six sides and nothing inside") {
  const unsigned n = 4, m = 3, k = 2;
  const auto faces = sim::surfaceFaces(gridNetwork(n, m, k), {});
  CHECK(faces.size() == 2 * (n * m + m * k + k * n));
  CHECK(std::none_of(faces.begin(), faces.end(), [](const auto& face) { return face.fracture; }));
  CHECK(std::is_sorted(faces.begin(), faces.end(),
                       [](const auto& a, const auto& b) { return a.cell < b.cell; }));
  for (const auto& [edge, count] : directedEdges(faces)) {
    CHECK(count == 1);
    CHECK(directedEdges(faces).at({edge.second, edge.first}) == 1);
  }
}

TEST_CASE("breaking an inner cell opens a hole lined with its six broken faces") {
  const Network network = gridNetwork(3, 3, 3);
  std::vector<std::uint8_t> brokenCells(network.cellCount(), 0);
  brokenCells[13] = 1;
  const auto faces = sim::surfaceFaces(network, brokenCells);
  CHECK(faces.size() == 6 * 9 + 6);
  const std::set<NodeIndex> hole(network.cells[13].begin(), network.cells[13].end());
  for (const SurfaceFace& face : faces) {
    const bool lines =
        std::all_of(face.nodes.begin(), face.nodes.end(), [&](auto n) { return hole.contains(n); });
    CHECK(face.fracture == lines);
    CHECK(face.cell != 13);
  }
}

TEST_CASE("breaking a corner cell takes three sides away and shows three broken faces") {
  const Network network = gridNetwork(3, 3, 3);
  std::vector<std::uint8_t> brokenCells(network.cellCount(), 0);
  brokenCells[0] = 1;
  const auto faces = sim::surfaceFaces(network, brokenCells);
  CHECK(faces.size() == 6 * 9);
  CHECK(std::count_if(faces.begin(), faces.end(), [](const auto& face) { return face.fracture; }) == 3);
}

TEST_CASE("whatever breaks, the surface is closed and holds the volume of the unbroken cells") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Network network = shakenBlock(4, 3, 3, seed);
    std::vector<std::uint8_t> brokenCells(network.cellCount());
    double volume = 0.0;
    for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
      brokenCells[cell] = sim::uniformAt(seed + 1000, cell) < 0.4 ? 1 : 0;
      if (brokenCells[cell] == 0) volume += cellVolume(network.cells[cell], network.positions);
    }
    const auto faces = sim::surfaceFaces(network, brokenCells);
    double flux = 0.0;
    for (const SurfaceFace& face : faces) flux += fluxThrough(face.nodes, network.positions);
    // Both quadratures are exact; some hundred terms of size one are summed.
    CHECK(flux == Approx(volume).margin(1e-11));
    const auto edges = directedEdges(faces);
    for (const auto& [edge, count] : edges) {
      const auto back = edges.find({edge.second, edge.first});
      REQUIRE(back != edges.end());
      CHECK(back->second == count);
    }
  }
}

TEST_CASE("a surface asked for twice, or frame by frame, is the same") {
  const Network network = shakenBlock(3, 3, 3, 5);
  const sim::CellFaces cellFaces(network);
  std::vector<std::uint8_t> brokenCells(network.cellCount(), 0);
  CHECK(cellFaces.surface({}).size() == cellFaces.surface(brokenCells).size());
  brokenCells[4] = brokenCells[22] = 1;
  const auto once = cellFaces.surface(brokenCells);
  const auto again = sim::surfaceFaces(network, brokenCells);
  REQUIRE(once.size() == again.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    CHECK(once[i].nodes == again[i].nodes);
    CHECK(once[i].fracture == again[i].fracture);
  }
}

TEST_CASE("the corners of a box keep three normals, its edges two, its sides one") {
  const Network network = gridNetwork(3, 3, 3);
  const SurfaceMesh mesh = sim::SurfaceBuilder(network).build(sim::momentAtRest(network));
  std::map<NodeIndex, std::set<std::uint32_t>> normalsOfNode;
  for (const auto& face : mesh.faces) {
    for (unsigned c = 0; c < 4; ++c) normalsOfNode[mesh.nodeOfPoint[face.points[c]]].insert(face.normals[c]);
  }
  for (const auto& [node, normals] : normalsOfNode) {
    const Vec3& p = network.positions[node];
    std::size_t sides = 0;
    for (unsigned axis = 0; axis < 3; ++axis) sides += p[axis] == 0.0 || p[axis] == 3.0 ? 1 : 0;
    CHECK(normals.size() == sides);
  }
}

TEST_CASE("a tube is smooth around, with sharp rims") {
  const unsigned around = 24;
  const Network network = gridNetwork(
      around, 1, 4,
      [&](const Vec3& corner) {
        const double angle = -2.0 * std::numbers::pi * corner.x() / around;
        const double radius = 5.0 + corner.y();
        return Vec3(radius * std::cos(angle), radius * std::sin(angle), corner.z());
      },
      true);
  const SurfaceMesh mesh = sim::SurfaceBuilder(network).build(sim::momentAtRest(network));
  for (const auto& face : mesh.faces) {
    for (unsigned c = 0; c < 4; ++c) {
      const Vec3& normal = mesh.normals[face.normals[c]];
      CHECK(std::abs(normal.norm() - 1.0) < 1e-14);
      if (std::abs(normal.z()) > 0.5) {
        CHECK(std::abs(normal.z()) == Approx(1.0));
        continue;
      }
      Vec3 radial = mesh.points[face.points[c]];
      radial.z() = 0.0;
      const double side = radial.norm() > 5.5 ? 1.0 : -1.0;
      // By symmetry the two faces at a point weigh the same, so their mean is exactly radial.
      CHECK((normal - side * radial.normalized()).norm() < 1e-12);
    }
  }
}

TEST_CASE("broken faces keep their own normals and say that they show the inside") {
  const Network network = gridNetwork(4, 2, 2);
  const SurfaceMesh mesh = sim::SurfaceBuilder(network).build(broken(network, {4, 5, 6, 7}));
  unsigned inside = 0;
  std::set<sim::FragmentId> fragments;
  for (const auto& face : mesh.faces) {
    fragments.insert(face.fragment);
    if (!face.inside) continue;
    ++inside;
    for (const auto normal : face.normals) CHECK(std::abs(mesh.normals[normal].x()) == Approx(1.0));
  }
  CHECK(inside == 8);
  CHECK(fragments.size() == 2);
  CHECK(std::is_sorted(mesh.faces.begin(), mesh.faces.end(),
                       [](const auto& a, const auto& b) { return a.fragment < b.fragment; }));
}

TEST_CASE("an isolated node is an outward tetrahedron within its reach, turned its own way") {
  const Network network = gridNetwork(2, 1, 1);
  const Snapshot moment = broken(network, {0, 1});
  const SurfaceMesh mesh = sim::SurfaceBuilder(network).build(moment);
  REQUIRE(mesh.faces.size() == 4 * network.nodeCount());
  REQUIRE(mesh.points.size() == 4 * network.nodeCount());
  std::vector<double> volumeOfNode(network.nodeCount(), 0.0);
  for (const auto& face : mesh.faces) {
    CHECK(face.cornerCount == 3);
    CHECK(face.inside);
    const NodeIndex node = mesh.nodeOfPoint[face.points[0]];
    CHECK(face.fragment == moment.fragmentOfNode[node]);
    std::array<Vec3, 3> corner;
    for (unsigned c = 0; c < 3; ++c) corner[c] = mesh.points[face.points[c]] - network.positions[node];
    volumeOfNode[node] += corner[0].dot(corner[1].cross(corner[2])) / 6.0;
  }
  std::set<double> volumes(volumeOfNode.begin(), volumeOfNode.end());
  CHECK(volumes.size() == network.nodeCount());
  CHECK(*volumes.begin() > 0.0);
  for (std::size_t point = 0; point < mesh.points.size(); ++point) {
    const double reach = (mesh.points[point] - network.positions[mesh.nodeOfPoint[point]]).norm();
    CHECK(reach <= sim::SurfaceBuilder::kShardReach * network.radii[mesh.nodeOfPoint[point]] * (1.0 + 1e-12));
  }
}

TEST_CASE("a node that still hangs on a bond is no shard") {
  const Network network = gridNetwork(1, 1, 1);
  Snapshot moment = broken(network, {0});
  moment.brokenBonds[0] = 0;
  const SurfaceMesh mesh = sim::SurfaceBuilder(network).build(moment);
  CHECK(mesh.faces.size() == 4 * (network.nodeCount() - 2));
}

}  // namespace
