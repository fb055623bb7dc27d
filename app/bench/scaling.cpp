#include <cstdio>

#include "app/bench/bodies.h"
#include "app/bench/throughput.h"
#include "app/bench/timing.h"

namespace app {
namespace {

constexpr int kRepeats = 3;

/// Slabs and heaps of cubes, each size about four times the one before.
std::vector<Body> scalingBodies() {
  std::vector<Body> bodies;
  for (const int edge : {12, 20, 32, 50}) bodies.push_back({"slab", slabScene(edge, edge, edge)});
  for (const int count : {4, 6, 10, 16}) bodies.push_back({"loose cubes", looseCubesScene(count)});
  return bodies;
}

}  // namespace

sim::Status benchScaling(int threads, const std::optional<std::filesystem::path>& folder) {
  Json::Array rows;
  std::printf("%-12s %8s %9s %10s %14s %12s %18s\n", "scene", "nodes", "bonds", "fragments", "pairs a step",
              "lists/step", "ns a node and step");
  for (const Body& body : scalingBodies()) {
    auto simulation = start(body.scene, threads);
    if (!simulation) return simulation.problem();
    sim::Simulation& running = **simulation;
    const double nodes = static_cast<double>(running.network().nodeCount());
    const int steps = std::max(20, static_cast<int>(4e6 / nodes));
    const sim::Work before = running.work();
    sim::Status status = sim::Done{};
    const double seconds = medianSeconds(kRepeats, [&] {
                             for (int step = 0; step < steps && status; ++step) status = running.stepOnce();
                           }).wall;
    if (!status) return status.problem();
    const double done = static_cast<double>(running.work().steps - before.steps);
    const double pairs = static_cast<double>(running.work().contactPairs - before.contactPairs) / done;
    const double lists = static_cast<double>(running.work().neighbourLists - before.neighbourLists) / done;
    const std::size_t fragments = running.snapshot().fragments.size();
    const double nanoseconds = seconds / steps / nodes * 1e9;
    std::printf("%-12s %8.0f %9zu %10zu %14.0f %12.4f %18.1f\n", body.name.c_str(), nodes,
                running.network().bondCount(), fragments, pairs, lists, nanoseconds);
    std::fflush(stdout);
    rows.push_back(Json{{"scene", body.name},
                        {"nodes", nodes},
                        {"bonds", running.network().bondCount()},
                        {"fragments", fragments},
                        {"threads", threads},
                        {"pairs_per_step", pairs},
                        {"neighbour_lists_per_step", lists},
                        {"nanoseconds_per_node_and_step", nanoseconds}});
  }
  return writeRows(folder, "scaling.json", rows);
}

}  // namespace app
