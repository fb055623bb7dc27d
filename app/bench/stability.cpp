#include "app/bench/stability.h"

#include <algorithm>
#include <cstdio>

#include "app/bench/stability_cases.h"
#include "app/bench/throughput.h"

namespace app {
namespace {

std::string number(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.1e", value);
  return digits;
}

/// What the cases of one group have in common.
struct Group {
  std::string name, method, passed, failed;
  double maxRise = 0.0, momentum = 0.0, deepest = 0.0;
};

void include(Group& group, const Json& row) {
  const bool passed = row.flagAt("passed");
  std::string& list = passed ? group.passed : group.failed;
  list += (list.empty() ? "" : ", ") + row.textAt("value");
  if (!passed) list += " (" + row.textAt("reason") + ")";
  group.maxRise = std::max(group.maxRise, row.numberAt("max_rise").value_or(0.0));
  group.momentum = std::max(group.momentum, row.numberAt("momentum_error").value_or(0.0));
  group.deepest = std::max(group.deepest, row.numberAt("deepest_cm").value_or(0.0));
}

}  // namespace

std::string stabilityTable(const Json::Array& rows) {
  std::vector<Group> groups;
  for (const Json& row : rows) {
    const std::string name = row.textAt("group"), method = row.textAt("method");
    if (groups.empty() || groups.back().name != name || groups.back().method != method) {
      auto found = std::find_if(groups.begin(), groups.end(),
                                [&](const Group& one) { return one.name == name && one.method == method; });
      if (found != groups.end()) {
        include(*found, row);
        continue;
      }
      groups.push_back({name, method, "", ""});
    }
    include(groups.back(), row);
  }
  std::string table =
      "| varied | method | passed | failed | largest rise of energy | change of momentum | deepest, cm |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Group& group : groups) {
    table += "| " + group.name + " | " + group.method + " | " + group.passed + " | " +
             (group.failed.empty() ? "none" : group.failed) + " | " + number(group.maxRise) + " | " +
             number(group.momentum) + " | " + number(group.deepest) + " |\n";
  }
  return table;
}

sim::Status benchStability(bool quick, const std::optional<std::filesystem::path>& folder) {
  Json::Array rows;
  for (const StabilityCase& one : stabilityCases(quick)) {
    const StabilityResult result = judge(one);
    rows.push_back(Json{{"group", one.group},
                        {"value", one.value},
                        {"method", one.method},
                        {"passed", result.passed},
                        {"reason", result.reason},
                        {"max_rise", result.maxRise},
                        {"momentum_error", result.momentumError},
                        {"deepest_cm", result.deepest}});
    std::fprintf(stderr, "%-50s %-8s %-18s %s %s\n", one.group.c_str(), one.value.c_str(), one.method.c_str(),
                 result.passed ? "passed" : "failed", result.reason.c_str());
  }
  std::fputs(stabilityTable(rows).c_str(), stdout);
  return writeRows(folder, "stability.json", rows);
}

}  // namespace app
