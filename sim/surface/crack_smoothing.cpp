#include "sim/surface/crack_smoothing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "sim/base/parallel.h"

namespace sim {

namespace {

/// Each pass moves a point by this share of the way to the middle of its neighbours; so many passes
/// straighten steps of up to some four cells.
constexpr double kStep = 0.6;
constexpr int kPasses = 48;
constexpr std::size_t kGrain = 1024;

/// A link between neighbours, with the curve on the outside told apart: its points follow it alone.
struct Links {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> neighbours;
};

Links linksOf(const std::vector<CrackNet::Vertex>& vertices,
              std::span<const CrackNet::Interface> interfaces) {
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

/// A vertex that smoothing moves, and how far it may.
class Mover {
 public:
  Mover(const CrackNet::Vertex& of, std::uint32_t place)
      : vertex(place),
        start_(of.start),
        // Without spans it stays: any way is too far.
        sharesOf_(std::abs(of.spans.determinant()) > 0.0
                      ? Eigen::Matrix3d(of.spans.inverse() / of.reach)
                      : Eigen::Matrix3d(kTooFar * Eigen::Matrix3d::Identity())),
        along_(Eigen::Matrix3d::Identity()) {
    if (!of.outside) return;
    const Eigen::Matrix3d onto = of.direction * of.direction.transpose();
    along_ = of.creaseSide != 0xff ? onto : Eigen::Matrix3d(along_ - onto);
  }

  Vec3 constrained(const Vec3& wanted) const {
    const Vec3 offset = along_ * (wanted - start_);
    const double most = (sharesOf_ * offset).cwiseAbs().maxCoeff();
    return start_ + (most <= 1.0 ? 1.0 : 1.0 / most) * offset;
  }

  std::uint32_t vertex;

 private:
  static constexpr double kTooFar = 1e100;

  Vec3 start_;
  Eigen::Matrix3d sharesOf_;  ///< of an offset, the shares of the way that it may go along each span
  Eigen::Matrix3d along_;     ///< onto the outside, or an edge of the body
};

/// Where smoothing put the vertex, brought back onto the curved outside.
Vec3 onOutside(const CellComplex& complex, const WholeOutside& whole, const CrackNet::Vertex& vertex) {
  const Network& network = complex.network();
  Vec3 nearest = vertex.start;
  double distance = std::numeric_limits<double>::infinity();
  for (const std::uint32_t place : vertex.outsideFaces) {
    const auto nodes = complex.nodesOf(complex.outsideFaces()[place]).nodes;
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
    const Vec3 point = whole.curved.point(place, at.x(), at.y());
    const double apart = (point - vertex.position).squaredNorm();
    if (apart < distance) {
      distance = apart;
      nearest = point;
    }
    if (vertex.creaseSide != 0xff) break;
  }
  return nearest;
}

}  // namespace

void smoothCracks(const CellComplex& complex, const WholeOutside& whole,
                  std::span<const CrackNet::Interface> interfaces, std::vector<CrackNet::Vertex>& vertices) {
  const Links links = linksOf(vertices, interfaces);
  std::vector<Mover> movers;
  std::vector<Vec3> now;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    now.push_back(vertices[i].position);
    if (mayMove(vertices[i], links.first[i + 1] - links.first[i])) movers.emplace_back(vertices[i], i);
  }
  std::vector<Vec3> next = now;
  for (int pass = 0; pass < kPasses; ++pass) {
    parallelRanges(movers.size(), kGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
      for (std::size_t m = begin; m < end; ++m) {
        const std::uint32_t i = movers[m].vertex;
        Vec3 sum = Vec3::Zero();
        for (std::uint32_t l = links.first[i]; l < links.first[i + 1]; ++l) sum += now[links.neighbours[l]];
        const double count = links.first[i + 1] - links.first[i];
        next[i] = movers[m].constrained(now[i] + kStep * (sum / count - now[i]));
      }
    });
    now.swap(next);
  }
  for (const Mover& mover : movers) {
    CrackNet::Vertex& vertex = vertices[mover.vertex];
    vertex.position = now[mover.vertex];
    if (vertex.outside) vertex.position = onOutside(complex, whole, vertex);
  }
}

}  // namespace sim
