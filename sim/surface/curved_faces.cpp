#include "sim/surface/curved_faces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace sim {

/// A face's side, to be gathered with the others on its edge.
struct CurvedFaces::Side {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t face;
  std::uint32_t place;

  bool sameEdge(const Side& other) const { return low == other.low && high == other.high; }
};

namespace {

/// A curve that would leave its chord at more than this (60 degrees) belongs to a face too crumpled to curve.
constexpr double kLeastCosine = 0.5;

void addDistinct(std::vector<std::uint32_t>& values, std::uint32_t value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

Vec3 hermite(const Vec3& from, const Vec3& fromTangent, const Vec3& to, const Vec3& toTangent, double t) {
  const double s = 1.0 - t;
  return s * s * (1.0 + 2.0 * t) * from + t * s * s * fromTangent + t * t * (3.0 - 2.0 * t) * to -
         t * t * s * toTangent;
}

/// Triangles of the outside are quadrilaterals whose last side has no length; those of broken ground are
/// flat.
bool isCurved(const SurfaceMeshFace& face) {
  return face.cornerCount == 4 || !face.inside;
}

}  // namespace

CurvedFaces::CurvedFaces(const SurfaceMesh& surface) : surface_(surface), edgesOfFace_(surface.faces.size()) {
  std::vector<Side> sides;
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    const auto& face = surface.faces[f];
    if (!isCurved(face)) continue;
    for (std::uint32_t c = 0; c < 4; ++c) {
      const auto [low, high] = std::minmax(face.points[c], face.points[(c + 1) % 4]);
      sides.push_back({low, high, f, c});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
  std::vector<std::uint32_t> lowNormals, highNormals;
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    lowNormals.clear();
    highNormals.clear();
    for (; last < sides.size() && sides[last].sameEdge(sides[first]); ++last) {
      const Side& side = sides[last];
      const auto& face = surface.faces[side.face];
      edgesOfFace_[side.face][side.place] = static_cast<std::uint32_t>(edges_.size());
      if (face.inside) continue;
      const bool forward = face.points[side.place] == side.low;
      addDistinct(lowNormals, face.normals[(side.place + (forward ? 0U : 1U)) % 4]);
      addDistinct(highNormals, face.normals[(side.place + (forward ? 1U : 0U)) % 4]);
    }
    const auto [low, high] = std::pair(sides[first].low, sides[first].high);
    edges_.push_back({low, high, tangent(low, high, lowNormals), -tangent(high, low, highNormals)});
  }
}

// The length is that of the cubic which stays closest to a circle's arc: chord / cos^2(a / 2), a between
// chord and tangent.
Vec3 CurvedFaces::tangent(std::uint32_t at, std::uint32_t to,
                          const std::vector<std::uint32_t>& normals) const {
  const Vec3 chord = surface_.points[to] - surface_.points[at];
  Vec3 direction = chord;
  if (normals.size() == 1) {
    const Vec3& normal = surface_.normals[normals[0]];
    direction = chord - chord.dot(normal) * normal;
  } else if (normals.size() == 2) {
    direction = surface_.normals[normals[0]].cross(surface_.normals[normals[1]]);
    if (direction.dot(chord) < 0.0) direction = -direction;
  }
  const double lengths = direction.norm() * chord.norm();
  const double cosine = lengths > 0.0 ? direction.dot(chord) / lengths : 0.0;
  if (cosine < kLeastCosine) return chord;
  return direction.normalized() * (chord.norm() * 2.0 / (1.0 + cosine));
}

Vec3 CurvedFaces::sidePoint(std::size_t face, std::uint32_t side, double share) const {
  const Edge& edge = edges_[edgesOfFace_[face][side]];
  const bool forward = surface_.faces[face].points[side] == edge.low;
  return hermite(surface_.points[edge.low], edge.lowTangent, surface_.points[edge.high], edge.highTangent,
                 forward ? share : 1.0 - share);
}

Vec3 CurvedFaces::point(std::size_t face, double u, double v) const {
  const auto& corners = surface_.faces[face].points;
  const Vec3 bilinear = (1 - v) * ((1 - u) * surface_.points[corners[0]] + u * surface_.points[corners[1]]) +
                        v * ((1 - u) * surface_.points[corners[3]] + u * surface_.points[corners[2]]);
  return (1 - v) * sidePoint(face, 0, u) + v * sidePoint(face, 2, 1 - u) +
         (1 - u) * sidePoint(face, 3, 1 - v) + u * sidePoint(face, 1, v) - bilinear;
}

}  // namespace sim
