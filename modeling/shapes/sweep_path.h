#pragma once

#include <vector>

#include "modeling/shapes/curved_cylinder.h"
#include "modeling/shapes/measured_chain.h"

namespace modeling {

/// The plane and size of the section at one station of a sweep.
struct SweepStation {
  Vec3 centre, tangent;
  Vec3 first, second;      ///< unit axes
  double halfWidth = 0.0;  ///< cm, along the first
  double halfDepth = 0.0;  ///< cm, along the second
};

/// The way a CurvedCylinderShape takes, checked.
class SweepPath {
 public:
  static sim::Result<SweepPath> make(const CurvedCylinderShape& shape);

  double length() const { return centre_.length(); }  ///< of the centre line, cm
  /// Stations evenly spaced by length, cells + 1 of them.
  sim::Result<std::vector<SweepStation>> stations(int cells) const;

 private:
  SweepPath(const CurvedCylinderShape& shape, CurveChain centre);
  using Place = MeasuredChain<Vec3>::Place;
  double sizeAt(const ValueChain& values, const Place& place, double share) const;
  std::optional<sim::Problem> setAxes(SweepStation& station, const Place& place) const;
  void carryAxis(std::vector<SweepStation>& stations) const;

  const CurvedCylinderShape& shape_;
  MeasuredChain<Vec3> centre_;
};

}  // namespace modeling
