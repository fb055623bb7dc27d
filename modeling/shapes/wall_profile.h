#pragma once

#include <vector>

#include "modeling/shapes/measured_chain.h"
#include "modeling/shapes/revolution.h"

namespace modeling {

/// The half-plane (r, z) of a RevolutionShape, checked: which points of the profiles face each other, and the
/// spine along which cells are spaced: midway between the profiles, or the outside profile of a solid body.
class WallProfile {
 public:
  static sim::Result<WallProfile> make(const RevolutionShape& shape);

  bool solid() const { return solid_; }  ///< the inside profile lies on the axis from end to end
  bool startClosed() const {
    return startClosed_;
  }  ///< the wall, or a solid body's surface, meets the axis there
  bool endClosed() const { return endClosed_; }

  double length() const { return lengths_.back(); }  ///< of the spine, cm
  double radiusAt(double along) const { return spine(pairAt(along)).x(); }
  double largestRadius() const { return largestRadius_; }  ///< of the spine, cm
  double meanThickness() const { return meanThickness_; }  ///< cm

  /// Distance along the spine, from its start or its end, to where it has turned by 45 degrees from the way
  /// it left the axis; the whole length where it never does.
  double startBend() const { return startBend_; }
  double endBend() const { return endBend_; }

  struct Pair {
    Vec2 outside, inside;
  };
  /// The facing points at a distance along the spine.
  Pair pairAt(double along) const;

 private:
  WallProfile(const RevolutionShape& shape);
  Vec2 at(const MeasuredChain<Vec2>& chain, double share) const;
  Pair pairAtShare(double share) const;
  Vec2 spine(const Pair& pair) const {
    return solid_ ? pair.outside : Vec2(0.5 * (pair.outside + pair.inside));
  }
  void measureSpine();
  std::optional<sim::Problem> findEnds();
  std::optional<sim::Problem> checkWall() const;
  bool onAxis(const Vec2& point) const { return point.x() <= 1e-6 * size_; }

  MeasuredChain<Vec2> outside_, inside_;
  bool bySegments_ = false;
  bool solid_ = false, startClosed_ = false, endClosed_ = false;
  double size_ = 0.0;
  double largestRadius_ = 0.0, meanThickness_ = 0.0, startBend_ = 0.0, endBend_ = 0.0;
  std::vector<double> lengths_;  ///< of the spine up to equally spaced shares
};

}  // namespace modeling
