#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "sim/network/crack_net.h"

namespace sim {

namespace {

/// Each pass moves a point by this share of the way to the middle of its neighbours; so many passes
/// straighten steps of up to some four cells.
constexpr double kStep = 0.6;
constexpr int kPasses = 48;

/// A link between neighbours, with the curve on the outside told apart: its points follow it alone.
struct Links {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> neighbours;
};

Links linksOf(const std::vector<CrackNet::Vertex>& vertices,
              const std::vector<CrackNet::Interface>& interfaces) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const auto& interface : interfaces) {
    const auto& v = interface.vertices;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t a = v[i];
      const std::uint32_t b = v[(i + 1) % 4];
      // The cell's middle is never outside; of the others an edge's and a side's middle are joined.
      const bool outside = vertices[a].outside && vertices[b].outside;
      if (outside || !vertices[a].outside) pairs.emplace_back(a, b);
      if (outside || !vertices[b].outside) pairs.emplace_back(b, a);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Links links;
  links.first.assign(vertices.size() + 1, 0);
  for (const auto& [from, to] : pairs) {
    ++links.first[from + 1];
    links.neighbours.push_back(to);
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) links.first[i + 1] += links.first[i];
  return links;
}

/// Where everything still hangs together the crack ends, and there it stays; so does the end of a curve.
bool mayMove(const CrackNet::Vertex& vertex, std::uint32_t neighbours) {
  const auto* const end = vertex.groups.data() + vertex.nodeCount;
  const bool apart =
      std::any_of(vertex.groups.data(), end, [&](auto group) { return group != vertex.groups[0]; });
  return apart && neighbours >= 2 && !vertex.fixed;
}

/// (u, v) of the point of a bilinear quadrilateral that is nearest to `wanted`, to where it is not worth
/// while to go on.
Eigen::Vector2d nearestShares(const std::array<Vec3, 4>& corners, const Vec3& wanted) {
  Eigen::Vector2d at(0.5, 0.5);
  for (int round = 0; round < 6; ++round) {
    const double u = at.x();
    const double v = at.y();
    const Vec3 here =
        (1 - v) * ((1 - u) * corners[0] + u * corners[1]) + v * ((1 - u) * corners[3] + u * corners[2]);
    Eigen::Matrix<double, 3, 2> slopes;
    slopes.col(0) = (1 - v) * (corners[1] - corners[0]) + v * (corners[2] - corners[3]);
    slopes.col(1) = (1 - u) * (corners[3] - corners[0]) + u * (corners[2] - corners[1]);
    const Eigen::Matrix2d normal = slopes.transpose() * slopes;
    const double determinant = normal.determinant();
    if (!(determinant > 0.0)) break;
    const Eigen::Vector2d step = normal.inverse() * (slopes.transpose() * (wanted - here));
    at = (at + step).cwiseMax(0.0).cwiseMin(1.0);
    if (step.norm() < 1e-6) break;
  }
  return at;
}

}  // namespace

Vec3 CrackNet::constrained(const Vertex& vertex, const Vec3& wanted) const {
  Vec3 offset = wanted - vertex.start;
  if (vertex.outside) {
    const Vec3 along = vertex.direction.dot(offset) * vertex.direction;
    offset = vertex.creaseSide != 0xff ? along : Vec3(offset - along);
  }
  const double determinant = vertex.spans.determinant();
  if (!(std::abs(determinant) > 0.0)) return vertex.start;
  const Vec3 shares = vertex.spans.inverse() * offset;
  const double most = shares.cwiseAbs().maxCoeff();
  return vertex.start + (most <= vertex.reach ? 1.0 : vertex.reach / most) * offset;
}

/// Where smoothing put it, brought back onto the curved outside.
Vec3 CrackNet::onOutside(const Vertex& vertex) const {
  const Network& network = complex_.network();
  Vec3 nearest = vertex.start;
  double distance = std::numeric_limits<double>::infinity();
  for (const std::uint32_t place : vertex.outsideFaces) {
    const auto nodes = complex_.nodesOf(complex_.outsideFaces()[place]).nodes;
    std::array<Vec3, 4> corners;
    for (std::size_t c = 0; c < 4; ++c) corners[c] = network.positions[nodes[c]];
    Eigen::Vector2d at = nearestShares(corners, vertex.position);
    if (vertex.creaseSide != 0xff) {
      const Vec3 from = corners[vertex.creaseSide];
      const Vec3 chord = corners[(vertex.creaseSide + 1U) % 4] - from;
      const double share = std::clamp((vertex.position - from).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
      static constexpr std::array<std::array<double, 2>, 5> kCorners{
          {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
      const auto& low = kCorners[vertex.creaseSide];
      const auto& high = kCorners[vertex.creaseSide + 1U];
      at = {low[0] + share * (high[0] - low[0]), low[1] + share * (high[1] - low[1])};
    }
    const Vec3 point = whole_.curved.point(place, at.x(), at.y());
    const double apart = (point - vertex.position).squaredNorm();
    if (apart < distance) {
      distance = apart;
      nearest = point;
    }
    if (vertex.creaseSide != 0xff) break;
  }
  return nearest;
}

void CrackNet::smooth() {
  const Links links = linksOf(vertices_, interfaces_);
  std::vector<Vec3> next(vertices_.size());
  for (int pass = 0; pass < kPasses; ++pass) {
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const Vertex& vertex = vertices_[i];
      next[i] = vertex.position;
      const std::uint32_t count = links.first[i + 1] - links.first[i];
      if (!mayMove(vertex, count)) continue;
      Vec3 sum = Vec3::Zero();
      for (std::uint32_t l = links.first[i]; l < links.first[i + 1]; ++l)
        sum += vertices_[links.neighbours[l]].position;
      next[i] = constrained(vertex, vertex.position + kStep * (sum / count - vertex.position));
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) vertices_[i].position = next[i];
  }
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    Vertex& vertex = vertices_[i];
    if (vertex.outside && mayMove(vertex, links.first[i + 1] - links.first[i]))
      vertex.position = onOutside(vertex);
  }
}

}  // namespace sim
