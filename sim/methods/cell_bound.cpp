#include "sim/methods/cell_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

#include "sim/network/wedge.h"

namespace sim {
namespace {

/// Different cells whose eigenvalues are computed before the rest is bounded by row sums alone.
constexpr std::size_t kMostCells = 400;

double inverseMass(const Network& network, NodeIndex node) {
  return 1.0 / network.masses[node];
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

}  // namespace

std::optional<double> largestOfCells(const Network& network) {
  const CellBound cells(network);
  if (!cells.coversAll()) return std::nullopt;
  return cells.bound();
}

}  // namespace sim
