#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "modeling/shapes/disc.h"
#include "modeling/shapes/lattice.h"

namespace modeling {

/// A surface divided into quadrilaterals, in its own coordinates, from which a lattice is made by stacking
/// layers.
struct Sheet {
  std::vector<Vec2> points;
  std::vector<std::array<std::uint32_t, 4>>
      quads;                        ///< corners (0,0), (1,0), (0,1), (1,1); all turn the same way
  std::vector<std::uint32_t> rows;  ///< first node of each row of consecutive nodes, ascending
};

/// How the layers of a stack are interleaved with the sheet's nodes.
enum class LayerOrder {
  innermost,    ///< a node's layers are consecutive: for stacks higher than the sheet is wide
  betweenRows,  ///< row by row, each row's layers after each other: for few layers
};

/// Index of a sheet's node in a layer of the stack.
class StackNumbering {
 public:
  StackNumbering(const Sheet& sheet, int cellLayers, LayerOrder order);
  sim::NodeIndex node(std::uint32_t sheetNode, int layer) const;
  std::size_t nodeCount() const { return rowOf_.size() * nodeLayers_; }

 private:
  std::size_t nodeLayers_;
  LayerOrder order_;
  std::vector<std::uint32_t> rowOf_, rowStart_, rowSize_;
};

struct PlacedNode {
  Vec3 position, parameters;
};

/// The stack of `cellLayers` layers of cells; place(point of the sheet, node layer) says where a node goes.
/// Not yet completed().
Lattice stack(const Sheet& sheet, int cellLayers, LayerOrder order,
              const std::function<PlacedNode(const Vec2& point, int layer)>& place);

/// A surface that turns about an axis: discs where it meets the axis, and rows around between them. A point
/// of it is (share of the turn, distance along).
struct TurnedLayout {
  DiscLayout startDisc, endDisc;  ///< the same but for their rings; read only where that end is closed
  bool startClosed = false, endClosed = false;
  double startLength = 0.0;  ///< along, from the axis to the edge of the first disc; 0 where open
  double endLength = 0.0;    ///< along, from the edge of the last disc to the axis; 0 where open
  double length = 0.0;       ///< along, from end to end
  int rowsBetween = 0;       ///< cells along between the discs; 0: they meet, or one disc is all there is
};

struct TurnedSheet {
  Sheet sheet;
  /// For each node its counterpart in a solid core of the same layout, which is a stack of discs: the node of
  /// the disc and the disc's place in the stack (0: the first).
  std::vector<std::uint32_t> discNode;
  std::vector<int> discLayer;
};

/// At least one end is closed (otherwise it would be a regular grid).
TurnedSheet turnedSheet(const TurnedLayout& layout);

}  // namespace modeling
