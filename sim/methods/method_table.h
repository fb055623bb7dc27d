#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "sim/methods/integrator.h"
#include "sim/methods/method_names.h"
#include "sim/methods/spectrum.h"
#include "sim/state/settings.h"

namespace sim {

/// How a method's estimate of its own error grows with the step, and which step surely keeps to a tolerance
/// (docs/numerics.md, "Tolerance").
struct ErrorRule {
  int power = 0;  ///< the power of the step; 0: the method has no estimate, and takes no tolerance
  /// omega times the step over tolerance^(1 / (power - 1)) that is surely short enough for the stiffest swing
  double sure = 0.0;
};

/// All that the program knows of one method. A new one is an enumerator of Method, a row of the table, and
/// its own source.
struct MethodRecord {
  using StepRule = double (*)(const Spectrum&, const Stiffening&, double safety);

  Method method;
  std::string_view name;  ///< in files and on the command line
  bool leapfrog;  ///< one force a step, velocities kicked, positions drifted; fragments may be skipped
  bool implicit;  ///< stable with any step
  ErrorRule error;
  StepRule stableStep;     ///< see stableStep()
  StepRule automaticStep;  ///< see automaticStep()
  std::unique_ptr<Integrator> (*make)(const World& world);
};

/// In the order of the enumerators.
const std::array<MethodRecord, kMethods>& methodTable();
const MethodRecord& recordOf(Method method);

}  // namespace sim
