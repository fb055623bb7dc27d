#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "modeling/material/material.h"
#include "modeling/shapes/lattice.h"

/// Bond stiffness that makes each cell, however distorted, as stiff as its volume of the continuum (B6;
/// docs/numerics.md).
namespace modeling {

inline constexpr std::size_t kPairsPerCell = 28;

enum class PairKind : std::uint8_t { edge, faceDiagonal, bodyDiagonal };

/// Two corners of a cell, a < b.
struct CornerPair {
  std::uint8_t a = 0;
  std::uint8_t b = 0;
  PairKind kind = PairKind::edge;
};

/// All pairs of corners, by a, then b.
extern const std::array<CornerPair, kPairsPerCell> kCornerPairs;

using CornerPositions = std::array<Vec3, 8>;

CornerPositions cornerPositions(const std::vector<Vec3>& nodes, const sim::CellCorners& cell);

/// Exact volume of the trilinear hexahedron, cm^3; negative where it is turned inside out.
double cellVolume(const CornerPositions& corners);

/// Which pairs carry a bond, one bit a pair. `odd` tells the cells of a checkerboard apart: Fig. 2 joins the
/// corners of even parity in one half of them and the others in the other half, so that cells that share a
/// face have the same diagonal on it. The other patterns don't care.
std::uint32_t patternPairs(BondPattern pattern, bool odd);

/// Stiffness that a cell contributes to each of its pairs, per unit of Young's modulus: cm. 0 where there is
/// no bond. Bonds shared by cells have the sum of what the cells contribute.
using PairStiffness = std::array<double, kPairsPerCell>;

/// Start values: share * kappa * h (L0 h / L)^2 with h = V^(1/3), L the pair's length, L0 = 1, sqrt 2, sqrt 3
/// and the shares 1/4, 1/2, 1 by kind, kappa by pattern such that a lattice of cubes is isotropic and has the
/// right E.
PairStiffness startStiffness(const CornerPositions& corners, BondPattern pattern, bool odd);

/// The fit for one cell of positive volume. At least kSmallestShare of the start value everywhere.
PairStiffness fitCell(const CornerPositions& corners, BondPattern pattern, bool odd);
inline constexpr double kSmallestShare = 0.05;

/// Congruent cells (all 28 lengths equal to kCongruence of the cell's size) share one shape, so that they get
/// the same bits: those of the first of them.
inline constexpr double kCongruence = 1e-9;

struct BondFit {
  std::vector<PairStiffness> shapes;
  std::vector<std::uint32_t> shapeOfCell;

  const PairStiffness& ofCell(std::size_t cell) const { return shapes[shapeOfCell[cell]]; }
};

/// Fits every cell. `odd` has one entry a cell (checkerboard()), or is empty where the pattern doesn't care.
/// Cells must have positive volume. Runs on all threads; the result doesn't depend on how many.
BondFit fitBonds(const std::vector<CornerPositions>& cells, BondPattern pattern,
                 const std::vector<std::uint8_t>& odd);

/// Two-colours the nodes along the cells' edges and tells for each cell whether its corner 0 is of the second
/// colour. Where a ring of an odd number of cells allows no two-colouring, the cells along one seam disagree
/// with their neighbours and the seam's faces get both diagonals.
std::vector<std::uint8_t> checkerboard(const std::vector<sim::CellCorners>& cells, std::size_t nodeCount);

}  // namespace modeling
