#include "app/bench/throughput.h"

#include <cmath>
#include <cstdio>
#include <iostream>

#include "app/bench/bodies.h"
#include "app/bench/lammps.h"
#include "app/bench/plain_loop.h"
#include "app/bench/timing.h"
#include "app/bench/triad.h"
#include "modeling/files/output_file.h"
#include "sim/kernel/bond_layout.h"

namespace app {
namespace {

constexpr int kRepeats = 5;
/// Bond updates a timing should take: about a quarter of a second.
constexpr double kUpdates = 5e7;

struct Row {
  std::string scene;
  std::size_t nodes = 0;
  std::size_t bonds = 0;  ///< whole ones at the end
  int threads = 1;
  double bondsPerSecond = 0.0;
  double bondsPerCpuSecond = 0.0;
  double plainLoop = 0.0;  ///< a CPU second
  double bytesPerNode = 0.0;
  double bandwidthShare = 0.0;  ///< of the triad's, if each step reads and writes its state once
};

int stepsFor(std::size_t bonds) {
  return std::max(4, static_cast<int>(kUpdates / static_cast<double>(bonds)));
}

/// Bytes a step must move at least: positions, velocities and inverse masses in, positions and velocities
/// out, and the layout of the bonds.
double bytesPerStep(const sim::Network& network) {
  constexpr double kStateBytes = (6 + 1 + 6) * sizeof(double);
  return kStateBytes * static_cast<double>(network.nodeCount()) +
         static_cast<double>(sim::BondLayout(network).memoryBytes());
}

sim::Status breakUp(sim::Simulation& running, double share) {
  const double wanted = share * static_cast<double>(running.network().bondCount());
  sim::Status status = sim::Done{};
  while (status && static_cast<double>(running.brokenBondCount()) < wanted) status = running.stepOnce();
  return status;
}

sim::Result<Row> measure(const Body& body, int threads, double bandwidth) {
  auto simulation = start(body.scene, threads);
  if (!simulation) return simulation.problem();
  sim::Simulation& running = **simulation;
  if (const sim::Status broken = breakUp(running, body.brokenShare); !broken) return broken.problem();
  const sim::Network& network = running.network();
  const int steps = stepsFor(network.bondCount());
  const sim::Work before = running.work();
  sim::Status status = sim::Done{};
  const Seconds seconds = medianSeconds(kRepeats, [&] {
    for (int step = 0; step < steps && status; ++step) status = running.stepOnce();
  });
  if (!status) return status.problem();
  // Some may go on breaking.
  const double updates = static_cast<double>(running.work().bondsEvaluated - before.bondsEvaluated) /
                         static_cast<double>(running.work().steps - before.steps) * steps;
  Row row;
  row.scene = body.name;
  row.nodes = network.nodeCount();
  row.bonds = network.bondCount() - running.brokenBondCount();
  row.threads = threads;
  row.bondsPerSecond = updates / seconds.wall;
  row.bondsPerCpuSecond = updates / seconds.cpu;
  row.bytesPerNode = static_cast<double>(running.memoryBytes()) / static_cast<double>(network.nodeCount());
  row.bandwidthShare = bytesPerStep(network) * steps / seconds.wall / bandwidth;
  PlainLoop plain(network);
  const double plainSeconds = medianSeconds(kRepeats, [&] { plain.run(steps, running.step()); }).cpu;
  row.plainLoop = static_cast<double>(network.bondCount()) * steps / plainSeconds;
  return row;
}

Json toJson(const Row& row) {
  return {{"scene", row.scene},
          {"nodes", row.nodes},
          {"bonds", row.bonds},
          {"precision", "double"},
          {"threads", row.threads},
          {"bonds_per_second", row.bondsPerSecond},
          {"bonds_per_cpu_second", row.bondsPerCpuSecond},
          {"bytes_per_node", row.bytesPerNode},
          {"bandwidth_share", row.bandwidthShare},
          {"plain_loop_bonds_per_cpu_second", row.plainLoop}};
}

/// The same bar here and in LAMMPS, a CPU second of one thread each.
sim::Result<std::optional<Json>> compareWithLammps() {
  auto simulation = start(slabScene(20, 20, 120), 1);
  if (!simulation) return simulation.problem();
  sim::Simulation& running = **simulation;
  const std::size_t bonds = running.network().bondCount();
  const int steps = stepsFor(bonds);
  const auto lammps = lammpsBondsPerSecond(running.network(), running.step(), steps);
  if (!lammps) return std::optional<Json>();
  sim::Status status = sim::Done{};
  const double seconds = medianSeconds(kRepeats, [&] {
                           for (int step = 0; step < steps && status; ++step) status = running.stepOnce();
                         }).cpu;
  if (!status) return status.problem();
  const double here = static_cast<double>(bonds) * steps / seconds;
  std::printf("a bar of %zu bonds, million a CPU second: %.1f here, %.1f in LAMMPS, ratio %.2f\n", bonds,
              here / 1e6, *lammps / 1e6, here / *lammps);
  return std::optional(Json{{"scene", "bar, beside LAMMPS"},
                            {"nodes", running.network().nodeCount()},
                            {"bonds", bonds},
                            {"precision", "double"},
                            {"threads", 1},
                            {"bonds_per_cpu_second", here},
                            {"lammps_bonds_per_cpu_second", *lammps}});
}

}  // namespace

sim::Status writeRows(const std::optional<std::filesystem::path>& folder, const char* name,
                      const Json::Array& rows) {
  if (!folder) return sim::Done{};
  std::error_code error;
  std::filesystem::create_directories(*folder, error);
  return modeling::replaceFile(*folder / name, dumped(rows, 2) + '\n');
}

sim::Status benchThroughput(const std::vector<int>& threads,
                            const std::optional<std::filesystem::path>& folder) {
  auto bodies = throughputBodies();
  if (!bodies) return bodies.problem();
  Json::Array rows;
  std::printf("%-24s %8s %9s %8s %16s %14s %14s %7s %11s %10s\n", "scene", "nodes", "bonds", "threads",
              "million bonds/s", "a CPU second", "plain loop", "ratio", "bytes/node", "bandwidth");
  for (const int count : threads) {
    const double bandwidth = triadBandwidth(count);
    std::printf("memory, %d threads: %.1f GB/s (triad)\n", count, bandwidth / 1e9);
    for (const Body& body : *bodies) {
      const auto row = measure(body, count, bandwidth);
      if (!row) return row.problem();
      std::printf("%-24s %8zu %9zu %8d %16.1f %14.1f %14.1f %7.2f %11.0f %8.0f %%\n", row->scene.c_str(),
                  row->nodes, row->bonds, row->threads, row->bondsPerSecond / 1e6,
                  row->bondsPerCpuSecond / 1e6, row->plainLoop / 1e6, row->bondsPerCpuSecond / row->plainLoop,
                  row->bytesPerNode, 100.0 * row->bandwidthShare);
      std::fflush(stdout);
      rows.push_back(toJson(*row));
      rows.back()["triad_bytes_per_second"] = bandwidth;
    }
  }
  const auto compared = compareWithLammps();
  if (!compared) return compared.problem();
  if (compared->has_value()) rows.push_back(**compared);
  return writeRows(folder, "throughput.json", rows);
}

}  // namespace app
