#include "sim/state/settings.h"

#include <algorithm>

namespace sim {

const std::vector<std::string>& methodNames() {
  static const std::vector<std::string> names = {"forward-euler", "symplectic-euler", "velocity-verlet",
                                                 "rk4",           "implicit-euler",   "implicit-midpoint"};
  return names;
}

std::optional<Method> methodFromName(std::string_view name) {
  const auto found = std::find(methodNames().begin(), methodNames().end(), name);
  if (found == methodNames().end()) return std::nullopt;
  return static_cast<Method>(found - methodNames().begin());
}

std::string_view nameOf(Method method) {
  return methodNames()[static_cast<std::size_t>(method)];
}

const std::vector<std::string>& precisionNames() {
  static const std::vector<std::string> names = {"double", "float"};
  return names;
}

std::optional<Precision> precisionFromName(std::string_view name) {
  const auto found = std::find(precisionNames().begin(), precisionNames().end(), name);
  if (found == precisionNames().end()) return std::nullopt;
  return static_cast<Precision>(found - precisionNames().begin());
}

std::string_view nameOf(Precision precision) {
  return precisionNames()[static_cast<std::size_t>(precision)];
}

bool isLeapfrog(Method method) {
  return method == Method::forwardEuler || method == Method::symplecticEuler ||
         method == Method::velocityVerlet;
}

bool isImplicit(Method method) {
  return method == Method::implicitEuler || method == Method::implicitMidpoint;
}

}  // namespace sim
