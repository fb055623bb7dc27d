#include "modeling/material/bond_fit.h"

#include <bit>
#include <cassert>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "modeling/material/checkerboard.h"
#include "modeling/material/congruence.h"
#include "sim/base/parallel.h"

namespace modeling {
namespace {

using PairVector = Eigen::Matrix<double, kPairsPerCell, 1>;
using PairMatrix = Eigen::Matrix<double, kPairsPerCell, kPairsPerCell>;

/// lambda = mu = 0.4 E: the Lame constants of an isotropic body with Poisson's ratio 1/4.
constexpr double kLame = 0.4;

constexpr std::array<CornerPair, kPairsPerCell> makeCornerPairs() {
  std::array<CornerPair, kPairsPerCell> pairs{};
  std::size_t next = 0;
  for (unsigned a = 0; a < 8; ++a)
    for (unsigned b = a + 1; b < 8; ++b)
      pairs[next++] = {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b),
                       static_cast<PairKind>(std::popcount(a ^ b) - 1)};
  return pairs;
}

/// kappa of startStiffness() by kind: k1, k2, k3 over E h of a lattice of cubes. All satisfy k1 = k2 + 8 k3 /
/// 3 (isotropic) and k2 + 4 k3 / 3 = 0.4 (E), where Fig. 2's k2 counts half since it has every second
/// diagonal.
std::array<double, 3> latticeStiffness(BondPattern pattern) {
  switch (pattern) {
    case BondPattern::full:
      return {0.6, 0.2, 0.15};
    case BondPattern::fig1:
      return {0.8, 0.0, 0.3};
    case BondPattern::fig2:
      return {0.4, 0.8, 0.0};
    case BondPattern::faces:
      return {0.4, 0.4, 0.0};
  }
  return {};
}

/// Weights of fitCell()'s second and third terms. Bars of the full pattern whose nodes are displaced at
/// random by up to 10 and 25 % of a cell have, with modulus 1e4, E / E0 = 0.9950 and 0.965 at patch 0, 0.9962
/// and 0.971 at 30, 0.9955 and 0.964 at 300. Modulus 1e3 lets boxes of 2 : 3 be 0.7 % too stiff; 1e6 gains
/// nothing and makes the stiffest bonds stiffer.
struct Weights {
  double modulus;
  double patch;
};
Weights weights(BondPattern pattern) {
  switch (pattern) {
    case BondPattern::full:
      return {1e4, 30.0};
    case BondPattern::fig1:
    case BondPattern::faces:
      return {100.0, 100.0};
    case BondPattern::fig2:  // four corners carry the diagonals; only with its neighbours is a cell in
                             // balance
      return {100.0, 0.0};
  }
  return {};
}

/// The volume's derivative with respect to each corner: what uniform stress pulls a corner with.
std::array<Vec3, 8> volumeGradient(const CornerPositions& corners) {
  std::array<Vec3, 8> gradient;
  gradient.fill(Vec3::Zero());
  constexpr double kGauss = 0.57735026918962576;  // +-1/sqrt 3: exact for the cubic polynomials at hand
  for (unsigned point = 0; point < 8; ++point) {
    const std::array<double, 3> at{(point & 1U) ? kGauss : -kGauss, (point & 2U) ? kGauss : -kGauss,
                                   (point & 4U) ? kGauss : -kGauss};
    std::array<Vec3, 8> slopes;
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    for (unsigned c = 0; c < 8; ++c) {
      const std::array<double, 3> side{(c & 1U) ? 1.0 : -1.0, (c & 2U) ? 1.0 : -1.0, (c & 4U) ? 1.0 : -1.0};
      const double u = 1.0 + side[0] * at[0];
      const double v = 1.0 + side[1] * at[1];
      const double w = 1.0 + side[2] * at[2];
      slopes[c] = Vec3(side[0] * v * w, side[1] * u * w, side[2] * u * v) / 8.0;
      jacobian += corners[c] * slopes[c].transpose();
    }
    Eigen::Matrix3d cofactors;
    cofactors.col(0) = jacobian.col(1).cross(jacobian.col(2));
    cofactors.col(1) = jacobian.col(2).cross(jacobian.col(0));
    cofactors.col(2) = jacobian.col(0).cross(jacobian.col(1));
    for (unsigned c = 0; c < 8; ++c) gradient[c] += cofactors * slopes[c];
  }
  return gradient;
}

struct PairGeometry {
  std::array<Vec3, kPairsPerCell> direction;  ///< unit, from a to b
  std::array<double, kPairsPerCell> length;
};

PairGeometry pairGeometry(const CornerPositions& corners) {
  PairGeometry geometry;
  for (std::size_t p = 0; p < kPairsPerCell; ++p) {
    const Vec3 edge = corners[kCornerPairs[p].b] - corners[kCornerPairs[p].a];
    geometry.length[p] = edge.norm();
    geometry.direction[p] = edge / geometry.length[p];
  }
  return geometry;
}

double parity(unsigned corner) {
  return (std::popcount(corner) & 1) ? -1.0 : 1.0;
}

/// What a unit pull of both pairs, each along itself, has in common on the corners: the sum over corners of
/// the product of their signs (+1 at a, -1 at b), without the part along the alternating motion.
double sharedCorners(const CornerPair& p, const CornerPair& q) {
  const auto sign = [](const CornerPair& pair, unsigned corner) {
    return corner == pair.a ? 1.0 : corner == pair.b ? -1.0 : 0.0;
  };
  const double direct = sign(p, q.a) - sign(p, q.b);
  return direct - (parity(p.a) - parity(p.b)) * (parity(q.a) - parity(q.b)) / 8.0;
}

const PairMatrix& sharedCornersOfAll() {
  static const PairMatrix shared = [] {
    PairMatrix all;
    for (std::size_t p = 0; p < kPairsPerCell; ++p)
      for (std::size_t q = 0; q < kPairsPerCell; ++q)
        all(Eigen::Index(p), Eigen::Index(q)) = sharedCorners(kCornerPairs[p], kCornerPairs[q]);
    return all;
  }();
  return shared;
}

/// The quadratic 1/2 y' M y - g' y whose least value fitCell() wants, y = k / start value.
/// Both misfits are sums over an orthonormal basis of symmetric strains, and close: two pairs of directions
/// n, m have (n.m)^4 in common in the 15 equations, and (n.m)^2 (n.m) in the forces on a corner that they
/// share.
struct Quadratic {
  PairMatrix matrix;
  PairVector slope;
};

Quadratic misfit(const CornerPositions& corners, const PairGeometry& geometry, const PairStiffness& start,
                 double volume, const Weights& weight) {
  std::array<Vec3, 8> pull = volumeGradient(corners);
  Vec3 alternating = Vec3::Zero();
  for (unsigned c = 0; c < 8; ++c) alternating += parity(c) * pull[c] / 8.0;
  for (unsigned c = 0; c < 8; ++c) pull[c] -= parity(c) * alternating;

  const double area = std::cbrt(volume) * std::cbrt(volume);
  PairVector modulus;
  PairVector force;
  Quadratic quadratic;
  for (std::size_t p = 0; p < kPairsPerCell; ++p) {
    const auto i = Eigen::Index(p);
    modulus[i] = std::sqrt(weight.modulus) * start[p] * geometry.length[p] * geometry.length[p] / volume;
    force[i] = std::sqrt(weight.patch) * start[p] * geometry.length[p] / area;
    const double across = geometry.direction[p].dot(pull[kCornerPairs[p].b] - pull[kCornerPairs[p].a]) / area;
    quadratic.slope[i] = 1.0 + 3.0 * kLame * std::sqrt(weight.modulus) * modulus[i] +
                         3.0 * kLame * std::sqrt(weight.patch) * force[i] * across;
  }
  const PairMatrix& shared = sharedCornersOfAll();
  for (Eigen::Index j = 0; j < Eigen::Index(kPairsPerCell); ++j)
    for (Eigen::Index i = j; i < Eigen::Index(kPairsPerCell); ++i) {
      const double cosine = geometry.direction[std::size_t(i)].dot(geometry.direction[std::size_t(j)]);
      const double cube = cosine * cosine * cosine;
      const double value =
          modulus[i] * modulus[j] * cube * cosine + force[i] * force[j] * cube * shared(i, j);
      quadratic.matrix(i, j) = quadratic.matrix(j, i) = value + (i == j ? 1.0 : 0.0);
    }
  return quadratic;
}

/// Least value over the pairs in `free`, the others as they stand in `shares`.
void minimise(const Quadratic& quadratic, const std::vector<Eigen::Index>& free, PairVector& shares) {
  PairVector held = shares;
  for (const Eigen::Index p : free) held[p] = 0.0;
  const PairVector slope = quadratic.slope - quadratic.matrix * held;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kPairsPerCell, kPairsPerCell>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kPairsPerCell, 1>;
  const auto count = Eigen::Index(free.size());
  Matrix matrix(count, count);
  Vector right(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    right[i] = slope[free[std::size_t(i)]];
    for (Eigen::Index j = 0; j < count; ++j)
      matrix(i, j) = quadratic.matrix(free[std::size_t(i)], free[std::size_t(j)]);
  }
  const Vector solution = matrix.llt().solve(right);
  for (Eigen::Index i = 0; i < count; ++i) shares[free[std::size_t(i)]] = solution[i];
}

/// Pairs that would fall below the smallest share are held there and the others fitted again. A held pair is
/// not let go any more: at most a few a cell are held, and the gain would not be seen.
void minimiseAboveSmallestShare(const Quadratic& quadratic, std::vector<Eigen::Index> free,
                                PairVector& shares) {
  for (bool again = true; again && !free.empty();) {
    minimise(quadratic, free, shares);
    again = false;
    std::vector<Eigen::Index> stillFree;
    for (const Eigen::Index p : free) {
      if (shares[p] >= kSmallestShare) {
        stillFree.push_back(p);
      } else {
        shares[p] = kSmallestShare;
        again = true;
      }
    }
    free = std::move(stillFree);
  }
}

/// Full contraction of the 15 equations: sum k L^2 = 6 E V.
double averageModulus(const PairStiffness& stiffness, const PairGeometry& geometry, double volume) {
  double sum = 0.0;
  for (std::size_t p = 0; p < kPairsPerCell; ++p)
    sum += stiffness[p] * geometry.length[p] * geometry.length[p];
  return sum / (15.0 * kLame * volume);
}

PairStiffness startStiffness(const PairGeometry& geometry, double volume, BondPattern pattern, bool odd) {
  const std::array<double, 3> kappa = latticeStiffness(pattern);
  constexpr std::array<double, 3> kShare{0.25, 0.5, 1.0};
  const double size = std::cbrt(volume);
  const std::uint32_t bonds = patternPairs(pattern, odd);
  PairStiffness start{};
  for (std::size_t p = 0; p < kPairsPerCell; ++p) {
    if (!(bonds >> p & 1U)) continue;
    const auto kind = static_cast<std::size_t>(kCornerPairs[p].kind);
    const double squared = double(kind + 1) * size * size / (geometry.length[p] * geometry.length[p]);
    start[p] = kShare[kind] * kappa[kind] * size * squared;
  }
  return start;
}

}  // namespace

constinit const std::array<CornerPair, kPairsPerCell> kCornerPairs = makeCornerPairs();

std::uint32_t patternPairs(BondPattern pattern, bool odd) {
  std::uint32_t pairs = 0;
  for (std::size_t p = 0; p < kPairsPerCell; ++p) {
    bool bonded = kCornerPairs[p].kind == PairKind::edge;
    if (kCornerPairs[p].kind == PairKind::bodyDiagonal)
      bonded = pattern == BondPattern::full || pattern == BondPattern::fig1;
    if (kCornerPairs[p].kind == PairKind::faceDiagonal)
      bonded = pattern == BondPattern::full || pattern == BondPattern::faces ||
               (pattern == BondPattern::fig2 && (parity(kCornerPairs[p].a) < 0.0) == odd);
    if (bonded) pairs |= 1U << p;
  }
  return pairs;
}

PairStiffness startStiffness(const CornerPositions& corners, BondPattern pattern, bool odd) {
  return startStiffness(pairGeometry(corners), cellVolume(corners), pattern, odd);
}

PairStiffness fitCell(const CornerPositions& corners, BondPattern pattern, bool odd) {
  const double volume = cellVolume(corners);
  assert(volume > 0.0);
  const PairGeometry geometry = pairGeometry(corners);
  const PairStiffness start = startStiffness(geometry, volume, pattern, odd);
  const Quadratic quadratic = misfit(corners, geometry, start, volume, weights(pattern));

  std::vector<Eigen::Index> free;
  PairVector shares = PairVector::Zero();
  for (std::size_t p = 0; p < kPairsPerCell; ++p)
    if (start[p] > 0.0) free.push_back(Eigen::Index(p));
  minimiseAboveSmallestShare(quadratic, std::move(free), shares);

  PairStiffness stiffness{};
  for (std::size_t p = 0; p < kPairsPerCell; ++p) stiffness[p] = start[p] * shares[Eigen::Index(p)];
  if (pattern == BondPattern::full) return stiffness;
  const double scale = 1.0 / averageModulus(stiffness, geometry, volume);
  for (double& value : stiffness) value *= scale;
  return stiffness;
}

BondFit fitBonds(const std::vector<Vec3>& nodes, const std::vector<sim::CellCorners>& cells,
                 BondPattern pattern) {
  const std::vector<std::uint8_t> odd = pattern == BondPattern::fig2
                                            ? checkerboard(cells, nodes.size())
                                            : std::vector<std::uint8_t>(cells.size(), 0);
  Congruence congruence = congruentCells(nodes, cells, odd);
  BondFit fit;
  fit.shapes.resize(congruence.representatives.size());
  fit.shapeOfCell = std::move(congruence.classOfCell);
  sim::parallelFor(fit.shapes.size(), [&](std::size_t shape) {
    const sim::CellIndex cell = congruence.representatives[shape];
    const CornerPositions corners = cornerPositions(nodes, cells[cell]);
    fit.shapes[shape].volume = cellVolume(corners);
    if (fit.shapes[shape].volume > 0.0)
      fit.shapes[shape].stiffness = fitCell(corners, pattern, odd[cell] != 0);
  });
  return fit;
}

}  // namespace modeling
