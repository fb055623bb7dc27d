#include "modeling/exchange/rounded_surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "sim/surface/curved_faces.h"

namespace modeling {

namespace {

using sim::Vec3;
using Face = sim::SurfaceMeshFace;
using Weights = std::array<float, 4>;

/// As finely as pictures divide a face.
constexpr unsigned kMostParts = 6;
constexpr std::uint32_t kNone = sim::kNone;

/// Outside triangles are patches whose last side has no length; those of broken ground are flat.
bool isPatch(const Face& face) {
  return face.cornerCount == 4 || !face.inside;
}

unsigned sideCount(const Face& face) {
  return isPatch(face) ? 4 : 3;
}

/// (u, v) of a patch at a share of the way along one of its sides.
Eigen::Vector2d alongSide(unsigned side, double share) {
  switch (side) {
    case 0:
      return {share, 0.0};
    case 1:
      return {1.0, share};
    case 2:
      return {1.0 - share, 1.0};
    default:
      return {0.0, 1.0 - share};
  }
}

Weights patchWeights(double u, double v) {
  return {static_cast<float>((1 - u) * (1 - v)), static_cast<float>(u * (1 - v)), static_cast<float>(u * v),
          static_cast<float>((1 - u) * v)};
}

/// An edge between two points, low < high. Edges opposite each other in a patch are divided alike: they are
/// one class, a tree whose root counts.
struct Edge {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t parent = 0;
  unsigned parts = 1;
  std::uint32_t patch =
      kNone;          ///< a patch with this edge, which says how it is curved; kNone: it is straight
  unsigned side = 0;  ///< of the patch
  std::uint32_t firstPoint = kNone;  ///< of those between its ends, once there are any
};

class SurfaceRounder {
 public:
  explicit SurfaceRounder(const sim::SurfaceMesh& surface)
      : surface_(surface), curved_(surface), edgesOfFace_(surface.faces.size()) {
    result_.points = surface.points;
    result_.normals = surface.normals;
    result_.damage = surface.damage;
    result_.damage.resize(surface.points.size(), 0.0F);
    findEdges();
    joinOpposites();
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
      Edge& root = edges_[rootOf(edge)];
      root.parts = std::max(root.parts, partsOf(edges_[edge]));
    }
  }

  RoundedSurface run() {
    for (std::uint32_t face = 0; face < surface_.faces.size(); ++face) {
      if (isPatch(surface_.faces[face])) {
        addPatch(face);
      } else {
        addFlat(face);
      }
    }
    return std::move(result_);
  }

 private:
  void findEdges() {
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    known.reserve(3 * surface_.faces.size());
    for (std::uint32_t f = 0; f < surface_.faces.size(); ++f) {
      const Face& face = surface_.faces[f];
      const unsigned count = sideCount(face);
      for (unsigned side = 0; side < count; ++side) {
        const auto [low, high] = std::minmax(face.points[side], face.points[(side + 1) % count]);
        if (low == high) {
          edgesOfFace_[f][side] = kNone;
          continue;
        }
        const auto [found, isNew] =
            known.try_emplace(std::uint64_t{low} << 32U | high, static_cast<std::uint32_t>(edges_.size()));
        if (isNew) edges_.push_back({.low = low, .high = high, .parent = found->second});
        Edge& edge = edges_[found->second];
        if (edge.patch == kNone && isPatch(face)) std::tie(edge.patch, edge.side) = std::tuple(f, side);
        edgesOfFace_[f][side] = found->second;
      }
    }
  }

  std::uint32_t rootOf(std::uint32_t edge) {
    while (edges_[edge].parent != edge) edge = edges_[edge].parent = edges_[edges_[edge].parent].parent;
    return edge;
  }

  void joinOpposites() {
    for (std::uint32_t f = 0; f < surface_.faces.size(); ++f) {
      if (!isPatch(surface_.faces[f])) continue;
      for (const unsigned side : {0U, 1U}) {
        const std::uint32_t a = edgesOfFace_[f][side];
        const std::uint32_t b = edgesOfFace_[f][side + 2];
        if (a != kNone && b != kNone) edges_[rootOf(a)].parent = rootOf(b);
      }
    }
  }

  /// A curve that leaves the middle of its chord by s turns by 4 atan(2 s / chord), where it is an arc.
  unsigned partsOf(const Edge& edge) const {
    if (edge.patch == kNone) return 1;
    const Vec3& from = surface_.points[edge.low];
    const Vec3 chord = surface_.points[edge.high] - from;
    const double length = chord.norm();
    if (!(length > 0.0)) return 1;
    double away = 0.0;
    for (const double share : {0.25, 0.5, 0.75}) {
      const Eigen::Vector2d at = alongSide(edge.side, share);
      away = std::max(away, (curved_.point(edge.patch, at.x(), at.y()) - from).cross(chord).norm() / length);
    }
    const double turn = 4.0 * std::atan(2.0 * away / length) * 180.0 / std::numbers::pi;
    // What rounding adds to an angle makes no parts.
    return std::clamp(static_cast<unsigned>(std::ceil(turn / kRoundAngle - 0.01)), 1U, kMostParts);
  }

  unsigned partsOfSide(std::uint32_t face, unsigned side) {
    const std::uint32_t edge = edgesOfFace_[face][side];
    return edge == kNone ? 1 : edges_[rootOf(edge)].parts;
  }

  std::uint32_t addPoint(const Vec3& point, float damage) {
    result_.points.push_back(point);
    result_.damage.push_back(damage);
    return static_cast<std::uint32_t>(result_.points.size() - 1);
  }

  std::uint32_t addNormal(const Vec3& normal) {
    result_.normals.push_back(normal);
    return static_cast<std::uint32_t>(result_.normals.size() - 1);
  }

  float damageAt(const Face& face, const Weights& weights) const {
    float sum = 0.0F;
    for (std::size_t c = 0; c < 4; ++c) sum += weights[c] * result_.damage[face.points[c]];
    return sum;
  }

  Vec3 normalAt(const Face& face, const Weights& weights) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t c = 0; c < 4; ++c)
      sum += static_cast<double>(weights[c]) * surface_.normals[face.normals[c]];
    return sum.squaredNorm() > 0.0 ? Vec3(sum.normalized()) : surface_.normals[face.normals[0]];
  }

  /// All points between the ends of an edge, made when the first is asked for.
  void divide(Edge& edge, unsigned parts) {
    edge.firstPoint = static_cast<std::uint32_t>(result_.points.size());
    const bool forward = edge.patch == kNone || surface_.faces[edge.patch].points[edge.side] == edge.low;
    for (unsigned k = 1; k < parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      const Eigen::Vector2d at = alongSide(edge.side, forward ? share : 1.0 - share);
      const Vec3 straight = (1.0 - share) * surface_.points[edge.low] + share * surface_.points[edge.high];
      const auto part = static_cast<float>(share);
      addPoint(edge.patch == kNone ? straight : curved_.point(edge.patch, at.x(), at.y()),
               (1.0F - part) * result_.damage[edge.low] + part * result_.damage[edge.high]);
    }
  }

  /// The corner `step` parts along a side of a face, in the face's direction.
  RoundedSurface::Corner onSide(std::uint32_t f, unsigned side, unsigned step, const Weights& weights) {
    const Face& face = surface_.faces[f];
    const unsigned next = (side + 1) % sideCount(face);
    const std::uint32_t number = edgesOfFace_[f][side];
    const unsigned parts = partsOfSide(f, side);
    if (step == 0 || number == kNone) return {face.points[side], face.normals[side], weights};
    if (step == parts) return {face.points[next], face.normals[next], weights};
    Edge& edge = edges_[number];
    if (edge.firstPoint == kNone) divide(edge, parts);
    const bool forward = face.points[side] == edge.low;
    const unsigned fromLow = forward ? step : parts - step;
    const std::uint32_t lowNormal = face.normals[forward ? side : next];
    const std::uint32_t highNormal = face.normals[forward ? next : side];
    const auto [found, isNew] = edgeNormals_.try_emplace({number, fromLow, lowNormal, highNormal}, 0U);
    if (isNew) {
      const double share = static_cast<double>(fromLow) / parts;
      const Vec3 mixed = (1.0 - share) * surface_.normals[lowNormal] + share * surface_.normals[highNormal];
      found->second =
          addNormal(mixed.squaredNorm() > 0.0 ? Vec3(mixed.normalized()) : surface_.normals[lowNormal]);
    }
    return {edge.firstPoint + fromLow - 1, found->second, weights};
  }

  void addTriangle(std::uint32_t face, const RoundedSurface::Corner& a, const RoundedSurface::Corner& b,
                   const RoundedSurface::Corner& c) {
    if (a.point != b.point && b.point != c.point && c.point != a.point)
      result_.triangles.push_back({face, {a, b, c}});
  }

  RoundedSurface::Corner gridCorner(std::uint32_t f, unsigned i, unsigned j, unsigned across, unsigned up) {
    const double u = static_cast<double>(i) / across;
    const double v = static_cast<double>(j) / up;
    const Weights weights = patchWeights(u, v);
    // A side without length has the corner that both of its ends are.
    if (j == 0) return onSide(f, 0, i, weights);
    if (j == up) return onSide(f, 2, edgesOfFace_[f][2] == kNone ? 0 : across - i, weights);
    if (i == across) return onSide(f, 1, j, weights);
    if (i == 0) return onSide(f, 3, up - j, weights);
    const Face& face = surface_.faces[f];
    return {addPoint(curved_.point(f, u, v), damageAt(face, weights)), addNormal(normalAt(face, weights)),
            weights};
  }

  void addPatch(std::uint32_t f) {
    const unsigned across = std::max(partsOfSide(f, 0), partsOfSide(f, 2));
    const unsigned up = std::max(partsOfSide(f, 1), partsOfSide(f, 3));
    std::vector<RoundedSurface::Corner> grid;
    for (unsigned j = 0; j <= up; ++j) {
      for (unsigned i = 0; i <= across; ++i) grid.push_back(gridCorner(f, i, j, across, up));
    }
    const std::size_t row = across + 1;
    for (std::size_t j = 0; j < up; ++j) {
      for (std::size_t i = 0; i < across; ++i) {
        const std::size_t at = j * row + i;
        addTriangle(f, grid[at], grid[at + 1], grid[at + row + 1]);
        addTriangle(f, grid[at], grid[at + row + 1], grid[at + row]);
      }
    }
  }

  /// A flat triangle some of whose sides are divided because of what is on their other side: a fan about its
  /// middle.
  void addFlat(std::uint32_t f) {
    std::vector<RoundedSurface::Corner> ring;
    for (unsigned side = 0; side < 3; ++side) {
      const unsigned parts = partsOfSide(f, side);
      for (unsigned step = 0; step < parts; ++step) {
        const float share = static_cast<float>(step) / static_cast<float>(parts);
        Weights weights{};
        weights[side] = 1.0F - share;
        weights[(side + 1) % 3] = share;
        ring.push_back(onSide(f, side, step, weights));
      }
    }
    if (ring.size() == 3) {
      addTriangle(f, ring[0], ring[1], ring[2]);
      return;
    }
    const Face& face = surface_.faces[f];
    const Weights third{1.0F / 3.0F, 1.0F / 3.0F, 1.0F / 3.0F, 0.0F};
    Vec3 middle = Vec3::Zero();
    for (std::size_t c = 0; c < 3; ++c) middle += surface_.points[face.points[c]] / 3.0;
    const RoundedSurface::Corner centre{addPoint(middle, damageAt(face, third)),
                                        addNormal(normalAt(face, third)), third};
    for (std::size_t i = 0; i < ring.size(); ++i)
      addTriangle(f, centre, ring[i], ring[(i + 1) % ring.size()]);
  }

  const sim::SurfaceMesh& surface_;
  sim::CurvedFaces curved_;
  std::vector<Edge> edges_;
  std::vector<std::array<std::uint32_t, 4>> edgesOfFace_;  ///< kNone: a side without length
  /// By edge, parts from its low end, and the normals of its ends.
  std::map<std::tuple<std::uint32_t, unsigned, std::uint32_t, std::uint32_t>, std::uint32_t> edgeNormals_;
  RoundedSurface result_;
};

}  // namespace

RoundedSurface roundedSurface(const sim::SurfaceMesh& surface) {
  return SurfaceRounder(surface).run();
}

}  // namespace modeling
