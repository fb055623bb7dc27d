#include "tests/fuzz/samples.h"

#include <fstream>
#include <iostream>

#include "modeling/run/recording.h"
#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "sim/dynamics/simulation.h"
#include "tests/fuzz/sample_images.h"
#include "tests/fuzz/sample_meshes.h"
#include "tests/fuzz/sample_texts.h"

namespace tests {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// A short run in which something breaks.
sim::Status record(const std::string& sceneText, const fs::path& file) {
  const auto scene = modeling::parseScene(sceneText, "sample");
  if (!scene) return scene.problem();
  auto built = modeling::build(scene->scene, "");
  if (!built) return built.problem();
  auto simulation = sim::Simulation::create(std::move(built->network), built->conditions.environment,
                                            built->conditions.tracks, built->conditions.settings);
  if (!simulation) return simulation.problem();
  auto take = modeling::createTake(file, built->scene, (*simulation)->network());
  if (!take) return take.problem();
  auto recording = modeling::Recording::ofNewRun(**simulation, std::move(*take),
                                                 {scene->scene.output.fps, scene->scene.output.duration});
  return recording.run([](const sim::Simulation&) {});
}

}  // namespace

const std::vector<Sample>& samples() {
  static const std::vector<Sample> kAll{
      {"scene", "full.scene.json", Nature::json},
      {"scene", "table.scene.json", Nature::json},
      {"scene", "glued.scene.json", Nature::json},
      {"scene", "obstacles.scene.json", Nature::json},
      {"scene", "shapes.scene.json", Nature::json},
      {"tracks", "tracks.scene.json", Nature::json},
      {"take", "run.take", Nature::take},
      {"network", "bar.data", Nature::text},
      {"dump", "run.dump", Nature::text},
      {"dump", "run.bonds", Nature::text},
      {"mesh", "box.obj", Nature::text},
      {"mesh", "ball.stl", Nature::binary},
      {"mesh", "ball-words.stl", Nature::text},
      {"mesh", "ball-words.ply", Nature::text},
      {"mesh", "ball.ply", Nature::binary},
      {"mesh", "ball.glb", Nature::binary},
      {"environment", "flat.hdr", Nature::binary},
      {"environment", "runs.hdr", Nature::binary},
      {"environment", "old-runs.hdr", Nature::binary},
      {"environment", "sky.exr", Nature::binary},
      {"environment", "sky.png", Nature::binary},
      {"kept", "takes.json", Nature::json},
      {"recovery", "autosave.json", Nature::json},
      {"recovery", "autosave.scene.json", Nature::json},
      {"report", "report.json", Nature::json},
  };
  return kAll;
}

bool writeSamples(const fs::path& folder) {
  for (const Sample& sample : samples()) fs::create_directories(folder / sample.kind);
  for (const auto& [name, text] : sampleTexts()) write(folder / name, text);
  for (const auto& [name, bytes] : sampleMeshes()) write(folder / "mesh" / name, bytes);
  writeSampleImages(folder / "environment");
  const fs::path take = folder / "take" / "run.take";
  if (const auto status = record(breakingScene(), take); !status) {
    std::cerr << "no sample of a take: " << status.problem().line() << '\n';
    return false;
  }
  for (const char* beside : {"kept", "recovery"}) fs::copy_file(take, folder / beside / "run.take");
  for (const Sample& sample : samples()) {
    if (fs::exists(folder / sample.kind / sample.file)) continue;
    std::cerr << "no sample " << sample.kind << "/" << sample.file << '\n';
    return false;
  }
  return true;
}

}  // namespace tests
