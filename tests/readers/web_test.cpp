#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include "modeling/exchange/export.h"
#include "tests/support/flying_pieces.h"
#include "tests/support/point_sets.h"
#include "tests/support/run_program.h"

/// What readers of the web make of our glTF, where node and their packages are installed: globally, or in a
/// folder that NODE_PATH names.
namespace {

using sim::Vec3;
using Points = std::map<std::string, std::vector<Vec3>>;

/// A folder node_modules with the package; says so where there is none.
std::string modulesWith(const std::string& package) {
  const char* const stated = std::getenv("NODE_PATH");
  std::string global = tests::runCommand("npm root -g").output;
  global = global.substr(0, global.find('\n'));
  for (const std::string& folder : {std::string(stated == nullptr ? "" : stated), global}) {
    if (!folder.empty() && std::filesystem::exists(std::filesystem::path(folder) / package)) return folder;
  }
  WARN("the package " << package << " is not installed: what it makes of our files was not tested");
  return "";
}

std::string read(const std::string& reader, const std::string& modules, const std::string& file,
                 std::size_t frames) {
  const std::string out = file + "." + reader;
  const auto answer =
      tests::runCommand("node \"" SMITHEREENS_SOURCE_DIR "/tests/readers/read_glb.mjs\" " + reader + " \"" +
                        modules + "\" \"" + file + "\" " + std::to_string(frames) + " 24 \"" + out + "\"");
  INFO(answer.errors.substr(0, 2000));
  REQUIRE(answer.status == 0);
  std::ifstream stream(out, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What is drawn in each frame; first, what is without playing anything.
std::vector<Points> drawn(const std::string& text, std::size_t frames) {
  std::vector<Points> drawn(frames + 1);
  std::istringstream lines(text);
  int frame = 0;
  std::string name;
  Vec3 point;
  while (lines >> frame >> name >> point.x() >> point.y() >> point.z())
    drawn.at(static_cast<std::size_t>(frame + 1))[name].push_back(point);
  return drawn;
}

/// The fragment that a node shows, whichever of its looks.
sim::FragmentId idOf(const std::string& name) {
  return static_cast<sim::FragmentId>(std::stoul(name.substr(9)));
}

void checkDrawn(const tests::MemoryTake& take, const std::vector<Points>& drawn) {
  sim::SurfaceBuilder builder(take.network());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    CAPTURE(i);
    const auto expected = tests::pointsByFragment(builder.build(**take.frame(i == 0 ? 0 : i - 1)));
    REQUIRE(drawn[i].size() == expected.size());
    double worst = 0.0;
    for (const auto& [name, points] : drawn[i])
      worst = std::max(worst, tests::apart(points, expected.at(idOf(name))));
    CHECK(worst < 1e-4);
  }
}

TEST_CASE("a glb is without a fault to who validates it") {
  const std::string modules = modulesWith("gltf-validator");
  if (modules.empty()) return;
  const std::string folder = tests::freshFolder("smithereens-web");
  for (const tests::MemoryTake& take : {tests::crumblingBar(6), tests::flyingPieces(501, 3)}) {
    const std::string file = folder + "/pieces.glb";
    REQUIRE(
        modeling::writeGlb(take, {.path = file, .lastFrame = take.frameCount() - 1, .progress = {}}).ok());
    CHECK(read("validate", modules, file, 0).empty());
  }
}

TEST_CASE("programs of the web draw of a glb in each frame what was there, and nothing else") {
  const std::string folder = tests::freshFolder("smithereens-web");
  for (const auto& [reader, package] :
       {std::pair("three", "three"), std::pair("babylon", "@babylonjs/loaders")}) {
    const std::string modules = modulesWith(package);
    if (modules.empty()) continue;
    CAPTURE(reader);
    for (const tests::MemoryTake& take : {tests::crumblingBar(6), tests::flyingPieces(501, 3)}) {
      const std::string file = folder + "/pieces.glb";
      REQUIRE(
          modeling::writeGlb(take, {.path = file, .lastFrame = take.frameCount() - 1, .progress = {}}).ok());
      checkDrawn(take, drawn(read(reader, modules, file, take.frameCount()), take.frameCount()));
    }
  }
}

}  // namespace
