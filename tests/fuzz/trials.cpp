#include "tests/fuzz/trials.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <sstream>

#include "app/results/json.h"
#include "modeling/exchange/lammps_import.h"
#include "modeling/exchange/take_scene.h"
#include "modeling/import/lammps_data.h"
#include "modeling/preflight/preflight.h"
#include "modeling/scene/build.h"
#include "modeling/scene/salvage.h"
#include "modeling/scene/scene_file.h"
#include "modeling/text/printable.h"
#include "sim/dynamics/simulation.h"
#include "sim/take/frame_codec.h"
#include "ui/picture/environment_map.h"
#include "ui/picture/take_pictures.h"

namespace tests {
namespace {

namespace fs = std::filesystem;

constexpr int kSteps = 3;
/// s: longer than this a pre-flight is not let measure.
constexpr double kPreflightPatience = 0.2;
/// More nodes make no other faults, only longer trials.
constexpr std::size_t kMostNodes = 30'000;

Finding refusal(const sim::Problem& problem) {
  return tests::refusal(problem.place, problem.what, problem.remedy);
}

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

Finding runScene(const modeling::Scene& scene, const fs::path& folder) {
  auto built = modeling::build(scene, folder);
  if (!built) return refusal(built.problem());
  if (const auto broken = built->network.validate()) return "WRONG: the network is not sound: " + *broken;
  const std::string size = std::to_string(built->network.nodeCount()) + " nodes";
  if (built->network.nodeCount() > kMostNodes) return "built, " + size;
  const auto start = std::chrono::steady_clock::now();
  const auto goesOn = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() <
           kPreflightPatience;
  };
  for (const modeling::Overlap& overlap : modeling::findOverlaps(*built)) {
    const std::string text = modeling::sentence(overlap);
    if (text.find("nan") != std::string::npos || text.find("inf ") != std::string::npos)
      return "WRONG: " + text;
  }
  static_cast<void>(modeling::preflight(built->scene, *built, 1, goesOn));
  built->conditions.settings.threads = 1;
  auto simulation = sim::Simulation::create(std::move(built->network), built->conditions.environment,
                                            built->conditions.tracks, built->conditions.settings);
  if (!simulation) return refusal(simulation.problem());
  for (int step = 0; step < kSteps; ++step) {
    if (const sim::Status status = (*simulation)->stepOnce(); !status)
      return "run, ended: " + status.problem().line();
  }
  return "run, " + size;
}

Finding tryScene(const fs::path& file) {
  const std::string text = bytesOf(file);
  const auto salvaged = modeling::salvageScene(text, file.filename().string());
  if (salvaged) static_cast<void>(modeling::writeScene(salvaged->scene));
  const auto scene = modeling::loadScene(file);
  if (!scene) return refusal(scene.problem());
  if (!salvaged || !(salvaged->scene == scene->scene)) return "WRONG: what can be read is not salvaged whole";
  const auto again = modeling::parseScene(modeling::writeScene(scene->scene), "written");
  if (!again || !(again->scene == scene->scene)) return "WRONG: written and read it is another scene";
  return runScene(scene->scene, file.parent_path());
}

Finding tryTake(const fs::path& file) {
  const auto opened = sim::TakeReader::open(file);
  if (!opened) return refusal(opened.problem());
  const sim::TakeReader& take = **opened;
  if (const auto broken = take.network().validate()) return "WRONG: the network is not sound: " + *broken;
  const sim::NetworkSize size = sim::NetworkSize::of(take.network());
  std::size_t whole = 0;
  for (std::size_t frame = 0; frame < take.frameCount(); ++frame) {
    static_cast<void>(take.eventsOf(frame));
    static_cast<void>(take.sceneOf(frame));
    const auto read = take.frame(frame);
    if (!read) continue;
    if (const auto fault = sim::faultOf(size, **read)) return "WRONG: a frame is not sound: " + *fault;
    ++whole;
  }
  static_cast<void>(take.events());
  static_cast<void>(take.outcome());
  for (const std::size_t frame : take.checkpointFrames()) static_cast<void>(take.checkpoint(frame));
  if (const auto scene = modeling::sceneOf(take); scene && take.frameCount() > 0) {
    auto frames = ui::framesOf(take);
    if (frames) {
      auto pictures = ui::TakePictures::create(std::move(*frames), 0, take.frameCount() - 1, 1.0);
      if (pictures) static_cast<void>(pictures->sceneOf(take.frameCount() - 1));
    }
  }
  return "read, " + std::to_string(whole) + " of " + std::to_string(take.frameCount()) + " frames";
}

/// Of one part that reads the file.
std::string sceneOfFile(const std::string& kind, const std::string& file) {
  const std::string types =
      kind == "network"
          ? R"(, "format": "lammps", "bondTypes": {"1": {"stiffness": 1000}, "2": {"stiffness": 500}})"
          : R"(, "material": "clay", "cellSize": 0.8)";
  return R"({"smithereens": 1, "materials": {"clay": {"youngsModulus": 1e7}}, "parts": [{"name": "p", "kind": ")" +
         kind + R"(", "file": ")" + file + "\"" + types + "}]}";
}

Finding tryNetwork(const fs::path& file) {
  const auto data = modeling::loadLammpsData(file);
  if (!data) return refusal(data.problem());
  const auto scene = modeling::parseScene(sceneOfFile("network", file.filename().string()), "scene");
  if (!scene) return "WRONG: " + scene.problem().line();
  return runScene(scene->scene, file.parent_path());
}

Finding tryMesh(const fs::path& file) {
  const auto scene = modeling::parseScene(sceneOfFile("mesh", file.filename().string()), "scene");
  if (!scene) return "WRONG: " + scene.problem().line();
  const Finding asPart = runScene(scene->scene, file.parent_path());
  // As an obstacle, which may be open too.
  const auto obstacle = modeling::parseScene(
      R"({"smithereens": 1, "materials": {"clay": {"youngsModulus": 1e7}}, "parts": [{"name": "p", "kind": "slab",
      "material": "clay", "size": [1, 1, 1]}], "environment": {"colliders": [{"name": "o", "kind": "mesh", "file": ")" +
          file.filename().string() + "\"}]}}",
      "scene");
  if (!obstacle) return "WRONG: " + obstacle.problem().line();
  const Finding asObstacle = runScene(obstacle->scene, file.parent_path());
  return asPart.starts_with("WRONG") ? asPart : asObstacle.starts_with("WRONG") ? asObstacle : asPart;
}

Finding tryDump(const fs::path& file) {
  const fs::path folder = file.parent_path();
  const auto scene = modeling::loadScene(folder / "scene.json");
  if (!scene) return "WRONG: " + scene.problem().line();
  const auto built = modeling::build(scene->scene, folder);
  if (!built) return "WRONG: " + built.problem().line();
  const auto frames = modeling::importLammps({folder / "run.dump", folder / "run.bonds"}, scene->scene,
                                             built->network, folder / "imported.take");
  if (!frames) return refusal(frames.problem());
  const auto take = sim::TakeReader::open(folder / "imported.take");
  if (!take) return "WRONG: the take that was made cannot be read: " + take.problem().line();
  return "read, " + std::to_string(*frames) + " frames";
}

Finding tryEnvironment(const fs::path& file) {
  auto image = ui::readEnvironment(file);
  if (!image) return refusal(image.problem());
  const auto isLight = [](const ui::Light& light) { return light.isFinite().all() && (light >= 0.0F).all(); };
  if (!std::ranges::all_of(image->pixels, isLight)) return "WRONG: light that is no number, or below zero";
  const auto map = ui::EnvironmentMap::create(std::move(*image), 1.0, 10.0);
  return map ? "read" : refusal(map.problem());
}

Finding tryReport(const fs::path& file) {
  const auto report = app::parseJson(bytesOf(file));
  if (!report) return "refused: it is no JSON";
  for (const char* key : {"outcome", "fragments", "state_hash", "events"}) {
    static_cast<void>(report->numberAt(key));
    static_cast<void>(report->textAt(key));
    static_cast<void>(report->flagAt(key));
  }
  const std::string text = app::dumped(*report);
  const auto again = app::parseJson(text);
  if (!again || app::dumped(*again) != text) return "WRONG: written and read it is another report";
  static_cast<void>(app::readable(*report));
  return "read";
}

}  // namespace

Finding refusal(const std::string& place, const std::string& what, const std::string& remedy) {
  constexpr std::size_t kLongest = 800;
  const std::string line = sim::Problem{place, what, remedy}.line();
  const auto isControl = [](char letter) { return (letter >= 0 && letter < ' ') || letter == '\x7f'; };
  if (what.empty()) return "WRONG: a problem says nothing";
  if (line.size() > kLongest)
    return "WRONG: a problem of " + std::to_string(line.size()) + " letters: " + line.substr(0, 100);
  if (std::ranges::any_of(line, isControl))
    return "WRONG: a problem with control characters: " + modeling::printable(line);
  return "refused: " + line;
}

Finding tryInput(std::string_view kind, const fs::path& file) {
  if (kind == "scene" || kind == "tracks") return tryScene(file);
  if (kind == "take") return tryTake(file);
  if (kind == "network") return tryNetwork(file);
  if (kind == "dump") return tryDump(file);
  if (kind == "mesh") return tryMesh(file);
  if (kind == "environment") return tryEnvironment(file);
  if (kind == "kept") return tryKeptTakes(file);
  if (kind == "recovery") return tryRecovery(file.parent_path());
  if (kind == "report") return tryReport(file);
  return "WRONG: there is no such kind";
}

}  // namespace tests
