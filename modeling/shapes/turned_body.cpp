#include "modeling/shapes/turned_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "modeling/shapes/cell_counts.h"
#include "modeling/shapes/turned_plan.h"

namespace modeling {
namespace {

/// How deep the axis of a body's core may begin below a closed end, as a share of the height over an open
/// one. A dome would like it at its centre (1), a knob on a neck near its top (0.5): tried from 0.33 to 1,
/// this spoils neither.
constexpr double kDeepest = 0.62;

/// Where the nodes of a solid body go, in the half-plane (r, z).
class BodyMap {
 public:
  BodyMap(const WallProfile& profile, const TurnedLayout& layout, int wrappingLayers)
      : profile_(profile), layout_(layout) {
    const int radial = layout.startDisc.core + layout.startDisc.rings;
    coreShare_ = static_cast<double>(radial) / (radial + wrappingLayers);
    const WallProfile::Pair first = profile.pairAt(0.0), last = profile.pairAt(profile.length());
    const double start = layout.startClosed ? first.outside.y() : first.inside.y();
    const double end = layout.endClosed ? last.outside.y() : last.inside.y();
    // The wrapping is as thick at a pole as it is at the bend where the side begins: sqrt 2 times the radius
    // there is the distance of a ball's pole from its centre.
    const double most = std::abs(end - start) * (layout.startClosed && layout.endClosed ? 0.5 : kDeepest);
    const auto inset = [&](bool closed, double bend) {
      return closed ? std::copysign(std::min(std::numbers::sqrt2 * profile.radiusAt(bend), most), end - start)
                    : 0.0;
    };
    axisStart_ = start + inset(layout.startClosed, layout.startLength);
    axisEnd_ = end - inset(layout.endClosed, layout.length - layout.endLength);
  }

  /// The wrapping: from the core's surface (outward 0) to the body's (1).
  Vec2 wrapping(double along, double outward) const {
    const Vec2 axis = axisAt(along), surface = profile_.pairAt(along).outside;
    const double core = coreShare_ + (1.0 - coreShare_) * kEdgeShare * edge(along);
    return axis + (core + (1.0 - core) * outward) * (surface - axis);
  }

  /// The core: Coons' patch between the axis, its side and its two end discs.
  Vec2 core(double radius, double up) const {
    const double side = layout_.startLength + up * (layout_.length - layout_.startLength - layout_.endLength);
    const Vec2 sidePoint = wrapping(side, 0.0);
    const Vec2 startAxis = startDisc(0.0), startRim = startDisc(1.0), endAxis = endDisc(0.0),
               endRim = endDisc(1.0);
    const Vec2 axisPoint = (1.0 - up) * startAxis + up * endAxis;
    const Vec2 bilinear = (1.0 - up) * ((1.0 - radius) * startAxis + radius * startRim) +
                          up * ((1.0 - radius) * endAxis + radius * endRim);
    return (1.0 - radius) * axisPoint + radius * sidePoint + (1.0 - up) * startDisc(radius) +
           up * endDisc(radius) - bilinear;
  }
  double coreShare() const { return coreShare_; }

 private:
  /// Of the wrapping's width, how far the core's edge stands out where a closed end's disc meets the side. A
  /// core as round as its body would have flat corners there; standing out at this slope on both sides makes
  /// them 127 degrees.
  static constexpr double kEdgeShare = 0.5;
  static constexpr double kEdgeSlope = 0.41;

  /// 1 at such an edge, falling off to 0.
  double edge(double along) const {
    const double side = layout_.length - layout_.startLength - layout_.endLength;
    double height = 0.0;
    const auto add = [&](bool closed, double bend, double disc) {
      if (!closed) return;
      const double out =
          (1.0 - coreShare_) * kEdgeShare * (profile_.pairAt(bend).outside - axisAt(bend)).norm();
      const double width = std::min({out / kEdgeSlope, disc, 0.5 * side});
      height = std::max(height, 1.0 - std::abs(along - bend) / width);
    };
    add(layout_.startClosed, layout_.startLength, layout_.startLength);
    add(layout_.endClosed, layout_.length - layout_.endLength, layout_.endLength);
    return height;
  }

  Vec2 axisAt(double along) const {
    const double sideEnd = layout_.length - layout_.endLength;
    const double share =
        std::clamp((along - layout_.startLength) / (sideEnd - layout_.startLength), 0.0, 1.0);
    return {0.0, (1.0 - share) * axisStart_ + share * axisEnd_};
  }
  Vec2 startDisc(double radius) const {
    if (layout_.startClosed) return wrapping(radius * layout_.startLength, 0.0);
    return (1.0 - radius) * axisAt(0.0) + radius * wrapping(0.0, 0.0);
  }
  Vec2 endDisc(double radius) const {
    if (layout_.endClosed) return wrapping(layout_.length - radius * layout_.endLength, 0.0);
    return (1.0 - radius) * axisAt(layout_.length) + radius * wrapping(layout_.length, 0.0);
  }

  const WallProfile& profile_;
  const TurnedLayout& layout_;
  double coreShare_ = 1.0, axisStart_ = 0.0, axisEnd_ = 0.0;
};

Vec3 turned(const Vec2& point, double angle) {
  return {point.x() * std::cos(angle), point.x() * std::sin(angle), point.y()};
}

/// Adds `wrapping` to `core`; counterpart[node of wrapping] is a node of core, or kNone where the node is
/// new.
void weld(Lattice& core, const Lattice& wrapping, const std::vector<sim::NodeIndex>& counterpart) {
  std::vector<sim::NodeIndex> renumbered = counterpart;
  for (std::size_t node = 0; node < renumbered.size(); ++node) {
    if (renumbered[node] != sim::kNone) continue;
    renumbered[node] = static_cast<sim::NodeIndex>(core.nodes.size());
    core.nodes.push_back(wrapping.nodes[node]);
    core.parameters.push_back(wrapping.parameters[node]);
  }
  for (sim::CellCorners cell : wrapping.cells) {
    for (sim::NodeIndex& corner : cell) corner = renumbered[corner];
    core.cells.push_back(cell);
  }
}

/// What a body without closed ends is laid out like: the rows are those of its stack.
sim::Result<TurnedLayout> planStack(const WallProfile& profile, const RevolutionShape& shape,
                                    int cellsAround) {
  TurnedLayout layout;
  layout.startDisc.sectors = discSectors(shape.turnAngle);
  layout.startDisc.core = cellsAround / (2 * layout.startDisc.sectors);
  layout.startDisc.rings = flatDiscRings(layout.startDisc.core);
  layout.startDisc.angle = shape.turnAngle;
  layout.endDisc = layout.startDisc;
  layout.length = profile.length();
  const auto rows = cellsAlong(shape.resolution, 1, profile.length());
  if (!rows) return rows.problem();
  layout.rowsBetween = *rows;
  return layout;
}

class BodyBuilder {
 public:
  BodyBuilder(const WallProfile& profile, const RevolutionShape& shape, const TurnedLayout& layout,
              int wrappingLayers)
      : shape_(shape), layout_(layout), layers_(wrappingLayers), map_(profile, layout, wrappingLayers) {}

  Lattice run() {
    const Disc disc = divideDisc(layout_.startDisc);
    const Sheet sheet{disc.points, disc.quads, disc.rows};
    const LayerOrder order =
        layout_.rowsBetween > 2 * layout_.startDisc.core ? LayerOrder::innermost : LayerOrder::betweenRows;
    Lattice body =
        stack(sheet, layout_.rowsBetween, order, [&](const Vec2& p, int row) { return coreNode(p, row); });
    if (layers_ > 0) wrap(body, StackNumbering(sheet, layout_.rowsBetween, order));
    return body;
  }

 private:
  double angle(double share) const { return shape_.startAngle + share * shape_.turnAngle; }

  PlacedNode coreNode(const Vec2& point, int row) const {
    const double up = static_cast<double>(row) / layout_.rowsBetween;
    const double along =
        layout_.startLength + up * (layout_.length - layout_.startLength - layout_.endLength);
    return {turned(map_.core(point[0], up), angle(point[1])),
            {point[1], std::min(1.0, along / layout_.length), point[0] * map_.coreShare()}};
  }

  void wrap(Lattice& body, const StackNumbering& core) const {
    const TurnedSheet turnedSurface = turnedSheet(layout_);
    const Sheet& surface = turnedSurface.sheet;
    Lattice wrapping = stack(surface, layers_, LayerOrder::betweenRows, [&](const Vec2& point, int layer) {
      const double outward = static_cast<double>(layer) / layers_;
      const double w = map_.coreShare() + (1.0 - map_.coreShare()) * outward;
      return PlacedNode{turned(map_.wrapping(point[1], outward), angle(point[0])),
                        {point[0], point[1] / layout_.length, w}};
    });
    const StackNumbering numbering(surface, layers_, LayerOrder::betweenRows);
    std::vector<sim::NodeIndex> counterpart(wrapping.nodes.size(), sim::kNone);
    for (std::uint32_t node = 0; node < surface.points.size(); ++node)
      counterpart[numbering.node(node, 0)] =
          core.node(turnedSurface.discNode[node], turnedSurface.discLayer[node]);
    mirror(wrapping.cells);  // outwards is the wrapping's third axis and the core's second
    weld(body, wrapping, counterpart);
  }

  const RevolutionShape& shape_;
  const TurnedLayout& layout_;
  int layers_;
  BodyMap map_;
};

}  // namespace

sim::Result<Lattice> buildTurnedBody(const WallProfile& profile, const RevolutionShape& shape,
                                     int cellsAround) {
  const bool closed = profile.startClosed() || profile.endClosed();
  const auto layout =
      closed ? planTurned(profile, shape, cellsAround) : planStack(profile, shape, cellsAround);
  if (!layout) return layout.problem();
  int layers = 0;
  if (closed) {
    Resolution wrapping = shape.resolution;
    if (!wrapping.counts[2])
      wrapping.counts[2] = std::max(1, static_cast<int>(std::lround(0.4 * layout->startDisc.core)));
    const auto given = cellsAlong(wrapping, 2, 0.0);
    if (!given) return given.problem();
    layers = *given;
  }
  const double discs = discNodeCount(layout->startDisc) * (layout->rowsBetween + 1.0);
  const double around = layout->startDisc.nodesAround();
  const double surface = 2.0 * discNodeCount(layout->startDisc) + around * layout->rowsBetween;
  if (auto problem = checkNodeCount(discs + surface * layers)) return *problem;
  return BodyBuilder(profile, shape, *layout, layers).run();
}

}  // namespace modeling
