#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/network/wedge.h"
#include "sim/surface/level_surface.h"
#include "sim/surface/surface_mesh.h"
#include "tests/support/change_broken.h"
#include "tests/support/grid_network.h"

namespace {

using sim::LooseNodes;
using sim::Network;
using sim::NodeIndex;
using sim::Snapshot;
using sim::SurfaceBuilder;
using sim::SurfaceMesh;
using sim::Vec3;
using tests::gridNetwork;

/// Two-point Gauss abscissae on [0, 1]: exact for the degree-2 integrands of trilinear cells and their faces.
constexpr double kGauss[2] = {0.21132486540518713, 0.78867513459481287};

/// Volume under a bilinear face, by the divergence theorem: integral of r . (r_u x r_v) / 3.
double fluxThrough(const std::array<std::uint32_t, 4>& quad, const std::vector<Vec3>& at) {
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

/// By fragment. A triangle is a quadrilateral whose last side has no length.
std::map<sim::FragmentId, double> volumes(const SurfaceMesh& mesh) {
  std::map<sim::FragmentId, double> found;
  for (const auto& face : mesh.faces) found[face.fragment] += fluxThrough(face.points, mesh.points);
  return found;
}

double totalVolume(const SurfaceMesh& mesh) {
  double total = 0.0;
  for (const auto& [fragment, volume] : volumes(mesh)) total += volume;
  return total;
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

/// Whether each directed edge of each fragment occurs as often one way as the other.
bool isClosed(const SurfaceMesh& mesh) {
  std::map<std::tuple<sim::FragmentId, std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& face : mesh.faces) {
    for (unsigned c = 0; c < face.cornerCount; ++c) {
      const std::uint32_t from = face.points[c];
      const std::uint32_t to = face.points[(c + 1) % face.cornerCount];
      edges[{face.fragment, std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

/// A block whose corners are moved at random by up to a fifth of a cell.
Network shakenBlock(unsigned nx, unsigned ny, unsigned nz, std::uint64_t seed) {
  std::uint64_t counter = 0;
  return gridNetwork(nx, ny, nz, [&](const Vec3& corner) {
    const auto next = [&] { return 0.4 * (sim::uniformAt(seed, counter++) - 0.5); };
    return Vec3(corner + Vec3(next(), next(), next()));
  });
}

/// Breaks cells, every bond all of whose cells are broken (docs/numerics.md, Breaking 3), and relabels the
/// fragments.
Snapshot broken(const Network& network, const std::set<sim::CellIndex>& cells) {
  Snapshot moment = sim::momentAtRest(network);
  sim::Broken made = *moment.broken;
  std::vector<int> liveCells(network.bondCount(), 0);
  for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    made.cells[cell] = cells.contains(cell) ? 1 : 0;
    if (cells.contains(cell)) continue;
    for (const NodeIndex a : network.cells[cell]) {
      for (const NodeIndex b : network.cells[cell]) {
        if (const auto bond = a < b ? network.findBond(a, b) : sim::kNone; bond != sim::kNone)
          ++liveCells[bond];
      }
    }
  }
  for (sim::BondIndex bond = 0; bond < network.bondCount(); ++bond) {
    made.bonds[bond] = liveCells[bond] == 0 ? 1 : 0;
  }
  std::vector<NodeIndex> label(network.nodeCount());
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) label[node] = node;
  for (bool changed = true; changed;) {
    changed = false;
    for (NodeIndex a = 0; a < network.nodeCount(); ++a) {
      for (auto bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond) {
        const NodeIndex b = network.bondEnds[bond];
        if (made.bonds[bond] != 0 || label[a] == label[b]) continue;
        label[a] = label[b] = std::min(label[a], label[b]);
        changed = true;
      }
    }
  }
  made.fragmentOfNode.assign(label.begin(), label.end());
  moment.broken = sim::sealed(std::move(made));
  return moment;
}

TEST_CASE("a whole slab shows its six sides and nothing inside") {
  const unsigned n = 4, m = 3, k = 2;
  const Network network = gridNetwork(n, m, k);
  const SurfaceMesh mesh = SurfaceBuilder(network).build(sim::momentAtRest(network));
  CHECK(mesh.faces.size() == 2 * (n * m + m * k + k * n));
  CHECK(std::none_of(mesh.faces.begin(), mesh.faces.end(), [](const auto& face) { return face.inside; }));
  CHECK(std::all_of(mesh.faces.begin(), mesh.faces.end(),
                    [](const auto& face) { return face.cornerCount == 4; }));
  CHECK(isClosed(mesh));
  CHECK(totalVolume(mesh) == Approx(n * m * k).epsilon(1e-12));
}

TEST_CASE("a broken cell whose corners still hang together is whole to look at") {
  const Network network = gridNetwork(3, 3, 3);
  const SurfaceMesh mesh = SurfaceBuilder(network).build(broken(network, {13}));
  CHECK(mesh.faces.size() == 6 * 9);
  CHECK(totalVolume(mesh) == Approx(27.0).epsilon(1e-12));
}

TEST_CASE("a crack through half of a block is a slit: closed, without volume, both sides inside") {
  const Network network = gridNetwork(3, 4, 2);
  // The middle layer in x, from one side to the middle.
  std::set<sim::CellIndex> cells;
  for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    const Vec3& corner = network.positions[network.cells[cell][0]];
    if (corner.x() == 1.0 && corner.y() < 2.0) cells.insert(cell);
  }
  Snapshot moment = broken(network, cells);
  const SurfaceMesh mesh = SurfaceBuilder(network).build(moment);
  double inside = 0.0;
  Vec3 sum = Vec3::Zero();
  for (const auto& face : mesh.faces) {
    if (!face.inside) continue;
    const Vec3 area = 0.5 * (mesh.points[face.points[2]] - mesh.points[face.points[0]])
                                .cross(mesh.points[face.points[3]] - mesh.points[face.points[1]]);
    inside += area.norm();
    sum += area;
  }
  CHECK(isClosed(mesh));
  CHECK(volumes(mesh).size() == 1);
  CHECK(totalVolume(mesh) == Approx(24.0).epsilon(1e-12));
  CHECK(sum.norm() < 1e-12);
  // Two sides, two high, and one long: the second cell's corners hang together through the third.
  CHECK(inside == Approx(2 * 2 * 1).epsilon(1e-12));
}

TEST_CASE("whatever breaks, fragments are closed and fill at rest exactly what the whole filled") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Network network = shakenBlock(4, 3, 3, seed);
    std::set<sim::CellIndex> cells;
    double volume = 0.0;
    for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
      if (sim::uniformAt(seed + 1000, cell) < 0.2 + 0.05 * static_cast<double>(seed)) cells.insert(cell);
      volume += cellVolume(network.cells[cell], network.positions);
    }
    for (const auto loose : {LooseNodes::shards, LooseNodes::givenToNeighbours}) {
      const Snapshot moment = broken(network, cells);
      const SurfaceMesh mesh = SurfaceBuilder(network, loose).build(moment);
      CHECK(isClosed(mesh));
      // The outside of a shaken block is curved where it is divided and straight where it is not.
      CHECK(totalVolume(mesh) == Approx(volume).epsilon(2e-2));
      CHECK((mesh.points.empty() || (mesh.points.back() - mesh.restPoints.back()).norm() < 1e-12));
    }
  }
}

/// A block of shaken cells in which some neighbouring nodes are one: prisms, and where two pairs meet, less.
Network wedgedBlock(std::uint64_t seed) {
  const Network plain = shakenBlock(4, 4, 3, seed);
  std::vector<NodeIndex> kept(plain.nodeCount());
  sim::Blueprint blueprint;
  blueprint.materials = {sim::Material{.name = "test"}};
  blueprint.partNames = {"block"};
  const auto at = [](unsigned x, unsigned y, unsigned z) { return (x * 5 + y) * 4 + z; };
  for (NodeIndex node = 0; node < plain.nodeCount(); ++node) kept[node] = node;
  // Pairs along x in the top layer, along y at its far end, and one inside.
  for (unsigned y = 0; y < 5; ++y) kept[at(2, y, 3)] = at(1, y, 3);
  kept[at(4, 2, 3)] = at(4, 1, 3);
  kept[at(3, 2, 3)] = at(3, 1, 3);
  kept[at(3, 3, 1)] = at(2, 3, 1);
  std::vector<NodeIndex> number(plain.nodeCount());
  for (NodeIndex node = 0; node < plain.nodeCount(); ++node) {
    if (kept[node] != node) continue;
    number[node] = static_cast<NodeIndex>(blueprint.nodes.size());
    blueprint.nodes.push_back({.position = plain.positions[node], .mass = 1.0});
  }
  std::set<std::pair<NodeIndex, NodeIndex>> bonds;
  for (sim::CellCorners cell : plain.cells) {
    for (NodeIndex& corner : cell) corner = number[kept[corner]];
    blueprint.cells.push_back(cell);
    for (const NodeIndex a : cell) {
      for (const NodeIndex b : cell) {
        if (a < b) bonds.insert({a, b});
      }
    }
  }
  for (const auto& [a, b] : bonds)
    blueprint.bonds.push_back({.a = a, .b = b, .stiffness = 1.0, .restLength = 1.0});
  return sim::buildNetwork(std::move(blueprint), seed).value();
}

TEST_CASE("wedges fill what they enclose, whole and broken") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Network network = wedgedBlock(seed);
    REQUIRE(std::count_if(network.cells.begin(), network.cells.end(), sim::isWedge) >= 10);
    double volume = 0.0;
    for (const auto& cell : network.cells) volume += cellVolume(cell, network.positions);
    const SurfaceMesh whole = SurfaceBuilder(network).build(sim::momentAtRest(network));
    CHECK(isClosed(whole));
    CHECK(totalVolume(whole) == Approx(volume).epsilon(1e-12));
    CHECK(std::count_if(whole.faces.begin(), whole.faces.end(),
                        [](const auto& face) { return face.cornerCount == 3; }) == 4);
    std::set<sim::CellIndex> cells;
    for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
      if (sim::uniformAt(seed + 500, cell) < 0.1 + 0.06 * static_cast<double>(seed)) cells.insert(cell);
    }
    for (const auto loose : {LooseNodes::shards, LooseNodes::givenToNeighbours}) {
      const SurfaceMesh mesh = SurfaceBuilder(network, loose).build(broken(network, cells));
      CHECK(isClosed(mesh));
      CHECK(totalVolume(mesh) == Approx(volume).epsilon(2e-2));
      CHECK(std::all_of(mesh.normals.begin(), mesh.normals.end(),
                        [](const Vec3& normal) { return std::abs(normal.norm() - 1.0) < 1e-9; }));
    }
  }
}

TEST_CASE("every broken face at rest lies on one of the other side") {
  const Network network = shakenBlock(5, 4, 3, 3);
  std::set<sim::CellIndex> cells;
  for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    if (sim::uniformAt(77, cell) < 0.45) cells.insert(cell);
  }
  const SurfaceMesh mesh = SurfaceBuilder(network).build(broken(network, cells));
  // A face by the rest places of its corners in order, beginning with the lowest: seen from behind, reversed.
  const auto nameOf = [&](const SurfaceMesh::Face& face, bool behind) {
    std::vector<std::array<double, 3>> corners;
    for (const std::uint32_t point : face.points) {
      const Vec3& at = mesh.restPoints[point];
      corners.push_back({at.x(), at.y(), at.z()});
    }
    if (behind) std::reverse(corners.begin(), corners.end());
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
  };
  std::map<std::vector<std::array<double, 3>>, int> faces;
  std::size_t inside = 0;
  for (const auto& face : mesh.faces) {
    if (!face.inside) continue;
    ++inside;
    ++faces[nameOf(face, false)];
    --faces[nameOf(face, true)];
  }
  CHECK(inside > 100);
  CHECK(std::all_of(faces.begin(), faces.end(), [](const auto& face) { return face.second == 0; }));
}

TEST_CASE("pieces that only moved rigidly keep their shape, and fit when put back") {
  const Network network = shakenBlock(5, 4, 3, 9);
  std::set<sim::CellIndex> cells;
  for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    if (network.positions[network.cells[cell][0]].x() > 1.4 &&
        network.positions[network.cells[cell][0]].x() < 2.6)
      cells.insert(cell);
  }
  Snapshot moment = broken(network, cells);
  std::map<sim::FragmentId, std::pair<Eigen::Quaterniond, Vec3>> motions;
  for (const sim::FragmentId fragment :
       std::set(moment.broken->fragmentOfNode.begin(), moment.broken->fragmentOfNode.end())) {
    const auto random = [&](std::uint64_t i) { return sim::uniformAt(5, 16 * fragment + i) - 0.5; };
    motions[fragment] = {Eigen::Quaterniond(random(0), random(1), random(2), random(3)).normalized(),
                         20.0 * Vec3(random(4), random(5), random(6))};
  }
  REQUIRE(motions.size() == 2);
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const auto& [turn, shift] = motions.at(moment.broken->fragmentOfNode[node]);
    moment.positions[node] = turn * network.positions[node] + shift;
  }
  const SurfaceMesh mesh = SurfaceBuilder(network).build(moment);
  double worst = 0.0;
  for (const auto& face : mesh.faces) {
    const auto& [turn, shift] = motions.at(face.fragment);
    for (const std::uint32_t point : face.points)
      worst = std::max(worst, (turn * mesh.restPoints[point] + shift - mesh.points[point]).norm());
  }
  CHECK(worst < 1e-11);
}

TEST_CASE("smoothing takes the staircase out of a slanted crack and leaves the outside where it is") {
  // A plate one cell thick, cracked along x = 0.5 y + 4 as cells see it: a step every second row.
  const Network network = gridNetwork(24, 24, 1);
  Snapshot moment = sim::momentAtRest(network);
  const auto side = [&](NodeIndex node) {
    const Vec3& at = network.positions[node];
    return at.x() > 0.5 * at.y() + 4.1;
  };
  sim::Broken made = *moment.broken;
  for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    const auto& corners = network.cells[cell];
    for (const NodeIndex corner : corners) {
      if (side(corner) != side(corners[0])) made.cells[cell] = 1;
    }
  }
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    made.fragmentOfNode[node] = side(node) ? 1 : 0;
    for (auto bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond)
      made.bonds[bond] = side(node) != side(network.bondEnds[bond]) ? 1 : 0;
  }
  moment.broken = sim::sealed(std::move(made));
  const SurfaceMesh mesh = SurfaceBuilder(network).build(moment);
  double worst = 0.0;
  for (const auto& face : mesh.faces) {
    for (const std::uint32_t point : face.points) {
      const Vec3& at = mesh.points[point];
      CHECK(at.z() >= -1e-12);
      CHECK(at.z() <= 1.0 + 1e-12);
      // Near the ends of the crack there is nothing to smooth with.
      if (face.inside && at.y() > 3.0 && at.y() < 21.0)
        worst = std::max(worst, std::abs(at.x() - 0.5 * at.y() - 4.1) / std::sqrt(1.25));
    }
    if (face.inside) continue;
    const double height = mesh.points[face.points[0]].z();
    if (std::abs(mesh.normals[face.normals[0]].z()) < 0.9) continue;
    CHECK((std::abs(height) < 1e-12 || std::abs(height - 1.0) < 1e-12));
  }
  // Unsmoothed, the steps stand off the line by up to 0.45.
  CHECK(worst < 0.2);
  CHECK(totalVolume(mesh) == Approx(576.0).epsilon(1e-10));
}

TEST_CASE("what did not break is taken over") {
  Network network = gridNetwork(2, 2, 1);
  // Two blocks far apart.
  const std::size_t nodes = network.nodeCount();
  sim::Blueprint blueprint;
  blueprint.materials = {sim::Material{.name = "test"}};
  blueprint.partNames = {"block"};
  for (const double shift : {0.0, 50.0}) {
    const auto first = static_cast<NodeIndex>(blueprint.nodes.size());
    for (NodeIndex node = 0; node < nodes; ++node)
      blueprint.nodes.push_back({.position = network.positions[node] + shift * Vec3::UnitX(), .mass = 1.0});
    for (sim::CellCorners cell : network.cells) {
      for (NodeIndex& corner : cell) corner += first;
      blueprint.cells.push_back(cell);
    }
    for (NodeIndex node = 0; node < nodes; ++node) {
      for (auto bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond)
        blueprint.bonds.push_back(
            {.a = first + node, .b = first + network.bondEnds[bond], .stiffness = 1.0, .restLength = 1.0});
    }
  }
  const Network both = sim::buildNetwork(std::move(blueprint), 1).value();
  SurfaceBuilder builder(both);
  builder.build(broken(both, {}));
  CHECK(builder.bodiesRebuilt() == 2);
  builder.build(broken(both, {}));
  CHECK(builder.bodiesRebuilt() == 0);
  const Snapshot moment = broken(both, {1, 2});
  const SurfaceMesh mesh = builder.build(moment);
  CHECK(builder.bodiesRebuilt() == 1);
  const SurfaceMesh anew = SurfaceBuilder(both).build(moment);
  REQUIRE(mesh.points.size() == anew.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) CHECK(mesh.points[i] == anew.points[i]);
}

TEST_CASE("damage is the share of broken bonds about a point") {
  const Network network = gridNetwork(2, 1, 1);
  Snapshot moment = sim::momentAtRest(network);
  const SurfaceMesh whole = SurfaceBuilder(network).build(moment);
  CHECK(*std::max_element(whole.damage.begin(), whole.damage.end()) == 0.0F);
  tests::changeBroken(moment, [&](sim::Broken& made) { made.bonds[network.findBond(0, 1)] = 1; });
  const SurfaceMesh mesh = SurfaceBuilder(network).build(moment);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    CHECK(mesh.damage[i] == Approx(mesh.nodeOfPoint[i] <= 1 ? 1.0 / 3.0 : 0.0));
}

TEST_CASE("the corners of a box keep three normals, its edges two, its sides one") {
  const Network network = gridNetwork(3, 3, 3);
  const SurfaceMesh mesh = SurfaceBuilder(network).build(sim::momentAtRest(network));
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
  const SurfaceMesh mesh = SurfaceBuilder(network).build(sim::momentAtRest(network));
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
  const SurfaceMesh mesh = SurfaceBuilder(network).build(broken(network, {4, 5, 6, 7}));
  unsigned inside = 0;
  std::set<sim::FragmentId> seen;
  std::set<sim::FragmentId> before;
  for (const auto& face : mesh.faces) {
    // Those of a fragment stand together.
    if (seen.insert(face.fragment).second) before = seen;
    CHECK(before.contains(face.fragment));
    if (!face.inside) continue;
    ++inside;
    for (const auto normal : face.normals) CHECK(std::abs(mesh.normals[normal].x()) == Approx(1.0));
  }
  // Four cells, each crossed by four quarters with two sides.
  CHECK(inside == 32);
  CHECK(seen.size() == 2);
}

TEST_CASE("a loose node is an outward shard of its cells' material") {
  const Network network = gridNetwork(2, 2, 2);
  const Snapshot moment = broken(network, {0, 1, 2, 3, 4, 5, 6, 7});
  const SurfaceMesh mesh = SurfaceBuilder(network).build(moment);
  const auto byFragment = volumes(mesh);
  CHECK(byFragment.size() == network.nodeCount());
  for (const auto& [fragment, volume] : byFragment) CHECK(volume > 0.02);
  CHECK(totalVolume(mesh) == Approx(8.0).epsilon(1e-12));
  CHECK(isClosed(mesh));
}

TEST_CASE("loose nodes can be tetrahedra or spheres of as much material as they have") {
  // Distorted, so that no two cells are alike.
  const Network network = gridNetwork(2, 1, 1, [](const Vec3& at) {
    return Vec3(at + 0.2 * Vec3(at.y() * at.z(), at.x() * at.x() * at.z(), at.x() * at.y()));
  });
  const Snapshot moment = broken(network, {0, 1});
  for (const auto loose : {LooseNodes::tetrahedra, LooseNodes::spheres}) {
    const SurfaceMesh mesh = SurfaceBuilder(network, loose).build(moment);
    const auto byFragment = volumes(mesh);
    REQUIRE(byFragment.size() == network.nodeCount());
    std::set<double> sizes;
    for (const auto& [fragment, volume] : byFragment) sizes.insert(volume);
    CHECK(*sizes.begin() > 0.0);
    CHECK(isClosed(mesh));
    for (const auto& face : mesh.faces) CHECK(face.inside);
    CHECK(sizes.size() > network.nodeCount() / 2);
    double whole = 0.0;
    for (const auto& cell : network.cells) whole += cellVolume(cell, network.positions);
    CHECK(totalVolume(mesh) == Approx(whole).epsilon(1e-9));
  }
}

TEST_CASE("a node that still hangs on a bond is not loose") {
  const Network network = gridNetwork(1, 1, 1);
  Snapshot moment = broken(network, {0});
  tests::changeBroken(moment, [&](sim::Broken& made) {
    made.bonds[0] = 0;
    made.fragmentOfNode[network.bondEnds[0]] = made.fragmentOfNode[0];
  });
  const SurfaceMesh mesh = SurfaceBuilder(network, LooseNodes::tetrahedra).build(moment);
  const auto triangles = std::count_if(mesh.faces.begin(), mesh.faces.end(),
                                       [](const auto& face) { return face.cell == sim::kNone; });
  CHECK(triangles == static_cast<std::ptrdiff_t>(4 * (network.nodeCount() - 2)));
  CHECK(isClosed(mesh));
}

TEST_CASE("the level surface of one node is a ball around it, seen from outside") {
  const Vec3 middle(1, 2, 3);
  const sim::LevelSurface ball =
      sim::levelSurface({{middle, 2.0}}, {.mostCubes = 100'000}, [] { return false; });
  REQUIRE(ball.quads.size() > 100);
  const double radius = (ball.points[0] - middle).norm();
  for (std::size_t p = 0; p < ball.points.size(); ++p) {
    // The grid is a fifth of the reach: the surface is within a fraction of that.
    CHECK((ball.points[p] - middle).norm() == Approx(radius).margin(0.1));
    CHECK(ball.normals[p].dot((ball.points[p] - middle).normalized()) > 0.98);
  }
  for (const auto& quad : ball.quads) {
    const Vec3 across = ball.points[quad[2]] - ball.points[quad[0]];
    const Vec3 up = ball.points[quad[3]] - ball.points[quad[1]];
    CHECK(across.cross(up).dot(ball.points[quad[0]] - middle) > 0.0);
  }
}

TEST_CASE("the level surface of a network is closed, holds its nodes, and knows whose each face is") {
  const sim::Network network = tests::gridNetwork(4, 3, 2);
  sim::Snapshot moment = sim::momentAtRest(network);
  tests::breakBetween(network, 2.5, moment);
  sim::Broken made = *moment.broken;
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const bool second = network.positions[node].x() > 2.5;
    made.fragmentOfNode[node] = second ? 1 : 0;
    if (second) moment.positions[node].x() += 5.0;
  }
  moment.broken = sim::sealed(std::move(made));
  const sim::SurfaceMesh mesh = sim::levelSurfaceOf(network, moment, {});
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double volume = 0.0;
  for (const auto& face : mesh.faces) {
    CHECK(face.fragment == (mesh.points[face.points[0]].x() < 5.0 ? 0U : 1U));
    for (unsigned c = 0; c < 4; ++c) ++edges[{face.points[c], face.points[(c + 1) % 4]}];
    const auto at = [&](unsigned c) { return mesh.points[face.points[c]]; };
    volume += (at(0).dot(at(1).cross(at(2))) + at(0).dot(at(2).cross(at(3)))) / 6.0;
  }
  for (const auto& [edge, count] : edges) CHECK(edges.at({edge.second, edge.first}) == count);
  // Two pieces of 2 x 3 x 2 and 1 x 3 x 2 cells of edge 1, up to an edge thicker on all sides.
  CHECK(volume > 18.0);
  CHECK(volume < 4 * 5 * 4 + 3 * 5 * 4);
}

}  // namespace
