#include "sim/methods/spectrum.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "sim/base/random.h"
#include "sim/network/wedge.h"

namespace sim {
namespace {

/// Power iteration converges from below; this covers what twenty steps miss (measured: 2 to 3 %).
constexpr double kPowerMargin = 1.03;
constexpr int kPowerSteps = 20;
/// Power of a node's bound with which the iteration starts: a spot half again as stiff stands out 25 times.
constexpr double kLeaning = 8.0;
/// Different cells whose eigenvalues are computed before the rest is bounded by row sums alone.
constexpr std::size_t kMostCells = 400;

double inverseMass(const Network& network, NodeIndex node) {
  return 1.0 / network.masses[node];
}

/// Gershgorin's bounds of the eigenvalues of M^-1/2 K M^-1/2, node by node.
std::vector<double> nodeBounds(const Network& network) {
  std::vector<double> rowSum(network.nodeCount(), 0.0);
  for (NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
      const NodeIndex other = network.bondEnds[b];
      const double stiffness = network.bond(b).stiffness;
      const double cross = stiffness * std::sqrt(inverseMass(network, a) * inverseMass(network, other));
      rowSum[a] += stiffness * inverseMass(network, a) + cross;
      rowSum[other] += stiffness * inverseMass(network, other) + cross;
    }
  }
  return rowSum;
}

/// Splits stiffness of bonds and mass of nodes evenly among the cells that hold them: the largest eigenvalue
/// of any cell by itself bounds those of the whole.
class CellBound {
 public:
  explicit CellBound(const Network& network)
      : network_(network), cellsOfNode_(network.nodeCount(), 0), cellsOfBond_(network.bondCount(), 0) {
    for (const CellCorners& corners : network.cells) {
      for (const NodeIndex corner : DistinctCorners(corners)) ++cellsOfNode_[corner];
      forEachBond(DistinctCorners(corners),
                  [&](std::size_t, std::size_t, BondIndex bond) { ++cellsOfBond_[bond]; });
    }
  }

  /// Bonds outside all cells are not covered: then the node bound must serve.
  bool coversAll() const {
    return std::none_of(cellsOfBond_.begin(), cellsOfBond_.end(),
                        [](std::uint16_t cells) { return cells == 0; });
  }

  double bound() const {
    struct Ranked {
      double rowSum;
      CellIndex cell;
    };
    std::vector<Ranked> ranked;
    ranked.reserve(network_.cellCount());
    for (CellIndex cell = 0; cell < network_.cellCount(); ++cell) ranked.push_back({rowBound(cell), cell});
    std::sort(ranked.begin(), ranked.end(), [](const Ranked& left, const Ranked& right) {
      return std::pair(-left.rowSum, left.cell) < std::pair(-right.rowSum, right.cell);
    });
    double largest = 0.0;
    double previous = -1.0;
    std::size_t solved = 0;
    for (const Ranked& candidate : ranked) {
      if (candidate.rowSum <= largest) break;
      // Congruent cells have equal row sums.
      if (std::abs(candidate.rowSum - previous) <= 1e-9 * candidate.rowSum) continue;
      previous = candidate.rowSum;
      if (++solved > kMostCells) return candidate.rowSum;
      largest = std::max(largest, largestEigenvalue(candidate.cell));
    }
    return largest;
  }

 private:
  template <class Visit>
  void forEachBond(const DistinctCorners& corners, Visit&& visit) const {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        const BondIndex bond = network_.findBond(corners[i], corners[j]);
        if (bond != kNone) visit(i, j, bond);
      }
    }
  }

  double share(BondIndex bond) const { return network_.bond(bond).stiffness / cellsOfBond_[bond]; }
  double inverseShare(NodeIndex node) const { return inverseMass(network_, node) * cellsOfNode_[node]; }

  double rowBound(CellIndex cell) const {
    const DistinctCorners corners(network_.cells[cell]);
    std::array<double, 8> rowSum{};
    forEachBond(corners, [&](std::size_t i, std::size_t j, BondIndex bond) {
      const double first = inverseShare(corners[i]);
      const double second = inverseShare(corners[j]);
      rowSum[i] += share(bond) * (first + std::sqrt(first * second));
      rowSum[j] += share(bond) * (second + std::sqrt(first * second));
    });
    return *std::max_element(rowSum.begin(), rowSum.end());
  }

  double largestEigenvalue(CellIndex cell) const {
    const DistinctCorners corners(network_.cells[cell]);
    Eigen::Matrix<double, 24, 24> matrix = Eigen::Matrix<double, 24, 24>::Zero();
    forEachBond(corners, [&](std::size_t i, std::size_t j, BondIndex bond) {
      const Vec3 along = (network_.positions[corners[j]] - network_.positions[corners[i]]).normalized();
      const Eigen::Matrix3d block = share(bond) * along * along.transpose();
      const double first = std::sqrt(inverseShare(corners[i]));
      const double second = std::sqrt(inverseShare(corners[j]));
      const auto row = static_cast<Eigen::Index>(3 * i);
      const auto column = static_cast<Eigen::Index>(3 * j);
      matrix.block<3, 3>(row, row) += first * first * block;
      matrix.block<3, 3>(column, column) += second * second * block;
      matrix.block<3, 3>(row, column) -= first * second * block;
      matrix.block<3, 3>(column, row) -= first * second * block;
    });
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 24, 24>> solver(matrix, Eigen::EigenvaluesOnly);
    return solver.eigenvalues().maxCoeff();
  }

  const Network& network_;
  std::vector<std::uint16_t> cellsOfNode_;
  std::vector<std::uint16_t> cellsOfBond_;
};

/// Largest eigenvalue of M^-1/2 K M^-1/2 of the network where it stands, from below. The start leans towards
/// the nodes of high bounds: a stiff spot in a large network would be lost in a start that is random
/// everywhere.
double powerEstimate(const Network& network, const std::vector<double>& bounds) {
  const std::size_t count = network.nodeCount();
  std::vector<Vec3> vector(count);
  std::vector<Vec3> image(count);
  const double highest = *std::max_element(bounds.begin(), bounds.end());
  for (std::size_t n = 0; n < count; ++n) {
    const double weight = std::pow(bounds[n] / highest, kLeaning);
    for (std::size_t k = 0; k < 3; ++k)
      vector[n][static_cast<Eigen::Index>(k)] = weight * (uniformAt(1, 3 * n + k) - 0.5);
  }
  double eigenvalue = 0.0;
  for (int step = 0; step < kPowerSteps; ++step) {
    std::fill(image.begin(), image.end(), Vec3::Zero());
    for (NodeIndex a = 0; a < count; ++a) {
      const double first = std::sqrt(inverseMass(network, a));
      for (BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
        const NodeIndex other = network.bondEnds[b];
        const double second = std::sqrt(inverseMass(network, other));
        const Vec3 along = (network.positions[other] - network.positions[a]).normalized();
        const double pull = network.bond(b).stiffness * along.dot(second * vector[other] - first * vector[a]);
        image[a] -= first * pull * along;
        image[other] += second * pull * along;
      }
    }
    double norm = 0.0;
    double product = 0.0;
    double squared = 0.0;
    for (std::size_t n = 0; n < count; ++n) {
      norm += image[n].squaredNorm();
      product += image[n].dot(vector[n]);
      squared += vector[n].squaredNorm();
    }
    if (!(norm > 0.0)) return 0.0;
    eigenvalue = product / squared;
    norm = std::sqrt(norm);
    for (std::size_t n = 0; n < count; ++n) vector[n] = image[n] / norm;
  }
  return eigenvalue;
}

}  // namespace

Spectrum measureSpectrum(const Network& network) {
  Spectrum spectrum;
  if (network.bondCount() == 0) return spectrum;
  const std::vector<double> bounds = nodeBounds(network);
  double bound = *std::max_element(bounds.begin(), bounds.end());
  if (network.cellCount() > 0) {
    const CellBound cells(network);
    if (cells.coversAll()) bound = std::min(bound, cells.bound());
  }
  const double power = std::sqrt(powerEstimate(network, bounds)) * kPowerMargin;
  spectrum.highestFrequency = power > 0.0 ? std::min(std::sqrt(bound), power) : std::sqrt(bound);
  spectrum.shortestDamping = std::numeric_limits<double>::max();
  for (const BondClass& bond : network.classes) {
    spectrum.longestDamping = std::max(spectrum.longestDamping, bond.damping / bond.stiffness);
    spectrum.shortestDamping = std::min(spectrum.shortestDamping, bond.damping / bond.stiffness);
  }
  return spectrum;
}

double totalFrequency(const Spectrum& spectrum, const Stiffening& stiffening) {
  const double internal = spectrum.highestFrequency * spectrum.highestFrequency;
  return std::sqrt(internal * stiffening.stiffnessScale + stiffening.contactRateSquared);
}

double dampingRatio(const Spectrum& spectrum, const Stiffening& stiffening) {
  const double internal = spectrum.highestFrequency * spectrum.highestFrequency;
  const double rate =
      spectrum.longestDamping * stiffening.dampingScale * internal + stiffening.contactDamping;
  return rate / (2.0 * totalFrequency(spectrum, stiffening));
}

double shortestDamping(const Spectrum& spectrum, const Stiffening& stiffening) {
  return spectrum.shortestDamping * stiffening.dampingScale / stiffening.stiffnessScale;
}

}  // namespace sim
