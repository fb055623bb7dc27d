#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "modeling/material/material.h"
#include "modeling/shapes/quality.h"

/// Bond stiffness that makes each cell, however distorted, as stiff as its volume of the continuum
/// (docs/numerics.md, "Bonds of distorted cells").
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

/// Which pairs carry a bond, one bit a pair. `odd` tells the cells of a checkerboard apart
/// (checkerboard.h): Fig. 2 joins the
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

/// The fit for one cell of positive volume: of all stiffnesses that are at least kSmallestShare of the start
/// value, those with the least weighted sum of three squares:
/// - the relative changes from the start values;
/// - the misfit of the 15 equations sum k L^2 n n n n = 0.4 E V (dd + dd + dd), which say that the cell as a
///   whole has the elastic constants of the continuum;
/// - the misfit of the forces on the corners under uniform strain, which should be those of a body under
///   uniform stress (the patch test of finite elements). The one motion of the corners that alternates from
///   each to the next is left out: there a regular cell is out of balance, too, and its neighbours cancel it.
///
/// Patterns of fewer than 28 bonds can't satisfy the equations in a distorted cell. They get smaller weights
/// and a last scaling of all bonds (which may pass kSmallestShare a little) such that E is right on average
/// over all directions.
PairStiffness fitCell(const CornerPositions& corners, BondPattern pattern, bool odd);
inline constexpr double kSmallestShare = 0.05;

struct CellShape {
  PairStiffness stiffness{};  ///< cm
  double volume = 0.0;        ///< cm^3
};

struct BondFit {
  std::vector<CellShape> shapes;
  std::vector<std::uint32_t> shapeOfCell;

  const CellShape& ofCell(std::size_t cell) const { return shapes[shapeOfCell[cell]]; }
};

/// Fits every cell; one that is inside out gets no stiffness. Congruent cells (congruence.h) share one shape
/// and so the same bits. Runs on all threads; the result doesn't depend on how many.
BondFit fitBonds(const std::vector<Vec3>& nodes, const std::vector<sim::CellCorners>& cells,
                 BondPattern pattern);

}  // namespace modeling
