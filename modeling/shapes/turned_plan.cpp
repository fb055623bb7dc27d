#include "modeling/shapes/turned_plan.h"

#include <algorithm>
#include <cmath>

#include "modeling/shapes/cell_counts.h"

namespace modeling {
namespace {

class Planner {
 public:
  Planner(const WallProfile& profile, const RevolutionShape& shape, int cellsAround)
      : profile_(profile), shape_(shape) {
    DiscLayout disc;
    disc.sectors = discSectors(shape.turnAngle);
    disc.core = cellsAround / (2 * disc.sectors);
    disc.angle = shape.turnAngle;
    layout_.startDisc = layout_.endDisc = disc;
    layout_.startClosed = profile.startClosed();
    layout_.endClosed = profile.endClosed();
    layout_.length = profile.length();
  }

  sim::Result<TurnedLayout> run() {
    reachDiscs();
    chooseRings();
    const double between = betweenLength();
    if (!shape_.resolution.counts[1]) {
      const auto rows = cellsAlong(shape_.resolution, 1, between);
      if (!rows) return rows.problem();
      layout_.rowsBetween = between > 0.0 ? *rows : 0;
      return layout_;
    }
    const int least = discs() * (core() + 1) + (between > 0.0 ? 1 : 0);
    const auto along = cellsAlong(shape_.resolution, 1, layout_.length, 1, least);
    if (!along) return along.problem();
    fit(*along);
    return layout_;
  }

 private:
  int core() const { return layout_.startDisc.core; }
  int discs() const { return (layout_.startClosed ? 1 : 0) + (layout_.endClosed ? 1 : 0); }
  double betweenLength() const { return layout_.length - layout_.startLength - layout_.endLength; }

  void reachDiscs() {
    // A solid body needs at least one layer of cells between its ends.
    const double most = (profile_.solid() ? 0.8 : 1.0) * layout_.length / discs();
    if (layout_.startClosed) layout_.startLength = std::min(profile_.startBend(), most);
    if (layout_.endClosed) layout_.endLength = std::min(profile_.endBend(), most);
    const double cell = shape_.turnAngle * profile_.largestRadius() / layout_.startDisc.cellsAround();
    const double left = betweenLength();
    if (profile_.solid() || left > 0.5 * cell) return;
    if (layout_.startClosed) layout_.startLength += left / discs();
    layout_.endLength = layout_.endClosed ? layout_.length - layout_.startLength : 0.0;
  }

  int ringsFor(double reach, double fromStart) const {
    const double width = shape_.turnAngle * profile_.radiusAt(fromStart) / layout_.startDisc.cellsAround();
    // As many as flatDiscRings() gives a flat disc, where reach / width is 4 core / pi.
    const double cells = std::min(1.1 * reach / width, 4.0 * core() + 4.0);
    return std::max(1, static_cast<int>(std::lround(cells)) - core());
  }

  void chooseRings() {
    if (layout_.startClosed) layout_.startDisc.rings = ringsFor(layout_.startLength, layout_.startLength);
    if (layout_.endClosed)
      layout_.endDisc.rings = ringsFor(layout_.endLength, layout_.length - layout_.endLength);
    if (!layout_.startClosed) layout_.startDisc.rings = layout_.endDisc.rings;
    if (!layout_.endClosed) layout_.endDisc.rings = layout_.startDisc.rings;
    // The layers that wrap the core do the rings' work in a solid body.
    if (profile_.solid())
      layout_.startDisc.rings = layout_.endDisc.rings =
          std::max(1, static_cast<int>(std::lround(0.15 * core())));
  }

  /// Makes the whole have exactly `along` cells: by the rows between, and where those run out, by the rings.
  void fit(int along) {
    const bool rows = betweenLength() > 0.0;
    int& start = layout_.startDisc.rings;
    int& end = layout_.endDisc.rings;
    if (!rows || profile_.solid()) {
      const int rings = along - discs() * core() - (rows ? 1 : 0);
      if (!rows) {
        start = layout_.startClosed && layout_.endClosed ? (rings + 1) / 2 : rings;
        end = layout_.startClosed && layout_.endClosed ? rings / 2 : rings;
      } else {
        start = end = std::min(start, rings / discs());
      }
    }
    const auto used = [&] {
      return (layout_.startClosed ? core() + start : 0) + (layout_.endClosed ? core() + end : 0);
    };
    while (rows && used() + 1 > along)
      --(layout_.startClosed && (start >= end || !layout_.endClosed) ? start : end);
    layout_.rowsBetween = along - used();
  }

  const WallProfile& profile_;
  const RevolutionShape& shape_;
  TurnedLayout layout_;
};

}  // namespace

sim::Result<TurnedLayout> planTurned(const WallProfile& profile, const RevolutionShape& shape,
                                     int cellsAround) {
  return Planner(profile, shape, cellsAround).run();
}

}  // namespace modeling
