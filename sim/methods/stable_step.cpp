#include "sim/methods/stable_step.h"

#include <limits>

#include "sim/methods/method_table.h"

namespace sim {

double stableStep(const Spectrum& spectrum, const Stiffening& stiffening, Method method, double safety) {
  if (!(totalFrequency(spectrum, stiffening) > 0.0)) return std::numeric_limits<double>::infinity();
  return recordOf(method).stableStep(spectrum, stiffening, safety);
}

double automaticStep(const Spectrum& spectrum, const Stiffening& stiffening, Method method, double safety) {
  if (!(totalFrequency(spectrum, stiffening) > 0.0)) return std::numeric_limits<double>::infinity();
  return recordOf(method).automaticStep(spectrum, stiffening, safety);
}

}  // namespace sim
