#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "modeling/shapes/bezier.h"

namespace modeling {

/// How a disc, or a wedge of one, is divided into quadrilaterals without wedges at its centre (an O-grid or
/// butterfly grid): sectors of at most 100 degrees, each of a core block of core x core cells that touches
/// the centre and two ring blocks between the core's far sides and the circle. Three cells meet at each core
/// block's far corner.
struct DiscLayout {
  int sectors = 4;
  int core = 1;        ///< cells along a side of a core block
  int rings = 1;       ///< cells between the core and the circle, >= 1
  double angle = 0.0;  ///< rad, of all sectors together; 2 pi closes on itself

  bool full() const;
  int cellsAround() const { return 2 * sectors * core; }
  int nodesAround() const { return full() ? cellsAround() : cellsAround() + 1; }
};

/// Rings that suit a flat disc: cells about as long outwards as they are wide.
int flatDiscRings(int core);

/// Sectors of a disc that turns by `angle`, rad.
int discSectors(double angle);

/// A divided unit disc. Node order: the core in rows of a square grid laid over all sectors, then the rings
/// from the innermost outwards, each around; the last ring is the circle, evenly spaced.
struct Disc {
  DiscLayout layout;
  std::vector<Vec2> points;  ///< (distance from the centre, share of the angle), both in [0, 1]
  std::vector<std::array<std::uint32_t, 4>>
      quads;                        ///< corners (0,0), (1,0), (0,1), (1,1) of the (around, outward) plane
  std::vector<std::uint32_t> rows;  ///< first node of each row, ascending
  std::size_t coreNodes = 0;

  /// First node of ring `ring`, 0 being the one next to the core.
  std::size_t ringStart(int ring) const {
    return coreNodes + static_cast<std::size_t>(ring) * static_cast<std::size_t>(layout.nodesAround());
  }
};

/// The blocks are straight. Laplacian smoothing was tried and rejected: it draws the cells together about the
/// three-cell corners (shortest edge 0.3 to 0.6 of the mean, against 0.84), and the shortest edge sets the
/// stable step.
Disc divideDisc(const DiscLayout& layout);

/// Number of nodes divideDisc() would make.
double discNodeCount(const DiscLayout& layout);

}  // namespace modeling
