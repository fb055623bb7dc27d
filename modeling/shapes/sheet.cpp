#include "modeling/shapes/sheet.h"

#include <algorithm>
#include <cassert>

namespace modeling {

StackNumbering::StackNumbering(const Sheet& sheet, int cellLayers, LayerOrder order)
    : nodeLayers_(static_cast<std::size_t>(cellLayers) + 1), order_(order) {
  rowOf_.resize(sheet.points.size());
  for (std::size_t row = 0; row < sheet.rows.size(); ++row) {
    const auto end =
        row + 1 < sheet.rows.size() ? sheet.rows[row + 1] : static_cast<std::uint32_t>(sheet.points.size());
    rowStart_.push_back(sheet.rows[row]);
    rowSize_.push_back(end - sheet.rows[row]);
    for (std::uint32_t node = sheet.rows[row]; node < end; ++node)
      rowOf_[node] = static_cast<std::uint32_t>(row);
  }
}

sim::NodeIndex StackNumbering::node(std::uint32_t sheetNode, int layer) const {
  const auto at = static_cast<std::size_t>(layer);
  if (order_ == LayerOrder::innermost) return static_cast<sim::NodeIndex>(sheetNode * nodeLayers_ + at);
  const std::uint32_t row = rowOf_[sheetNode];
  return static_cast<sim::NodeIndex>(rowStart_[row] * nodeLayers_ + at * rowSize_[row] +
                                     (sheetNode - rowStart_[row]));
}

Lattice stack(const Sheet& sheet, int cellLayers, LayerOrder order,
              const std::function<PlacedNode(const Vec2& point, int layer)>& place) {
  const StackNumbering numbering(sheet, cellLayers, order);
  Lattice lattice;
  lattice.nodes.resize(numbering.nodeCount());
  lattice.parameters.resize(numbering.nodeCount());
  for (std::uint32_t point = 0; point < sheet.points.size(); ++point)
    for (int layer = 0; layer <= cellLayers; ++layer) {
      const PlacedNode placed = place(sheet.points[point], layer);
      const sim::NodeIndex node = numbering.node(point, layer);
      lattice.nodes[node] = placed.position;
      lattice.parameters[node] = placed.parameters;
    }
  lattice.cells.reserve(sheet.quads.size() * static_cast<std::size_t>(cellLayers));
  for (const auto& quad : sheet.quads)
    for (int layer = 0; layer < cellLayers; ++layer) {
      sim::CellCorners cell;
      for (std::size_t corner = 0; corner < 8; ++corner)
        cell[corner] = numbering.node(quad[corner % 4], layer + static_cast<int>(corner / 4));
      lattice.cells.push_back(cell);
    }
  return lattice;
}

namespace {

class TurnedSheetBuilder {
 public:
  explicit TurnedSheetBuilder(const TurnedLayout& layout) : layout_(layout) {
    assert(layout.startClosed || layout.endClosed);
    const DiscLayout& disc = layout.startClosed ? layout.startDisc : layout.endDisc;
    around_ = disc.cellsAround();
    nodesAround_ = static_cast<std::uint32_t>(disc.nodesAround());
    circle_ = static_cast<std::uint32_t>(discNodes(disc)) - nodesAround_;
  }

  TurnedSheet run() {
    if (layout_.startClosed)
      addStartDisc();
    else
      addRow(0.0, circle_, 0);
    const double between = layout_.length - layout_.startLength - layout_.endLength;
    for (int row = 1; row <= layout_.rowsBetween; ++row) {
      const std::uint32_t before = lastRow();
      addRow(std::min(layout_.startLength + between * row / layout_.rowsBetween, layout_.length), circle_,
             row);
      connect(before, lastRow());
    }
    if (layout_.endClosed) addEndDisc();
    return std::move(result_);
  }

 private:
  static std::size_t discNodes(const DiscLayout& disc) {
    return static_cast<std::size_t>(discNodeCount(disc));
  }
  std::uint32_t count() const { return static_cast<std::uint32_t>(result_.sheet.points.size()); }
  std::uint32_t lastRow() const { return count() - nodesAround_; }

  void addNode(const Vec2& point, std::uint32_t discNode, int discLayer) {
    result_.sheet.points.push_back(point);
    result_.discNode.push_back(discNode);
    result_.discLayer.push_back(discLayer);
  }
  void addRow(double along, std::uint32_t firstDiscNode, int discLayer) {
    result_.sheet.rows.push_back(count());
    for (std::uint32_t i = 0; i < nodesAround_; ++i)
      addNode({static_cast<double>(i) / around_, along}, firstDiscNode + i, discLayer);
  }
  void connect(std::uint32_t before, std::uint32_t after) {
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(around_); ++i) {
      const std::uint32_t next = (i + 1) % nodesAround_;
      result_.sheet.quads.push_back({before + i, before + next, after + i, after + next});
    }
  }
  void addStartDisc() {
    const Disc disc = divideDisc(layout_.startDisc);
    result_.sheet.rows = disc.rows;
    result_.sheet.quads = disc.quads;
    for (std::uint32_t node = 0; node < disc.points.size(); ++node)
      addNode({disc.points[node][1], disc.points[node][0] * layout_.startLength}, node, 0);
  }
  /// The last disc runs from its circle, which is there already, inwards.
  void addEndDisc() {
    const Disc disc = divideDisc(layout_.endDisc);
    std::vector<std::uint32_t> sheetNode(disc.points.size());
    const auto addDiscRow = [&](std::uint32_t start, std::uint32_t end) {
      result_.sheet.rows.push_back(count());
      for (std::uint32_t node = start; node < end; ++node) {
        sheetNode[node] = count();
        addNode({disc.points[node][1], layout_.length - disc.points[node][0] * layout_.endLength}, node,
                layout_.rowsBetween);
      }
    };
    const auto circle = static_cast<std::uint32_t>(disc.ringStart(disc.layout.rings - 1));
    const std::uint32_t present = lastRow();
    for (std::uint32_t i = 0; i < nodesAround_; ++i) sheetNode[circle + i] = present + i;
    for (std::size_t row = disc.rows.size() - 1; row-- > 0;)
      if (disc.rows[row] >= disc.coreNodes) addDiscRow(disc.rows[row], disc.rows[row] + nodesAround_);
    for (std::size_t row = 0; row < disc.rows.size() && disc.rows[row] < disc.coreNodes; ++row)
      addDiscRow(disc.rows[row], disc.rows[row + 1]);
    for (const auto& quad : disc.quads)
      result_.sheet.quads.push_back(
          {sheetNode[quad[2]], sheetNode[quad[3]], sheetNode[quad[0]], sheetNode[quad[1]]});
  }

  TurnedLayout layout_;
  int around_ = 0;
  std::uint32_t nodesAround_ = 0, circle_ = 0;
  TurnedSheet result_;
};

}  // namespace

TurnedSheet turnedSheet(const TurnedLayout& layout) {
  return TurnedSheetBuilder(layout).run();
}

}  // namespace modeling
