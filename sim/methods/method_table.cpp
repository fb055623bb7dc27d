#include "sim/methods/method_table.h"

#include <algorithm>

#include "sim/methods/implicit.h"
#include "sim/methods/leapfrog.h"
#include "sim/methods/one_step.h"
#include "sim/methods/runge_kutta.h"

namespace sim {
namespace {

/// The stiffest swing by itself needs 1.95 with Verlet, 2.67 with rk4, 1.38 with the midpoint rule, 0.32 with
/// implicit Euler, less the room that a step aims at below the tolerance.
constexpr double kSureOfLeapfrog = 1.5;
constexpr double kSureOfOneStep = 0.25;

template <Leapfrog::Recurrence recurrence>
std::unique_ptr<Integrator> makeLeapfrog(const World& world) {
  return std::make_unique<Leapfrog>(recurrence, world);
}

std::unique_ptr<Integrator> makeRungeKutta(const World& world) {
  return std::make_unique<OneStep>(std::make_unique<RungeKutta>(world.network.nodeCount()), world);
}

template <bool midpoint>
std::unique_ptr<Integrator> makeImplicit(const World& world) {
  return std::make_unique<OneStep>(
      std::make_unique<Implicit>(midpoint, world.inverseMasses, world.network.nodeCount()), world);
}

using Recurrence = Leapfrog::Recurrence;

constexpr std::array<MethodRecord, kMethods> kTable{{
    {.method = Method::forwardEuler,
     .name = "forward-euler",
     .leapfrog = true,
     .implicit = false,
     .error = {},
     .stableStep = forwardEulerStableStep,
     .automaticStep = forwardEulerCalmStep,
     .make = makeLeapfrog<Recurrence::forwardEuler>},
    {.method = Method::symplecticEuler,
     .name = "symplectic-euler",
     .leapfrog = true,
     .implicit = false,
     .error = {},
     .stableStep = leapfrogStableStep,
     .automaticStep = leapfrogStableStep,
     .make = makeLeapfrog<Recurrence::symplecticEuler>},
    {.method = Method::velocityVerlet,
     .name = "velocity-verlet",
     .leapfrog = true,
     .implicit = false,
     .error = {3, kSureOfLeapfrog},
     .stableStep = leapfrogStableStep,
     .automaticStep = leapfrogStableStep,
     .make = makeLeapfrog<Recurrence::verlet>},
    {.method = Method::rungeKutta,
     .name = "rk4",
     .leapfrog = false,
     .implicit = false,
     .error = {4, kSureOfOneStep},
     .stableStep = rungeKuttaStableStep,
     .automaticStep = rungeKuttaStableStep,
     .make = makeRungeKutta},
    {.method = Method::implicitEuler,
     .name = "implicit-euler",
     .leapfrog = false,
     .implicit = true,
     .error = {2, kSureOfOneStep},
     .stableStep = implicitStep,
     .automaticStep = implicitStep,
     .make = makeImplicit<false>},
    {.method = Method::implicitMidpoint,
     .name = "implicit-midpoint",
     .leapfrog = false,
     .implicit = true,
     .error = {3, kSureOfOneStep},
     .stableStep = implicitStep,
     .automaticStep = implicitStep,
     .make = makeImplicit<true>},
}};

constexpr bool isInOrder() {
  for (std::size_t m = 0; m < kTable.size(); ++m) {
    if (kTable[m].method != static_cast<Method>(m)) return false;
  }
  return true;
}
static_assert(isInOrder());

}  // namespace

const std::array<MethodRecord, kMethods>& methodTable() {
  return kTable;
}

const MethodRecord& recordOf(Method method) {
  return kTable[static_cast<std::size_t>(method)];
}

std::optional<Method> methodFromName(std::string_view name) {
  const auto* const found = std::ranges::find(kTable, name, &MethodRecord::name);
  return found == kTable.end() ? std::nullopt : std::optional(found->method);
}

std::string_view nameOf(Method method) {
  return recordOf(method).name;
}

bool isLeapfrog(Method method) {
  return recordOf(method).leapfrog;
}

bool isImplicit(Method method) {
  return recordOf(method).implicit;
}

const std::vector<std::string>& methodNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const MethodRecord& record : kTable) all.emplace_back(record.name);
    return all;
  }();
  return names;
}

}  // namespace sim
