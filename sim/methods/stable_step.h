#pragma once

#include "sim/methods/spectrum.h"
#include "sim/state/settings.h"

namespace sim {

/// The longest step that is stable with this method, times `safety`, s: of a damped swing at the total
/// frequency. Zero where no step is stable, infinite where nothing limits the step.
double stableStep(const Spectrum& spectrum, const Stiffening& stiffening, Method method, double safety);

/// The step that the program takes by itself, s: stableStep(), and shorter where the method's accuracy asks
/// for it.
double automaticStep(const Spectrum& spectrum, const Stiffening& stiffening, Method method, double safety);

}  // namespace sim
