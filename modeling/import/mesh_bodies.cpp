#include "modeling/import/mesh_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

namespace modeling {
namespace {

using sim::TriangleMesh;
using sim::Vec3;
using Triangles = std::vector<TriangleMesh::Triangle>;

/// As many corners of a body are looked for within another.
constexpr std::size_t kMostProbes = 32;

/// Sets of triangles that become one when they are joined.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t of(std::uint32_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }
  void join(std::uint32_t left, std::uint32_t right) {
    left = of(left);
    right = of(right);
    parent_[std::max(left, right)] = std::min(left, right);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

struct Edge {
  std::uint32_t low, high, triangle;
  bool upward;  ///< the triangle goes from low to high
};

std::vector<Edge> sortedEdges(const Triangles& triangles) {
  std::vector<Edge> edges;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = triangles[t][c];
      const std::uint32_t b = triangles[t][(c + 1) % 3];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& left, const Edge& right) {
    return std::array{left.low, left.high, left.triangle} < std::array{right.low, right.high, right.triangle};
  });
  return edges;
}

struct Body {
  std::vector<std::uint32_t> triangles;
  double volume = 0.0;  ///< as it faces in the file
  Eigen::AlignedBox3d box;
  double facing = 1.0;                          ///< as it is to face: 1, or -1 for a hollow
  mutable std::unique_ptr<TriangleMesh> whole;  ///< facing outwards; made when it is first asked for
};

class Bodies {
 public:
  Bodies(const std::vector<Vec3>& points, Triangles& triangles) : points_(points), triangles_(triangles) {
    find();
    for (Body& body : bodies_) measure(body);
    std::stable_sort(bodies_.begin(), bodies_.end(), [](const Body& left, const Body& right) {
      return std::abs(left.volume) > std::abs(right.volume);
    });
  }

  MeshBodies turn() {
    MeshBodies report{bodies_.size(), 0, 0};
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      Body& body = bodies_[b];
      if (body.volume == 0.0) continue;
      const Body* outer = bodies_.size() <= kMostNestedBodies ? around(b) : nullptr;
      const bool agree = outer != nullptr && (body.volume > 0.0) == (outer->volume > 0.0);
      if (outer != nullptr) body.facing = agree ? outer->facing : -outer->facing;
      if (agree) ++report.filled;
      if ((body.volume > 0.0) == (body.facing > 0.0)) continue;
      ++report.turned;
      for (const std::uint32_t t : body.triangles) std::swap(triangles_[t][1], triangles_[t][2]);
    }
    return report;
  }

 private:
  /// Closed ones: every edge has two triangles that agree on what is outside.
  void find() {
    const std::vector<Edge> edges = sortedEdges(triangles_);
    Groups groups(triangles_.size());
    std::vector<std::uint8_t> isOpen(triangles_.size(), 0);
    for (std::size_t first = 0; first < edges.size();) {
      std::size_t last = first;
      while (last < edges.size() && edges[last].low == edges[first].low &&
             edges[last].high == edges[first].high)
        ++last;
      const bool isPair = last - first == 2;
      if (isPair) groups.join(edges[first].triangle, edges[first + 1].triangle);
      const bool isSound = isPair && edges[first].upward != edges[first + 1].upward;
      for (std::size_t e = first; e < last && !isSound; ++e) isOpen[edges[e].triangle] = 1;
      first = last;
    }
    std::vector<std::uint32_t> bodyOf(triangles_.size(), sim::kNone);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      if (isOpen[t] != 0) isOpen[groups.of(t)] = 1;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const std::uint32_t group = groups.of(t);
      if (isOpen[group] != 0) continue;
      if (bodyOf[group] == sim::kNone) {
        bodyOf[group] = static_cast<std::uint32_t>(bodies_.size());
        bodies_.emplace_back();
      }
      bodies_[bodyOf[group]].triangles.push_back(t);
    }
  }

  void measure(Body& body) const {
    const Vec3& origin = points_[triangles_[body.triangles.front()][0]];
    for (const std::uint32_t t : body.triangles) {
      std::array<Vec3, 3> corners;
      for (std::size_t c = 0; c < 3; ++c) {
        body.box.extend(points_[triangles_[t][c]]);
        corners[c] = points_[triangles_[t][c]] - origin;
      }
      body.volume += corners[0].dot(corners[1].cross(corners[2])) / 6.0;
    }
  }

  /// The smallest body that has all of this one inside; larger ones come first.
  const Body* around(std::size_t b) const {
    for (std::size_t other = b; other-- > 0;)
      if (bodies_[other].box.contains(bodies_[b].box) && isWithin(bodies_[b], bodies_[other]))
        return &bodies_[other];
    return nullptr;
  }

  bool isWithin(const Body& body, const Body& other) const {
    if (!other.whole) other.whole = outwards(other);
    const std::size_t step = std::max<std::size_t>(1, body.triangles.size() / kMostProbes);
    for (std::size_t i = 0; i < body.triangles.size(); i += step)
      if (other.whole->signedDistance(points_[triangles_[body.triangles[i]][0]]) >= 0.0) return false;
    return true;
  }

  std::unique_ptr<TriangleMesh> outwards(const Body& body) const {
    std::vector<Vec3> points;
    Triangles triangles;
    std::vector<std::uint32_t> used;
    for (const std::uint32_t t : body.triangles)
      used.insert(used.end(), triangles_[t].begin(), triangles_[t].end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const std::uint32_t point : used) points.push_back(points_[point]);
    // By now it faces as it is to.
    const bool isTurned = body.facing < 0.0;
    for (const std::uint32_t t : body.triangles) {
      TriangleMesh::Triangle& made = triangles.emplace_back();
      for (std::size_t c = 0; c < 3; ++c)
        made[c] = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), triangles_[t][c]) -
                                             used.begin());
      if (isTurned) std::swap(made[1], made[2]);
    }
    return std::make_unique<TriangleMesh>(std::move(points), triangles);
  }

  const std::vector<Vec3>& points_;
  Triangles& triangles_;
  std::vector<Body> bodies_;
};

}  // namespace

MeshBodies turnOutwards(const std::vector<Vec3>& points, Triangles& triangles) {
  return Bodies(points, triangles).turn();
}

}  // namespace modeling
