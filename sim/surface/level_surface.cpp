#include "sim/surface/level_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "sim/surface/body_surface.h"

namespace sim {
namespace {

/// Two nodes side by side add up to one body; a node alone keeps a radius of half its reach.
constexpr float kLevel = 0.42F;

/// Wyvill's falloff: 1 at 0, 0 with slope 0 at 1.
double potential(double squaredShare) {
  if (squaredShare >= 1.0) return 0.0;
  const double q = squaredShare;
  return 1.0 - (4.0 * q * q * q - 17.0 * q * q + 22.0 * q) / 9.0;
}

class Field {
 public:
  Field(const std::vector<FieldSource>& sources, const LevelGrid& grid) {
    Eigen::AlignedBox3d box;
    double reach = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    for (const FieldSource& source : sources) {
      box.extend(source.position);
      reach = std::max(reach, source.reach);
      smallest = std::min(smallest, source.reach);
    }
    box.extend(Vec3(box.min().array() - 1.01 * reach));
    box.extend(Vec3(box.max().array() + 1.01 * reach));
    origin_ = box.min();
    step_ =
        std::max(smallest / grid.cubesInReach, std::cbrt(box.volume() / static_cast<double>(grid.mostCubes)));
    for (int axis = 0; axis < 3; ++axis)
      size_[axis] = 2 + static_cast<int>(std::ceil(box.sizes()[axis] / step_));
    const std::size_t count = index(0, 0, size_[2]);
    values_.assign(count, 0.0F);
    strongest_.assign(count, 0.0F);
    sources_.assign(count, kNone);
    for (std::uint32_t s = 0; s < sources.size(); ++s) add(sources[s], s);
  }

  const Eigen::Array3i& size() const { return size_; }
  std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(size_[0]) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(k));
  }
  Vec3 point(double i, double j, double k) const { return origin_ + step_ * Vec3(i, j, k); }
  float above(int i, int j, int k) const { return values_[index(i, j, k)] - kLevel; }
  std::uint32_t source(int i, int j, int k) const { return sources_[index(i, j, k)]; }

 private:
  void add(const FieldSource& source, std::uint32_t number) {
    std::array<int, 3> low{};
    std::array<int, 3> high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      low[axis] = static_cast<int>(std::ceil((source.position[at] - source.reach - origin_[at]) / step_));
      high[axis] = static_cast<int>(std::floor((source.position[at] + source.reach - origin_[at]) / step_));
    }
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1]; ++j) {
        for (int i = low[0]; i <= high[0]; ++i) {
          const double squared = (point(i, j, k) - source.position).squaredNorm();
          const auto value = static_cast<float>(potential(squared / (source.reach * source.reach)));
          const std::size_t at = index(i, j, k);
          values_[at] += value;
          if (value <= strongest_[at]) continue;
          strongest_[at] = value;
          sources_[at] = number;
        }
      }
    }
  }

  Vec3 origin_ = Vec3::Zero();
  double step_ = 1.0;
  Eigen::Array3i size_ = Eigen::Array3i::Zero();
  std::vector<float> values_;
  std::vector<float> strongest_;
  std::vector<std::uint32_t> sources_;
};

class NetMaker {
 public:
  explicit NetMaker(const Field& field)
      : field_(field), pointOfCube_(field.index(0, 0, field.size()[2]), kNone) {}

  void addPoint(int i, int j, int k) {
    Vec3 sum = Vec3::Zero();
    Vec3 slope = Vec3::Zero();
    int crossings = 0;
    std::array<float, 8> corner{};
    for (unsigned c = 0; c < 8; ++c) corner[c] = field_.above(i + bit(c, 0), j + bit(c, 1), k + bit(c, 2));
    for (unsigned a = 0; a < 8; ++a) {
      for (unsigned axis = 0; axis < 3; ++axis) {
        if (bit(a, axis) != 0) continue;
        const unsigned b = a | (1U << axis);
        slope[axis] += static_cast<double>(corner[b] - corner[a]);
        if ((corner[a] > 0.0F) == (corner[b] > 0.0F)) continue;
        Vec3 at(bit(a, 0), bit(a, 1), bit(a, 2));
        at[axis] = static_cast<double>(corner[a] / (corner[a] - corner[b]));
        sum += at;
        ++crossings;
      }
    }
    if (crossings == 0) return;
    sum /= crossings;
    const double steepness = slope.norm();
    pointOfCube_[field_.index(i, j, k)] = static_cast<std::uint32_t>(surface_.points.size());
    surface_.points.push_back(field_.point(i + sum.x(), j + sum.y(), k + sum.z()));
    surface_.normals.push_back(steepness > 0.0 ? Vec3(-slope / steepness) : Vec3::UnitZ());
    surface_.sources.push_back(strongest(i, j, k, corner));
  }

  /// The four cubes about an edge that the surface crosses share a quadrilateral.
  void addQuads(int i, int j, int k) {
    const std::array<int, 3> at{i, j, k};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<int, 3> next = at;
      ++next[axis];
      const bool here = field_.above(i, j, k) > 0.0F;
      if (here == (field_.above(next[0], next[1], next[2]) > 0.0F)) continue;
      const std::size_t second = (axis + 1) % 3;
      const std::size_t third = (axis + 2) % 3;
      std::array<std::uint32_t, 4> quad{};
      for (std::size_t c = 0; c < 4; ++c) {
        std::array<int, 3> cube = at;
        if (c == 1 || c == 2) --cube[second];
        if (c == 2 || c == 3) --cube[third];
        quad[c] = pointOfCube_[field_.index(cube[0], cube[1], cube[2])];
      }
      if (!here) std::swap(quad[1], quad[3]);
      surface_.quads.push_back(quad);
    }
  }

  LevelSurface take() { return std::move(surface_); }

 private:
  /// Of the corner deepest inside, where there always is a source.
  std::uint32_t strongest(int i, int j, int k, const std::array<float, 8>& corner) const {
    const auto deepest =
        static_cast<unsigned>(std::max_element(corner.begin(), corner.end()) - corner.begin());
    return field_.source(i + bit(deepest, 0), j + bit(deepest, 1), k + bit(deepest, 2));
  }
  static int bit(unsigned corner, unsigned axis) { return static_cast<int>((corner >> axis) & 1U); }

  const Field& field_;
  std::vector<std::uint32_t> pointOfCube_;
  LevelSurface surface_;
};

}  // namespace

LevelSurface levelSurface(const std::vector<FieldSource>& sources, const LevelGrid& grid,
                          const std::function<bool()>& cancelled) {
  if (sources.empty()) return {};
  const Field field(sources, grid);
  NetMaker maker(field);
  const Eigen::Array3i& size = field.size();
  for (int k = 0; k + 1 < size[2]; ++k) {
    if (cancelled()) return {};
    for (int j = 0; j + 1 < size[1]; ++j) {
      for (int i = 0; i + 1 < size[0]; ++i) maker.addPoint(i, j, k);
    }
  }
  // Around the field there is nothing: no edge of the outermost layer is crossed.
  for (int k = 1; k + 1 < size[2]; ++k) {
    for (int j = 1; j + 1 < size[1]; ++j) {
      for (int i = 1; i + 1 < size[0]; ++i) maker.addQuads(i, j, k);
    }
  }
  return maker.take();
}

double potentialReach(const Network& network, NodeIndex node) {
  constexpr double kReach = 1.5;  // of the distance to its nearest neighbour
  return kReach * static_cast<double>(network.radii[node]);
}

SurfaceMesh levelSurfaceOf(const Network& network, const Snapshot& moment, const LevelGrid& grid) {
  std::vector<FieldSource> sources;
  std::vector<NodeIndex> nodes;
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    if (!(network.radii[node] > 0.0F)) continue;
    sources.push_back({moment.positions[node], potentialReach(network, node)});
    nodes.push_back(node);
  }
  LevelSurface level = levelSurface(sources, grid, [] { return false; });
  const std::vector<float> damage = damageOfNodes(network, *moment.broken);
  SurfaceMesh mesh;
  mesh.points = std::move(level.points);
  mesh.normals = std::move(level.normals);
  for (std::size_t point = 0; point < mesh.points.size(); ++point) {
    const NodeIndex node = nodes[level.sources[point]];
    mesh.nodeOfPoint.push_back(node);
    mesh.damage.push_back(damage[node]);
    mesh.restPoints.push_back(mesh.points[point] + network.positions[node] - moment.positions[node]);
  }
  for (const auto& quad : level.quads) {
    const NodeIndex node = mesh.nodeOfPoint[quad[0]];
    mesh.faces.push_back({.points = quad,
                          .normals = quad,
                          .material = network.nodeMaterials[node],
                          .part = network.nodeParts[node],
                          .fragment = moment.broken->fragmentOfNode[node]});
  }
  // Faces of a fragment stand together, as in all surfaces.
  std::stable_sort(mesh.faces.begin(), mesh.faces.end(),
                   [](const auto& left, const auto& right) { return left.fragment < right.fragment; });
  return mesh;
}

}  // namespace sim
