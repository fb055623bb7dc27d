#include "modeling/import/lammps_box.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace modeling {

using sim::Vec3;

LammpsBox LammpsBox::ofBounds(const Vec3& low, const Vec3& high, const Vec3& tilt) {
  LammpsBox box;
  box.origin = low;
  box.edges = (high - low).asDiagonal();
  box.edges(0, 1) = tilt.x();
  box.edges(0, 2) = tilt.y();
  box.edges(1, 2) = tilt.z();
  return box;
}

LammpsBox LammpsBox::ofOuterBounds(const Vec3& low, const Vec3& high, const Vec3& tilt) {
  const double xy = tilt.x(), xz = tilt.y(), yz = tilt.z();
  const Vec3 before(std::min({0.0, xy, xz, xy + xz}), std::min(0.0, yz), 0.0);
  const Vec3 behind(std::max({0.0, xy, xz, xy + xz}), std::max(0.0, yz), 0.0);
  return ofBounds(low - before, high - behind, tilt);
}

bool LammpsBox::hasVolume() const {
  const double volume = std::abs(edges.determinant());
  return std::isfinite(volume) && volume > 0.0 && edges.allFinite() && origin.allFinite();
}

Vec3 LammpsBox::inEdges(const Vec3& vector) const {
  return edges.partialPivLu().solve(vector);
}

Vec3 LammpsBox::wholeBoxes(const Vec3& vector, const std::array<bool, 3>& along) const {
  const Vec3 share = inEdges(vector);
  Vec3 whole = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (along[static_cast<std::size_t>(axis)]) whole += std::round(share[axis]) * edges.col(axis);
  }
  return whole;
}

}  // namespace modeling
