#pragma once

#include <string>
#include <vector>

#include "sim/dynamics/simulation.h"

namespace modeling {

/// Something that begins inside of something else, and is pushed out of it when the run begins.
struct Overlap {
  std::string part;                      ///< what is inside
  std::string other;                     ///< of what: an obstacle or another part
  bool obstacle = false;                 ///< the other is an obstacle
  double depth = 0.0;                    ///< cm: of the deepest point of the part
  sim::Vec3 where = sim::Vec3::Zero();   ///< that point, cm
  sim::Vec3 wayOut = sim::Vec3::Zero();  ///< cm: out of the obstacle from there; away from the other part

  /// In a sentence, with the remedy.
  std::string text() const;
};

/// Parts that begin inside obstacles or inside each other, the deepest of each pair, and the deepest pair
/// first. What touches is no overlap, nor is what is glued together, what is held inside an obstacle, or an
/// obstacle that is not there at the start. Looks at a body's cells only where the boxes of two bodies meet.
std::vector<Overlap> findOverlaps(const sim::Simulation& start, const sim::Environment& environment,
                                  const std::vector<sim::Track>& tracks);

}  // namespace modeling
