#include "app/cli/report.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

#include <tbb/info.h>

#include "modeling/text/text_file.h"
#include "sim/methods/method_names.h"

namespace app {
namespace {

constexpr std::size_t kLargestListed = 20;

Json vectorJson(const sim::Vec3& vector) {
  return Json::Array{vector.x(), vector.y(), vector.z()};
}

std::string hexadecimal(std::uint64_t hash) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

/// Every component of the start lives on as the fragment that kept its id.
void addFragments(const std::vector<sim::Fragment>& fragments, Json& report) {
  const auto fromStart = [](const sim::Fragment& fragment) { return fragment.parent == sim::kNone; };
  std::vector<std::uint32_t> sizes;
  sizes.reserve(fragments.size());
  for (const sim::Fragment& fragment : fragments) sizes.push_back(fragment.nodeCount);
  std::sort(sizes.rbegin(), sizes.rend());
  report["components"] = std::count_if(fragments.begin(), fragments.end(), fromStart);
  report["fragments"] = sizes.size();
  report["isolated_nodes"] = std::count(sizes.begin(), sizes.end(), 1U);
  sizes.resize(std::min(sizes.size(), kLargestListed));
  report["largest_fragments"] = sizes;
}

Json energyJson(const sim::Energy& energy, double maxRise) {
  return {
      {"kinetic", energy.kinetic},          {"elastic", energy.elastic},       {"gravity", energy.gravity},
      {"contact", energy.contact},          {"dissipated", energy.dissipated}, {"released", energy.released},
      {"outside_work", energy.outsideWork}, {"total", energy.mechanical()},    {"max_rise", maxRise},
      {"residual", energy.residual}};
}

Json workJson(const sim::Work& work) {
  return {{"bonds_evaluated", work.bondsEvaluated},   {"bonds_skipped", work.bondsSkipped},
          {"contact_pairs", work.contactPairs},       {"neighbour_lists", work.neighbourLists},
          {"contact_searches", work.contactSearches}, {"labelings", work.labelings},
          {"bonds_rigid", work.bondsRigid},           {"bonds_asleep", work.bondsAsleep},
          {"steps_rigid", work.stepsRigid},           {"bonds_untested", work.bondsUntested},
          {"bonds_undamped", work.bondsUndamped},     {"labelings_skipped", work.labelingsSkipped},
          {"ledgers_skipped", work.ledgersSkipped}};
}

int threadsUsed(int asked) {
  return asked > 0 ? asked : tbb::info::default_concurrency();
}

}  // namespace

Json reportOf(const ReportInput& input) {
  const sim::Simulation& simulation = input.simulation;
  const sim::Network& network = simulation.network();
  const sim::Snapshot end = simulation.snapshot();
  Json report;
  report["nodes"] = network.nodeCount();
  report["bonds"] = network.bondCount();
  report["cells"] = network.cellCount();
  addFragments(end.broken->fragments, report);
  report["broken_bonds"] = simulation.brokenBondCount();
  report["broken_cells"] = end.broken->lostCells();
  report["steps"] = simulation.stepCount();
  report["step_s"] = simulation.step();
  report["simulated_s"] = simulation.time();
  report["wall_s"] = input.stopwatch.wallSeconds();
  report["cpu_s"] = input.stopwatch.cpuSeconds();
  report["threads"] = threadsUsed(input.threads);
  report["method"] = sim::nameOf(input.method);
  report["state_hash"] = hexadecimal(simulation.stateHash());
  report["energy"] = energyJson(end.ledger.energy, simulation.maxRise());
  report["momentum"] = {{"linear", vectorJson(end.ledger.linearMomentum)},
                        {"angular", vectorJson(end.ledger.angularMomentum)}};
  report["work"] = workJson(simulation.work());
  report["work"]["nodes_unrecorded"] = input.recording.nodesLeftOut();
  report["events"] = {{"first_break_s", input.recording.firstBreak()}, {"breaks", input.recording.breaks()}};
  report["outcome"] = input.outcome;
  return report;
}

sim::Status writeReport(const Json& report, const std::filesystem::path& file) {
  return modeling::replaceTextFile(file, readable(report));
}

void printSummary(const Json& report) {
  const auto line = [&](const char* key) { return dumped(*report.find(key)); };
  std::cout << "simulated     " << *report.numberAt("simulated_s") << " s in " << line("steps") << " steps\n"
            << "fragments     " << line("fragments") << ", " << line("isolated_nodes")
            << " of them single nodes\n"
            << "broken bonds  " << line("broken_bonds") << '\n'
            << "wall clock    " << *report.numberAt("wall_s") << " s\n"
            << "state hash    " << report.textAt("state_hash") << '\n';
}

}  // namespace app
