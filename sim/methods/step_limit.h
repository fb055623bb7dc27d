#pragma once

namespace sim {

/// What makes the step no longer than it is.
enum class StepLimit {
  none,       ///< free flight: frames set the pace
  fixed,      ///< Settings::step
  lattice,    ///< bonds
  contact,    ///< without contacts it could be a tenth longer or more
  tolerance,  ///< Settings::tolerance
};

}  // namespace sim
