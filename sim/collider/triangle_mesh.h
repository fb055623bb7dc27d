#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "sim/base/types.h"

namespace sim {

/// A surface of triangles and how far from it any point is. Distance and side are found by a tree of boxes (a
/// bounding-volume hierarchy), in a time that grows with the logarithm of the triangles.
///
/// The side follows from normals of what is nearest: of a face, of an edge (the sum of its faces'), of a
/// corner (weighted by angles), after Baerentzen and Aanaes 2005; so that a point outside an edge is outside,
/// however sharp it is.
class TriangleMesh {
 public:
  using Triangle = std::array<std::uint32_t, 3>;  ///< counter-clockwise seen from outside

  /// Every index must be a point's. Triangles that name a point twice are passed over. What a person or a
  /// file gives is asked of checkSurface() first.
  TriangleMesh(std::vector<Vec3> points, const std::vector<Triangle>& triangles);

  /// What keeps it from enclosing a volume; all zero for a closed surface.
  struct Gaps {
    std::size_t openEdges = 0;     ///< with one triangle
    std::size_t crowdedEdges = 0;  ///< with more than two
    std::size_t flippedEdges = 0;  ///< whose two triangles do not agree on what is outside
    Vec3 first = Vec3::Zero();     ///< the middle of the first such edge

    std::size_t count() const { return openEdges + crowdedEdges + flippedEdges; }
  };
  const Gaps& gaps() const { return gaps_; }
  bool closed() const { return gaps_.count() == 0 && !triangles_.empty(); }
  /// Of a closed surface: the shortest way from the middle of a triangle straight in, to where it leaves
  /// again, cm; zero where it is open or inside out. A thousandth of its extent at least.
  double leastThickness() const { return leastThickness_; }
  /// Of a closed surface, cm^3; negative when it is inside out.
  double volume() const;

  struct Nearest {
    Vec3 point = Vec3::Zero();    ///< on the surface
    Vec3 normal = Vec3::UnitZ();  ///< unit, outward, of the face, edge or corner it is on
    double distance = 0.0;        ///< >= 0
    std::uint32_t triangle = kNone;
  };
  /// There must be a triangle. From one that is thought to be `near` it is found sooner; it is the same. Of a
  /// point that is no number, or too far away to square its distance, any triangle is the nearest.
  Nearest nearest(const Vec3& point, std::uint32_t near = kNone) const;
  /// Of a closed surface: negative inside.
  double signedDistance(const Vec3& point) const;

  /// Calls take(triangle) for every triangle that has a point between `low` and `high`, and for some others,
  /// until take() answers true. Answers whether it did.
  template <class Take>
  bool anyWithin(const Vec3& low, const Vec3& high, const Take& take) const;

  const std::vector<Vec3>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  Eigen::AlignedBox3d box() const;
  std::size_t memoryBytes() const;

  bool operator==(const TriangleMesh& other) const {
    return points_ == other.points_ && triangles_ == other.triangles_;
  }

 private:
  /// A box with two children behind each other in the list, or with triangles.
  struct Branch {
    Vec3 low, high;
    std::uint32_t first = 0;  ///< the first child, or the first of order_
    std::uint32_t count = 0;  ///< triangles; 0: it has children
  };
  struct Candidate;
  struct Ray;

  void findNormals();
  void grow();
  void split(std::uint32_t branch, std::uint32_t first, std::uint32_t last, const std::vector<Vec3>& middles);
  void look(std::uint32_t triangle, const Vec3& point, Candidate& best) const;
  double squaredDistance(const Branch& branch, const Vec3& point) const;
  void measureThickness();
  double wayThrough(std::uint32_t triangle) const;

  std::vector<Vec3> points_;
  std::vector<Triangle> triangles_;
  Gaps gaps_;
  double leastThickness_ = 0.0;
  std::vector<Vec3> faceNormals_;                 ///< one a triangle
  std::vector<std::array<Vec3, 3>> edgeNormals_;  ///< of the edge from corner i to the next
  std::vector<Vec3> cornerNormals_;               ///< one a point
  std::vector<std::uint32_t> order_;              ///< triangles as the branches have them
  std::vector<Branch> branches_;
};

template <class Take>
bool TriangleMesh::anyWithin(const Vec3& low, const Vec3& high, const Take& take) const {
  // Halving four thousand million triangles takes 32 levels; each leaves one sibling to be looked at later.
  std::array<std::uint32_t, 64> waiting{};
  std::size_t count = 0;
  if (!branches_.empty()) waiting[count++] = 0;
  while (count > 0) {
    const Branch& branch = branches_[waiting[--count]];
    if ((branch.low.array() > high.array()).any() || (branch.high.array() < low.array()).any()) continue;
    for (std::uint32_t i = 0; i < branch.count; ++i) {
      if (take(order_[branch.first + i])) return true;
    }
    if (branch.count > 0) continue;
    waiting[count++] = branch.first;
    waiting[count++] = branch.first + 1;
  }
  return false;
}

}  // namespace sim
