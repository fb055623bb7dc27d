#include "sim/surface/surface_topology.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "sim/base/parallel.h"

namespace sim {

namespace {

/// Degrees between face normals. A cylinder needs at least eight faces around to be smooth; the rim of a slab
/// (90) stays sharp.
constexpr double kCreaseAngle = 50.0;

constexpr std::size_t kGrain = 512;

/// A loose node turns with the nodes that were around it as long as they are near; where they have gone, it
/// keeps to its orientation at rest: that is the weight of staying, against one of each near neighbour.
constexpr double kStay = 0.15;

Vec3 unitOr(const Vec3& vector, const Vec3& fallback) {
  const double length = vector.norm();
  return length > 0.0 && std::isfinite(length) ? Vec3(vector / length) : fallback;
}

Vec3 faceNormal(const std::vector<Vec3>& points, const SurfaceMeshFace& face) {
  const Vec3 diagonal = points[face.points[2]] - points[face.points[0]];
  const Vec3 other = points[face.points[3]] - points[face.points[1]];
  const Vec3 across = face.cornerCount == 3 ? Vec3(points[face.points[1]] - points[face.points[0]]) : other;
  return unitOr(face.cornerCount == 3 ? across.cross(diagonal) : diagonal.cross(other), Vec3::UnitZ());
}

using Map = Eigen::Matrix3d;

Map stretchOf(const SurfaceTopology& topology, const SurfaceTopology::Fit& fit,
              const std::vector<Vec3>& positions) {
  Map stretch = Map::Zero();
  for (std::uint32_t i = fit.firstSupport; i < fit.lastSupport; ++i) {
    const auto& support = topology.supports[i];
    stretch += (positions[support.node] - positions[fit.node]) * support.vector.transpose();
  }
  return stretch;
}

Map rotationOf(const SurfaceTopology& topology, const SurfaceTopology::Fit& fit,
               const std::vector<Vec3>& positions) {
  Map sum = Map::Zero();
  double staying = 0.0;
  for (std::uint32_t i = fit.firstSupport; i < fit.lastSupport; ++i) {
    const auto& support = topology.supports[i];
    const Vec3 now = positions[support.node] - positions[fit.node];
    const double squared = support.vector.squaredNorm();
    // Two to the sixth: 1 where it was, a hundredth at little more than twice the distance.
    const double apart = now.squaredNorm() / squared;
    const double near = 2.0 / (1.0 + apart * apart * apart);
    sum += near / squared * now * support.vector.transpose();
    staying = kStay;
  }
  sum += staying * Map::Identity();
  if (!sum.allFinite()) return Map::Identity();
  const Eigen::JacobiSVD<Map> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Map turned = svd.matrixU() * svd.matrixV().transpose();
  if (turned.determinant() < 0.0) {
    const Map mirrored = svd.matrixU() * Vec3(1.0, 1.0, -1.0).asDiagonal();
    turned = mirrored * svd.matrixV().transpose();
  }
  return turned;
}

std::vector<Map> mapsOf(const SurfaceTopology& topology, const std::vector<Vec3>& positions) {
  std::vector<Map> maps(topology.fits.size());
  parallelRanges(maps.size(), kGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& fit = topology.fits[i];
      const bool bare = fit.firstSupport == fit.lastSupport;
      maps[i] = bare        ? Map(Map::Identity())
                : fit.rigid ? rotationOf(topology, fit, positions)
                            : stretchOf(topology, fit, positions);
    }
  });
  return maps;
}

Vec3 weightedNormal(const SurfaceTopology& topology, const std::vector<Vec3>& points, std::uint32_t corner) {
  const auto& face = topology.faces[corner / 4];
  const std::uint32_t count = face.cornerCount;
  const std::uint32_t place = corner % 4;
  const Vec3& here = points[face.points[place]];
  const Vec3 forward = points[face.points[(place + 1) % count]] - here;
  const Vec3 backward = points[face.points[(place + count - 1) % count]] - here;
  const Vec3 cross = forward.cross(backward);
  return unitOr(cross, Vec3::Zero()) * std::atan2(cross.norm(), forward.dot(backward));
}

/// Finds which corners about a point share a normal.
class NormalGrouping {
 public:
  explicit NormalGrouping(SurfaceTopology& topology) : topology_(topology) {
    restNormals_.reserve(topology.faces.size());
    for (const auto& face : topology.faces) restNormals_.push_back(faceNormal(topology.restPoints, face));
  }

  void addPoint(const std::uint32_t* corners, std::size_t count) {
    group(corners, count);
    for (std::size_t i = 0; i < count; ++i) {
      if (groups_[i] != i) continue;
      const auto normal = static_cast<std::uint32_t>(topology_.normalCount());
      for (std::size_t j = i; j < count; ++j) {
        if (groups_[j] != i) continue;
        auto& face = topology_.faces[corners[j] / 4];
        face.normals[corners[j] % 4] = normal;
        if (face.cornerCount == 3 && corners[j] % 4 == 2) face.normals[3] = normal;
        topology_.corners.push_back(corners[j]);
      }
      topology_.firstCorner.push_back(static_cast<std::uint32_t>(topology_.corners.size()));
    }
  }

 private:
  std::uint32_t neighbour(std::uint32_t corner, bool forward) const {
    const auto& face = topology_.faces[corner / 4];
    const std::uint32_t count = face.cornerCount;
    return face.points[(corner % 4 + (forward ? 1 : count - 1)) % count];
  }

  bool shareNormal(std::uint32_t a, std::uint32_t b) const {
    if (topology_.faces[a / 4].inside != topology_.faces[b / 4].inside) return false;
    if (neighbour(a, true) != neighbour(b, false) && neighbour(a, false) != neighbour(b, true)) return false;
    static const double kCosine = std::cos(kCreaseAngle * std::numbers::pi / 180.0);
    return restNormals_[a / 4].dot(restNormals_[b / 4]) > kCosine;
  }

  /// groups_[i]: the first corner of those i is joined to, directly or by others.
  void group(const std::uint32_t* corners, std::size_t count) {
    groups_.resize(count);
    std::iota(groups_.begin(), groups_.end(), std::size_t{0});
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (groups_[i] == groups_[j] || !shareNormal(corners[i], corners[j])) continue;
        const auto [kept, dropped] = std::minmax(groups_[i], groups_[j]);
        const std::size_t from = dropped;
        const std::size_t to = kept;
        std::replace(groups_.begin(), groups_.end(), from, to);
      }
    }
  }

  SurfaceTopology& topology_;
  std::vector<Vec3> restNormals_;
  std::vector<std::size_t> groups_;
};

}  // namespace

std::vector<Vec3> placePoints(const SurfaceTopology& topology, const std::vector<Vec3>& positions) {
  const std::vector<Map> maps = mapsOf(topology, positions);
  std::vector<Vec3> points(topology.pointCount());
  parallelRanges(points.size(), kGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t point = begin; point < end; ++point) {
      const std::uint32_t first = topology.firstAnchor[point];
      const std::uint32_t last = topology.firstAnchor[point + 1];
      if (first == last) {
        points[point] = positions[topology.nodeOfPoint[point]];
        continue;
      }
      Vec3 sum = Vec3::Zero();
      for (std::uint32_t i = first; i < last; ++i) {
        const auto& anchor = topology.anchors[i];
        sum += positions[anchor.node] + maps[anchor.fit] * anchor.offset;
      }
      points[point] = sum / static_cast<double>(last - first);
    }
  });
  return points;
}

std::vector<Vec3> placeNormals(const SurfaceTopology& topology, const std::vector<Vec3>& points) {
  std::vector<Vec3> normals(topology.normalCount());
  parallelRanges(normals.size(), kGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t normal = begin; normal < end; ++normal) {
      Vec3 sum = Vec3::Zero();
      const std::uint32_t first = topology.firstCorner[normal];
      for (std::uint32_t i = first; i < topology.firstCorner[normal + 1]; ++i)
        sum += weightedNormal(topology, points, topology.corners[i]);
      normals[normal] = unitOr(sum, faceNormal(points, topology.faces[topology.corners[first] / 4]));
    }
  });
  return normals;
}

SurfaceMesh placeSurface(const SurfaceTopology& topology, const std::vector<Vec3>& positions) {
  SurfaceMesh mesh;
  mesh.points = placePoints(topology, positions);
  mesh.normals = placeNormals(topology, mesh.points);
  mesh.restPoints = topology.restPoints;
  mesh.nodeOfPoint = topology.nodeOfPoint;
  mesh.damage = topology.damage;
  mesh.faces = topology.faces;
  return mesh;
}

void groupNormals(SurfaceTopology& topology) {
  topology.firstCorner.assign(1, 0);
  topology.corners.clear();
  std::vector<std::uint32_t> start(topology.pointCount() + 1, 0);
  for (const auto& face : topology.faces) {
    for (std::uint32_t c = 0; c < face.cornerCount; ++c) ++start[face.points[c] + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> gathered(start.back());
  std::vector<std::uint32_t> end(start.begin(), start.end() - 1);
  for (std::uint32_t f = 0; f < topology.faces.size(); ++f) {
    const auto& face = topology.faces[f];
    for (std::uint32_t c = 0; c < face.cornerCount; ++c) gathered[end[face.points[c]]++] = 4 * f + c;
  }
  NormalGrouping grouping(topology);
  for (std::size_t point = 0; point < topology.pointCount(); ++point)
    grouping.addPoint(gathered.data() + start[point], start[point + 1] - start[point]);
}

void appendTopology(SurfaceTopology& topology, const SurfaceTopology& added) {
  const auto size = [](const auto& values) { return static_cast<std::uint32_t>(values.size()); };
  const std::uint32_t points = size(topology.restPoints);
  const std::uint32_t anchors = size(topology.anchors);
  const std::uint32_t fits = size(topology.fits);
  const std::uint32_t supports = size(topology.supports);
  const std::uint32_t faces = size(topology.faces);
  const auto normals = static_cast<std::uint32_t>(topology.normalCount());
  const std::uint32_t corners = size(topology.corners);
  const auto extend = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  extend(topology.restPoints, added.restPoints);
  extend(topology.nodeOfPoint, added.nodeOfPoint);
  extend(topology.damage, added.damage);
  for (std::size_t i = 1; i < added.firstAnchor.size(); ++i)
    topology.firstAnchor.push_back(added.firstAnchor[i] + anchors);
  for (SurfaceTopology::Anchor anchor : added.anchors) {
    anchor.fit += fits;
    topology.anchors.push_back(anchor);
  }
  for (SurfaceTopology::Fit fit : added.fits) {
    fit.firstSupport += supports;
    fit.lastSupport += supports;
    topology.fits.push_back(fit);
  }
  extend(topology.supports, added.supports);
  for (SurfaceMeshFace face : added.faces) {
    for (std::uint32_t& point : face.points) point += points;
    for (std::uint32_t& normal : face.normals) normal += normals;
    topology.faces.push_back(face);
  }
  for (std::size_t i = 1; i < added.firstCorner.size(); ++i)
    topology.firstCorner.push_back(added.firstCorner[i] + corners);
  for (const std::uint32_t corner : added.corners) topology.corners.push_back(corner + 4 * faces);
}

}  // namespace sim
