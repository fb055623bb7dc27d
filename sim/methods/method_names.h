#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/state/settings.h"

/// What the methods of the table (method_table.h) are called, for those who need no more of them.
namespace sim {

/// Nothing for a name that no method has.
std::optional<Method> methodFromName(std::string_view name);
std::string_view nameOf(Method method);
/// Velocities are kicked and positions drifted, with one force a step.
bool isLeapfrog(Method method);
/// It is stable with any step.
bool isImplicit(Method method);
/// All names, for messages and help.
const std::vector<std::string>& methodNames();

}  // namespace sim
