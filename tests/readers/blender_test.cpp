#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include "modeling/exchange/export.h"
#include "modeling/exchange/surface_vertices.h"
#include "modeling/import/mesh_file.h"
#include "tests/fuzz/text_cuts.h"
#include "tests/support/flying_pieces.h"
#include "tests/support/point_sets.h"
#include "tests/support/run_program.h"

/// What Blender makes of our files, where it is installed.
namespace {

using sim::Vec3;

bool haveBlender() {
  // Its importer of glTF needs numpy, which Debian installs apart.
  static const int kStatus =
      tests::runCommand("blender --background --python-exit-code 3 --python-expr 'import numpy'").status;
  if (kStatus == 0) return true;
  WARN("blender or python3-numpy is not installed: what Blender makes of our files was not tested");
  return false;
}

/// Everything that is to be seen in Blender: the points of each object in each frame, cm.
struct Seen {
  double rate = 0.0;
  int firstFrame = -1, lastFrame = -1;
  std::vector<std::map<std::string, std::vector<Vec3>>> frames;
};

Seen seenInBlender(const std::string& file, std::size_t frames) {
  const std::string out = file + ".txt";
  const auto answer = tests::runCommand(
      "blender --background --factory-startup --python-exit-code 3 --python \"" SMITHEREENS_SOURCE_DIR
      "/tests/readers/read_animation.py\" -- \"" +
      file + "\" " + std::to_string(frames) + " \"" + out + "\"");
  INFO(answer.output << answer.errors);
  REQUIRE(answer.status == 0);
  Seen seen;
  seen.frames.resize(frames);
  std::ifstream stream(out);
  std::string word;
  stream >> word >> seen.rate >> seen.firstFrame >> seen.lastFrame;
  std::size_t frame = 0;
  Vec3 point;
  while (stream >> frame >> word >> point.x() >> point.y() >> point.z())
    seen.frames.at(frame)[word].push_back(point);
  return seen;
}

TEST_CASE("Blender plays a glb as it was recorded, object by object and frame by frame") {
  if (!haveBlender()) return;
  const tests::MemoryTake take = tests::flyingPieces(4, 25);
  const std::string file = tests::freshFolder("smithereens-blender") + "/pieces.glb";
  REQUIRE(modeling::writeGlb(take, {.path = file, .lastFrame = 24, .progress = {}}).ok());
  const Seen seen = seenInBlender(file, 25);
  CHECK(seen.rate == Approx(24.0));
  CHECK(seen.firstFrame == 0);
  CHECK(seen.lastFrame == 24);
  double worst = 0.0;
  for (std::size_t frame = 0; frame < 25; ++frame) {
    const auto expected =
        tests::pointsByFragment(sim::SurfaceBuilder(take.network()).build(**take.frame(frame)));
    REQUIRE(seen.frames[frame].size() == expected.size());
    for (const auto& [id, points] : expected) {
      // The first one looks otherwise once the others have come off it.
      const std::string name = id > 0       ? "fragment_" + std::to_string(id)
                               : frame == 0 ? "fragment_0_from_0"
                                            : "fragment_0_from_1";
      worst = std::max(worst, tests::apart(points, seen.frames[frame].at(name)));
    }
  }
  CHECK(worst < 1e-4);
}

TEST_CASE("Blender plays hundreds of fragments of a glb as they were recorded") {
  if (!haveBlender()) return;
  const tests::MemoryTake take = tests::flyingPieces(501, 4);
  const std::string file = tests::freshFolder("smithereens-blender") + "/pieces.glb";
  REQUIRE(modeling::writeGlb(take, {.path = file, .lastFrame = 3, .progress = {}}).ok());
  const Seen seen = seenInBlender(file, 4);
  for (std::size_t frame = 0; frame < 4; ++frame) {
    const sim::SurfaceMesh expected = sim::SurfaceBuilder(take.network()).build(**take.frame(frame));
    REQUIRE(seen.frames[frame].size() == (frame == 0 ? 1 : 501));
    std::vector<Vec3> points;
    for (const auto& [name, own] : seen.frames[frame]) points.insert(points.end(), own.begin(), own.end());
    CHECK(tests::apart(expected.points, points) < 1e-4);
  }
}

TEST_CASE("Blender plays a deforming surface from its cache as it was recorded") {
  if (!haveBlender()) return;
  const tests::MemoryTake take = tests::flyingPieces(3, 6);
  const std::string folder = tests::freshFolder("smithereens-blender");
  REQUIRE(modeling::writePc2(take, {.path = folder + "/pieces.pc2", .lastFrame = 5, .progress = {}}).ok());
  const Seen seen = seenInBlender(folder + "/pieces.pc2", 6);
  CHECK(seen.rate == Approx(24.0));
  CHECK(seen.lastFrame == 5);
  for (std::size_t frame = 0; frame < 6; ++frame) {
    REQUIRE(seen.frames[frame].size() == 1);
    const auto& points = seen.frames[frame].begin()->second;
    const sim::SurfaceMesh mesh = tests::surfaceOfPieces(take, frame);
    const auto expected = modeling::verticesOf(mesh).vertices;
    REQUIRE(points.size() == expected.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
      worst = std::max(worst, (points[i] - mesh.points[expected[i].point]).norm());
    CHECK(worst < 1e-4);
  }
}

std::string textOf(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_CASE(
    "a mesh that Blender exports as FBX is read with its size and its axes, and damaged ones do no harm") {
  if (!haveBlender()) return;
  const std::string folder = tests::freshFolder("smithereens-blender");
  const auto answer = tests::runCommand(
      "blender --background --factory-startup --python-exit-code 3 --python-expr '"
      "import bpy; bpy.ops.object.delete(); bpy.ops.mesh.primitive_cube_add(scale=(0.01, 0.02, 0.04)); "
      "bpy.ops.export_scene.fbx(filepath=\"" +
      folder + "/box.fbx\", use_selection=True)'");
  INFO(answer.output << answer.errors);
  REQUIRE(answer.status == 0);
  const auto file = modeling::loadMesh(folder, {"box.fbx"});
  REQUIRE(file.ok());
  CHECK(file->mesh.closed());
  CHECK((file->mesh.box().diagonal() - Vec3(2.0, 4.0, 8.0)).norm() < 1e-4);
  const std::string sound = textOf(folder + "/box.fbx");
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    std::ofstream(folder + "/box.fbx", std::ios::binary) << tests::damaged(sound, seed);
    const auto damaged = modeling::loadMesh(folder, {"box.fbx"});
    if (!damaged.ok()) CHECK_THAT(damaged.problem().line(), Catch::Contains("box.fbx"));
  }
}

}  // namespace
