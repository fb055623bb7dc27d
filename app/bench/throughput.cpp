#include "app/bench/throughput.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/bench/bodies.h"
#include "app/bench/plain_loop.h"
#include "app/bench/timing.h"

namespace app {
namespace {

constexpr int kRepeats = 5;
/// Bond updates a timing should take: about a quarter of a second.
constexpr double kUpdates = 5e7;

struct Row {
  std::string scene;
  std::size_t nodes = 0;
  std::size_t bonds = 0;
  int threads = 1;
  double bondsPerSecond = 0.0;
  double plainLoop = 0.0;
  double bytesPerNode = 0.0;
};

int stepsFor(std::size_t bonds) {
  return std::max(4, static_cast<int>(kUpdates / static_cast<double>(bonds)));
}

sim::Result<Row> measure(const Body& body, int threads) {
  auto simulation = start(body.scene, threads);
  if (!simulation) return simulation.problem();
  sim::Simulation& running = **simulation;
  const sim::Network& network = running.network();
  const int steps = stepsFor(network.bondCount());
  sim::Status status = sim::Done{};
  const double seconds = medianSeconds(kRepeats, [&] {
    for (int step = 0; step < steps && status; ++step) status = running.stepOnce();
  });
  if (!status) return status.problem();
  Row row;
  row.scene = body.name;
  row.nodes = network.nodeCount();
  row.bonds = network.bondCount();
  row.threads = threads;
  row.bondsPerSecond = static_cast<double>(network.bondCount()) * steps / seconds;
  row.bytesPerNode = static_cast<double>(running.memoryBytes()) / static_cast<double>(network.nodeCount());
  PlainLoop plain(network);
  const double plainSeconds = medianSeconds(kRepeats, [&] { plain.run(steps, running.step()); });
  row.plainLoop = static_cast<double>(network.bondCount()) * steps / plainSeconds;
  return row;
}

nlohmann::ordered_json toJson(const Row& row) {
  return {{"scene", row.scene},
          {"nodes", row.nodes},
          {"bonds", row.bonds},
          {"precision", "double"},
          {"threads", row.threads},
          {"bonds_per_second", row.bondsPerSecond},
          {"bytes_per_node", row.bytesPerNode},
          {"plain_loop_bonds_per_second", row.plainLoop}};
}

}  // namespace

sim::Status writeResult(const std::filesystem::path& folder, const char* name, const std::string& text) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  std::ofstream file(folder / name);
  file << text << '\n';
  file.close();
  if (!file)
    return sim::Problem{(folder / name).string(), "the file cannot be written",
                        "choose another folder with --out"};
  return sim::Done{};
}

sim::Status benchThroughput(const std::vector<int>& threads,
                            const std::optional<std::filesystem::path>& folder) {
  auto bodies = throughputBodies();
  if (!bodies) return bodies.problem();
  auto rows = nlohmann::ordered_json::array();
  std::printf("%-24s %8s %9s %8s %16s %16s %7s %11s\n", "scene", "nodes", "bonds", "threads",
              "million bonds/s", "plain loop", "ratio", "bytes/node");
  for (const Body& body : *bodies) {
    for (const int count : threads) {
      const auto row = measure(body, count);
      if (!row) return row.problem();
      std::printf("%-24s %8zu %9zu %8d %16.1f %16.1f %7.2f %11.0f\n", row->scene.c_str(), row->nodes,
                  row->bonds, row->threads, row->bondsPerSecond / 1e6, row->plainLoop / 1e6,
                  row->bondsPerSecond / row->plainLoop, row->bytesPerNode);
      std::fflush(stdout);
      rows.push_back(toJson(*row));
    }
  }
  return folder ? writeResult(*folder, "throughput.json", rows.dump(2)) : sim::Done{};
}

}  // namespace app
