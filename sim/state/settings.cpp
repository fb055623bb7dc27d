#include "sim/state/settings.h"

#include <algorithm>

namespace sim {

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

}  // namespace sim
