#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/result.h"
#include "sim/network/network.h"

namespace modeling {

using sim::NodeIndex;
using sim::Vec3;

/// Least scaled Jacobian that gluing may leave a cell with: a corner bent in so far is not to be seen, and
/// what the cell's bonds do does not hang on its shape (GlueResult::misshapen).
inline constexpr double kBentIn = -0.1;

/// Gluing as the paper defines it (section "Geometric modeling"): shape A is glued to shape B by choosing
/// nodes a_i of A, pairing each with the nearest node b_i of B, and putting b_i in a_i's place in every bond
/// ("glue bonds"). A bond between two chosen nodes would repeat what B has: its constants are zero. The a_i
/// are then dropped.
///
/// Deviations, where nodes are chosen by reach: of two a-nodes with the same nearest b-node the farther takes
/// the nearest that is free, in reach, and at most half as far again, since two corners in one node flatten a
/// cell; where that would twist a cell, it goes back to its nearest; and where a cell would be twisted even
/// so, its farthest corner is let go and not glued. A corner may become flat, where three nodes of B are in
/// line, or bent in a little. A reach of about half the cell size is usual; a much larger one chooses inner
/// layers that are then let go.

/// One part as gluing sees it.
struct GluePart {
  std::string name;
  std::vector<Vec3> nodes;  ///< world coordinates, cm
  std::vector<sim::CellCorners> cells;
  std::vector<std::array<NodeIndex, 2>> looseBonds;  ///< bonds of no cell (a raw network's)
};

struct GluePair {
  NodeIndex a = 0;
  NodeIndex b = 0;
  double distance = 0.0;  ///< cm; filled in by previewGlue()
};

/// One gluing: part a is glued to part b.
struct GlueSettings {
  std::size_t a = 0;
  std::size_t b = 0;
  double reach = 0.0;                    ///< cm, > 0: nodes of A this near to a node of B are glued
  std::vector<GluePair> explicitPairs;   ///< where not empty, exactly these are glued, whatever the reach
  std::vector<NodeIndex> excludedNodes;  ///< nodes of A that stay free
};

/// What would be glued, in order of a.
struct GluePreview {
  std::vector<GluePair> pairs;
  double worstDistance = 0.0;     ///< cm
  std::size_t nodesReleased = 0;  ///< in reach, but let go because a cell would have been twisted
};

/// What one gluing did.
struct GlueReport {
  std::string a;
  std::string b;
  std::size_t nodesMerged = 0;
  std::size_t bondsZeroed =
      0;  ///< of the pairs of corners of A's cells (28 a cell) and A's loose bonds, both ends glued here
  std::size_t bondsDuplicate = 0;  ///< of the others: how many fell on a pair that already had one
  std::size_t cellsDropped = 0;    ///< of A: see GlueResult::droppedCells
  std::size_t wedges = 0;          ///< of A: cells of which corners have become one node, and not dropped
  std::size_t bent = 0;            ///< of A: other misshapen cells, see GlueResult::misshapen
  double worstDistance = 0.0;      ///< cm, between an a-node and its b-node
  std::size_t nodesTaken =
      0;  ///< in reach, but dropped already by an earlier gluing, and so left as they are
  std::size_t nodesReleased = 0;          ///< in reach, but let go because a cell would have been twisted
  double worstScaledJacobian = 1.0;       ///< of A's cells with a glued corner, misshapen ones left out
  sim::CellIndex worstCell = sim::kNone;  ///< of A, where there is one
};

/// All parts as one list of nodes. The order of parts, and of nodes within a part, is kept.
struct GlueResult {
  std::vector<std::vector<NodeIndex>>
      globalNode;  ///< [part][local]: in the merged list; an a-node's is its b-node's
  std::size_t nodeCount = 0;
  std::vector<GlueReport> reports;  ///< one a gluing
  std::vector<std::vector<std::uint32_t>>
      gluedBy;  ///< [part][local]: the gluing that dropped this node, or kNone
  /// [part]: cells, ascending, that stand for no volume of their own any more: all eight corners were glued
  /// in one gluing (all their bonds are zero), or so many have become one node that it is flat or folded.
  std::vector<std::vector<sim::CellIndex>> droppedCells;
  /// [part]: cells, ascending, whose shape is no measure of their bonds any more: those are as stiff as
  /// before gluing. Wedges, of which neighbouring corners have become one node (sim/network/wedge.h), and
  /// cells with a corner that is flat or bent in.
  std::vector<std::vector<sim::CellIndex>> misshapen;
};

/// The pairs of one gluing. Problem: reach not positive or not finite, a part with itself, a pair out of
/// range or twice, no node in reach (with the distance that would do).
sim::Result<GluePreview> previewGlue(const GluePart& a, const GluePart& b, const GlueSettings& settings);

/// Glues one after the other, in the order given; a node that one gluing dropped is gone for the next, and A
/// glued to B glued to C ends at C's node. Problem, beside previewGlue()'s: an unknown part; two gluings of
/// the same two parts; an explicit pair whose a-node an earlier gluing dropped onto another node; a cell
/// turned inside out.
sim::Result<GlueResult> glue(const std::vector<GluePart>& parts, const std::vector<GlueSettings>& glues);

}  // namespace modeling
