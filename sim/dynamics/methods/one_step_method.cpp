#include "sim/dynamics/methods/one_step_method.h"

#include "sim/dynamics/methods/implicit.h"
#include "sim/dynamics/methods/runge_kutta.h"

namespace sim {

std::unique_ptr<OneStepMethod> oneStepMethod(Method method, std::span<const double> inverseMasses,
                                             std::size_t nodeCount) {
  switch (method) {
    case Method::forwardEuler:
    case Method::symplecticEuler:
    case Method::velocityVerlet:
      return nullptr;
    case Method::rungeKutta:
      return std::make_unique<RungeKutta>(nodeCount);
    case Method::implicitEuler:
      return std::make_unique<Implicit>(false, inverseMasses, nodeCount);
    case Method::implicitMidpoint:
      return std::make_unique<Implicit>(true, inverseMasses, nodeCount);
  }
  return nullptr;
}

}  // namespace sim
