#include "ui/viewport/level_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ui {
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
  Field(const std::vector<FieldNode>& nodes, std::size_t mostCubes) {
    Eigen::AlignedBox3d box;
    double reach = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    for (const FieldNode& node : nodes) {
      box.extend(node.position);
      reach = std::max(reach, node.reach);
      smallest = std::min(smallest, node.reach);
    }
    box.extend(sim::Vec3(box.min().array() - 1.01 * reach));
    box.extend(sim::Vec3(box.max().array() + 1.01 * reach));
    origin_ = box.min();
    step_ = std::max(smallest / 5.0, std::cbrt(box.volume() / static_cast<double>(mostCubes)));
    for (int axis = 0; axis < 3; ++axis)
      size_[axis] = 2 + static_cast<int>(std::ceil(box.sizes()[axis] / step_));
    const std::size_t count = index(0, 0, size_[2]);
    values_.assign(count, 0.0F);
    strongest_.assign(count, 0.0F);
    colours_.assign(count, 0);
  }

  void add(const FieldNode& node) {
    std::array<int, 3> low{};
    std::array<int, 3> high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      low[axis] = static_cast<int>(std::ceil((node.position[at] - node.reach - origin_[at]) / step_));
      high[axis] = static_cast<int>(std::floor((node.position[at] + node.reach - origin_[at]) / step_));
    }
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1]; ++j) {
        for (int i = low[0]; i <= high[0]; ++i) {
          const double squared = (point(i, j, k) - node.position).squaredNorm();
          const auto value = static_cast<float>(potential(squared / (node.reach * node.reach)));
          const std::size_t at = index(i, j, k);
          values_[at] += value;
          if (value <= strongest_[at]) continue;
          strongest_[at] = value;
          colours_[at] = node.colour;
        }
      }
    }
  }

  const Eigen::Array3i& size() const { return size_; }
  std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(size_[0]) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(k));
  }
  sim::Vec3 point(double i, double j, double k) const { return origin_ + step_ * sim::Vec3(i, j, k); }
  float above(int i, int j, int k) const { return values_[index(i, j, k)] - kLevel; }
  std::uint32_t colour(int i, int j, int k) const { return colours_[index(i, j, k)]; }

 private:
  sim::Vec3 origin_ = sim::Vec3::Zero();
  double step_ = 1.0;
  Eigen::Array3i size_ = Eigen::Array3i::Zero();
  std::vector<float> values_;
  std::vector<float> strongest_;
  std::vector<std::uint32_t> colours_;
};

class NetMaker {
 public:
  explicit NetMaker(const Field& field)
      : field_(field), vertexOfCube_(field.index(0, 0, field.size()[2]), sim::kNone) {}

  void addVertex(int i, int j, int k) {
    sim::Vec3 sum = sim::Vec3::Zero();
    sim::Vec3 slope = sim::Vec3::Zero();
    int crossings = 0;
    std::array<float, 8> corner{};
    for (unsigned c = 0; c < 8; ++c) corner[c] = field_.above(i + bit(c, 0), j + bit(c, 1), k + bit(c, 2));
    for (unsigned a = 0; a < 8; ++a) {
      for (unsigned axis = 0; axis < 3; ++axis) {
        if (bit(a, axis) != 0) continue;
        const unsigned b = a | (1U << axis);
        slope[axis] += static_cast<double>(corner[b] - corner[a]);
        if ((corner[a] > 0.0F) == (corner[b] > 0.0F)) continue;
        sim::Vec3 at(bit(a, 0), bit(a, 1), bit(a, 2));
        at[axis] = static_cast<double>(corner[a] / (corner[a] - corner[b]));
        sum += at;
        ++crossings;
      }
    }
    if (crossings == 0) return;
    sum /= crossings;
    const sim::Vec3 position = field_.point(i + sum.x(), j + sum.y(), k + sum.z());
    const double steepness = slope.norm();
    const sim::Vec3 normal = steepness > 0.0 ? sim::Vec3(-slope / steepness) : sim::Vec3::UnitZ();
    vertexOfCube_[field_.index(i, j, k)] = static_cast<std::uint32_t>(draw_.vertices.size());
    draw_.vertices.push_back({{static_cast<float>(position.x()), static_cast<float>(position.y()),
                               static_cast<float>(position.z())},
                              packNormal(normal),
                              field_.colour(i + (sum.x() > 0.5), j + (sum.y() > 0.5), k + (sum.z() > 0.5))});
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
        quad[c] = vertexOfCube_[field_.index(cube[0], cube[1], cube[2])];
      }
      if (!here) std::swap(quad[1], quad[3]);
      for (const std::size_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) draw_.indices.push_back(quad[corner]);
    }
  }

  LevelDraw take() { return std::move(draw_); }

 private:
  static int bit(unsigned corner, unsigned axis) { return static_cast<int>((corner >> axis) & 1U); }

  const Field& field_;
  std::vector<std::uint32_t> vertexOfCube_;
  LevelDraw draw_;
};

}  // namespace

LevelDraw levelSurface(const std::vector<FieldNode>& nodes, std::size_t mostCubes,
                       const std::function<bool()>& cancelled) {
  if (nodes.empty()) return {};
  Field field(nodes, mostCubes);
  for (const FieldNode& node : nodes) field.add(node);
  NetMaker maker(field);
  const Eigen::Array3i size = field.size();
  for (int k = 0; k + 1 < size[2]; ++k) {
    if (cancelled()) return {};
    for (int j = 0; j + 1 < size[1]; ++j) {
      for (int i = 0; i + 1 < size[0]; ++i) maker.addVertex(i, j, k);
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

}  // namespace ui
