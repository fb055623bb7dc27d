#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "sim/base/random.h"
#include "sim/network/cell_shape.h"
#include "sim/surface/body_surface.h"
#include "sim/surface/surface_mesh.h"

namespace sim {

namespace {

/// Seed of the tetrahedra's shapes, so that a node's looks the same in every frame and every run.
constexpr std::uint64_t kShapeSeed = 0x5a4d;

double randomOf(NodeIndex node, std::uint64_t dimension) {
  return uniformAt(kShapeSeed, 8ULL * node + dimension);
}

/// Uniform over all rotations (Shoemake's three numbers).
Eigen::Quaterniond randomRotation(NodeIndex node) {
  const double u = randomOf(node, 0);
  const double v = 2.0 * std::numbers::pi * randomOf(node, 1);
  const double w = 2.0 * std::numbers::pi * randomOf(node, 2);
  return {std::sqrt(1.0 - u) * std::sin(v), std::sqrt(1.0 - u) * std::cos(v), std::sqrt(u) * std::sin(w),
          std::sqrt(u) * std::cos(w)};
}

struct Shape {
  std::vector<Vec3> corners;
  std::vector<std::array<std::uint32_t, 3>> sides;
};

Shape tetrahedron(NodeIndex node, double reach) {
  Shape shape;
  shape.sides = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  const Eigen::Quaterniond rotation = randomRotation(node);
  const std::array<Vec3, 4> corners{Vec3(1, 1, 1), Vec3(-1, -1, 1), Vec3(-1, 1, -1), Vec3(1, -1, -1)};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const double irregular = 0.6 + 0.4 * randomOf(node, 3 + i);
    shape.corners.emplace_back(rotation * (reach * irregular * corners[i].normalized()));
  }
  return shape;
}

/// An octahedron, its sides divided in four and blown up.
Shape sphere(double radius) {
  Shape shape;
  shape.corners = {Vec3::UnitX(),  -Vec3::UnitX(), Vec3::UnitY(),
                   -Vec3::UnitY(), Vec3::UnitZ(),  -Vec3::UnitZ()};
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 point = (shape.corners[a] + shape.corners[b]).normalized();
    for (std::uint32_t i = 0; i < shape.corners.size(); ++i) {
      if ((shape.corners[i] - point).norm() < 1e-9) return i;
    }
    shape.corners.push_back(point);
    return static_cast<std::uint32_t>(shape.corners.size() - 1);
  };
  for (const std::array<std::uint32_t, 3> side : {std::array<std::uint32_t, 3>{0, 2, 4},
                                                  {2, 1, 4},
                                                  {1, 3, 4},
                                                  {3, 0, 4},
                                                  {2, 0, 5},
                                                  {1, 2, 5},
                                                  {3, 1, 5},
                                                  {0, 3, 5}}) {
    const std::uint32_t ab = middle(side[0], side[1]);
    const std::uint32_t bc = middle(side[1], side[2]);
    const std::uint32_t ca = middle(side[2], side[0]);
    shape.sides.insert(shape.sides.end(),
                       {{side[0], ab, ca}, {ab, side[1], bc}, {ca, bc, side[2]}, {ab, bc, ca}});
  }
  for (Vec3& corner : shape.corners) corner *= radius;
  return shape;
}

double volumeOf(const Shape& shape) {
  double sum = 0.0;
  for (const auto& [a, b, c] : shape.sides)
    sum += shape.corners[a].dot(shape.corners[b].cross(shape.corners[c])) / 6.0;
  return sum;
}

/// Under a bilinear side is the mean of what is under its two divisions into triangles.
double volumeOf(const Network& network, const CellCorners& cell) {
  double sum = 0.0;
  for (const auto& side : kSideCorners) {
    const auto at = [&](unsigned corner) -> const Vec3& { return network.positions[cell[side[corner % 4]]]; };
    for (unsigned c = 0; c < 4; ++c) sum += at(c).dot(at(c + 1).cross(at(c + 2))) / 12.0;
  }
  return sum;
}

}  // namespace

std::vector<double> volumesOfNodes(const Network& network) {
  std::vector<double> volumes(network.nodeCount(), 0.0);
  for (const CellCorners& cell : network.cells) {
    const double share = volumeOf(network, cell) / kCellCorners;
    for (const NodeIndex node : cell) volumes[node] += share;
  }
  return volumes;
}

void addLooseBody(const Network& network, const Broken& broken, NodeIndex node, bool isSphere, double volume,
                  float damage, SurfaceTopology& topology) {
  const double reach = SurfaceBuilder::kLooseReach * static_cast<double>(network.radii[node]);
  // As large as the tetrahedron, whose corners stand out.
  Shape shape = isSphere ? sphere(0.6 * reach) : tetrahedron(node, reach);
  if (volume > 0.0) {
    const double larger = std::cbrt(volume / volumeOf(shape));
    for (Vec3& corner : shape.corners) corner *= larger;
  }
  const auto firstPoint = static_cast<std::uint32_t>(topology.pointCount());
  const auto fit = static_cast<std::uint32_t>(topology.fits.size());
  const auto supports = static_cast<std::uint32_t>(topology.supports.size());
  topology.fits.push_back({node, true, supports, supports});
  for (const Vec3& corner : shape.corners) {
    topology.restPoints.push_back(network.positions[node] + corner);
    topology.nodeOfPoint.push_back(node);
    topology.damage.push_back(damage);
    topology.anchors.push_back({node, fit, corner});
    topology.firstAnchor.push_back(static_cast<std::uint32_t>(topology.anchors.size()));
  }
  for (const auto& side : shape.sides) {
    SurfaceMeshFace& face = topology.faces.emplace_back();
    for (std::size_t c = 0; c < 4; ++c) face.points[c] = firstPoint + side[std::min<std::size_t>(c, 2)];
    face.cornerCount = 3;
    face.inside = true;
    face.material = network.nodeMaterials[node];
    face.part = network.nodeParts[node];
    face.fragment = broken.fragmentOfNode[node];
  }
}

}  // namespace sim
