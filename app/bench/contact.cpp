#include "app/bench/contact.h"

#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "app/bench/contact_scenes.h"
#include "app/bench/throughput.h"

namespace app {
namespace {

/// The same case by surfaces and, where it is run so, by nodes.
struct BothKinds {
  ContactOutcome surfaces;
  std::optional<ContactOutcome> nodes;
};

sim::Result<BothKinds> runBoth(const ContactCase& one) {
  auto surfaces = one.run(sim::ContactKind::surfaces);
  if (!surfaces) return surfaces.problem();
  BothKinds both{std::move(*surfaces), std::nullopt};
  if (!one.byNodes) return both;
  auto nodes = one.run(sim::ContactKind::nodes);
  if (!nodes) return nodes.problem();
  both.nodes = std::move(*nodes);
  return both;
}

std::string number(const std::optional<double>& value) {
  if (!value) return "-";
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.4g", *value);
  return digits.data();
}

/// One quantity as a row, printed.
Json told(const ContactCase& one, std::size_t index, const BothKinds& both) {
  const ContactQuantity& quantity = one.quantities[index];
  std::optional<double> surfaces = both.surfaces.values[index], nodes, cpuNodes;
  if (both.nodes) {
    nodes = both.nodes->values[index];
    cpuNodes = both.nodes->cpuSeconds;
  }
  if (quantity.overNodes && surfaces && nodes) {
    *surfaces /= *nodes;
    nodes = 1.0;
  }
  std::printf("%-70s %-11s %-42s %-5s %9s %-13s %9s %9s %7.2f %7s %8.1e\n", one.what.c_str(),
              one.cells.c_str(), quantity.name.c_str(), quantity.unit.c_str(),
              number(quantity.expected).c_str(), quantity.goal.c_str(), number(surfaces).c_str(),
              number(nodes).c_str(), both.surfaces.cpuSeconds, number(cpuNodes).c_str(),
              both.surfaces.maxRise);
  std::fflush(stdout);
  return {{"what", one.what},
          {"cells", one.cells},
          {"quantity", quantity.name},
          {"unit", quantity.unit},
          {"expected", quantity.expected},
          {"goal", quantity.goal},
          {"surfaces", surfaces},
          {"nodes", nodes},
          {"cpu_surfaces_s", both.surfaces.cpuSeconds},
          {"cpu_nodes_s", cpuNodes},
          {"max_rise", both.surfaces.maxRise}};
}

}  // namespace

sim::Status benchContact(bool quick, const std::optional<std::filesystem::path>& folder) {
  const auto cases = contactCases();
  if (!cases) return cases.problem();
  Json::Array rows;
  std::printf("%-70s %-11s %-42s %-5s %9s %-13s %9s %9s %7s %7s %8s\n", "what", "cells", "quantity", "unit",
              "expected", "goal", "surfaces", "nodes", "CPU, s", "nodes", "max rise");
  for (const ContactCase& one : *cases) {
    if (quick && one.slow) continue;
    const auto both = runBoth(one);
    if (!both) return both.problem();
    for (std::size_t index = 0; index < one.quantities.size(); ++index)
      rows.push_back(told(one, index, *both));
  }
  return writeRows(folder, "contact.json", rows);
}

}  // namespace app
