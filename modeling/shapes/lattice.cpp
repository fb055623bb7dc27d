#include "modeling/shapes/lattice.h"

#include <cstdio>
#include <utility>

#include "modeling/shapes/quality.h"

namespace modeling {
namespace {

// A corner this sharp or sharper is taken for flat: the stiffness fit of such a cell would be noise.
constexpr double kFlatCorner = 1e-3;

std::string describe(const Vec3& position) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.4g, %.4g, %.4g)", position.x(), position.y(), position.z());
  return text;
}

}  // namespace

void mirror(std::vector<sim::CellCorners>& cells) {
  for (sim::CellCorners& cell : cells)
    for (std::size_t corner = 0; corner < 8; corner += 2) std::swap(cell[corner], cell[corner + 1]);
}

sim::Result<Lattice> completed(Lattice lattice, const std::string& remedy) {
  for (const Vec3& node : lattice.nodes)
    if (!node.allFinite()) return sim::Problem{"", "the shape has a node that is not finite", remedy};
  double volume = 0.0;
  for (const sim::CellCorners& cell : lattice.cells)
    volume += cellVolume(cornerPositions(lattice.nodes, cell));
  if (volume < 0.0) mirror(lattice.cells);
  for (const sim::CellCorners& cell : lattice.cells) {
    const CornerPositions corners = cornerPositions(lattice.nodes, cell);
    if (scaledJacobian(corners) > kFlatCorner) continue;
    return sim::Problem{"", "the shape folds or is flat near " + describe(corners[0]), remedy};
  }
  return lattice;
}

}  // namespace modeling
