#include "modeling/import/mesh_file.h"

#include <fstream>
#include <sstream>

#include <assimp/Exporter.hpp>
#include <assimp/scene.h>
#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/read_obstacles.h"
#include "modeling/scene/scene_file.h"
#include "tests/fuzz/text_cuts.h"
#include "tests/sim/take_sample.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/meshes.h"

/// Meshes of other programs: written by assimp, read by us.
namespace {

using modeling::MeshSource;
using modeling::MeshUnit;
using modeling::MeshUp;
using sim::Vec3;

/// A scene of assimp's with one mesh.
std::unique_ptr<aiScene> sceneOf(const sim::TriangleMesh& mesh) {
  auto scene = std::make_unique<aiScene>();
  scene->mRootNode = new aiNode("root");
  scene->mNumMaterials = scene->mNumMeshes = scene->mRootNode->mNumMeshes = 1;
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  scene->mMeshes = new aiMesh* [1] { new aiMesh };
  scene->mRootNode->mMeshes = new unsigned[1]{0};
  aiMesh& made = *scene->mMeshes[0];
  made.mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  made.mNumVertices = static_cast<unsigned>(mesh.points().size());
  made.mVertices = new aiVector3D[made.mNumVertices];
  for (unsigned v = 0; v < made.mNumVertices; ++v) {
    const Vec3& point = mesh.points()[v];
    made.mVertices[v] = {static_cast<float>(point.x()), static_cast<float>(point.y()),
                         static_cast<float>(point.z())};
  }
  made.mNumFaces = static_cast<unsigned>(mesh.triangles().size());
  made.mFaces = new aiFace[made.mNumFaces];
  for (unsigned f = 0; f < made.mNumFaces; ++f) {
    const auto& triangle = mesh.triangles()[f];
    made.mFaces[f].mNumIndices = 3;
    made.mFaces[f].mIndices = new unsigned[3]{triangle[0], triangle[1], triangle[2]};
  }
  return scene;
}

struct Format {
  const char* id;
  const char* file;
};
/// FBX is tested with Blender's (readers/blender_test.cpp): what assimp writes of it, assimp does not read.
constexpr std::array<Format, 5> kFormats{{{"obj", "box.obj"},
                                          {"ply", "box.ply"},
                                          {"stl", "box.stl"},
                                          {"glb2", "box.glb"},
                                          {"collada", "box.dae"}}};

void write(const sim::TriangleMesh& mesh, const Format& format, const tests::ScratchFolder& scratch) {
  const auto scene = sceneOf(mesh);
  Assimp::Exporter exporter;
  REQUIRE(exporter.Export(scene.get(), format.id, scratch.file(format.file).string()) == aiReturn_SUCCESS);
}

std::filesystem::path folderOf(const tests::ScratchFolder& scratch) {
  return scratch.file("x").parent_path();
}

TEST_CASE("a box comes back from every format as large as it was, closed, and right side out") {
  const Vec3 halfSize(1.0, 2.0, 4.0);
  for (const Format& format : kFormats) {
    INFO(format.id);
    const tests::ScratchFolder scratch;
    write(tests::boxMesh(halfSize), format, scratch);
    const auto file = modeling::loadMesh(folderOf(scratch), {format.file, MeshUnit::centimetre, MeshUp::z});
    REQUIRE(file.ok());
    CHECK(file->mesh.closed());
    CHECK(file->mesh.triangles().size() == 12);
    CHECK(file->mesh.points().size() == 8);
    CHECK(file->mesh.volume() == Approx(64.0).epsilon(1e-5));
    // assimp's Collada is y up and turned back by none.
    Vec3 size = file->mesh.box().diagonal();
    std::sort(size.data(), size.data() + 3);
    CHECK((size - 2.0 * halfSize).norm() < 1e-5);
  }
}

TEST_CASE("units are as stated, as the format says, or guessed by the size of dishware, and told") {
  const tests::ScratchFolder scratch;
  write(tests::boxMesh(Vec3(30.0, 40.0, 50.0)), kFormats[2], scratch);
  const auto sized = [&](MeshUnit unit, MeshUp up) {
    return modeling::loadMesh(folderOf(scratch), {"box.stl", unit, up});
  };
  const auto guessed = sized(MeshUnit::guess, MeshUp::guess);
  REQUIRE(guessed.ok());
  CHECK((guessed->mesh.box().diagonal() - Vec3(6.0, 8.0, 10.0)).norm() < 1e-5);
  CHECK_THAT(guessed->remark, Catch::Contains("millimetres by a guess") && Catch::Contains("6 x 8 x 10 cm"));
  CHECK((sized(MeshUnit::inch, MeshUp::z)->mesh.box().diagonal() - 2.54 * Vec3(60.0, 80.0, 100.0)).norm() <
        1e-3);
  CHECK((sized(MeshUnit::centimetre, MeshUp::y)->mesh.box().diagonal() - Vec3(60.0, 100.0, 80.0)).norm() <
        1e-4);

  write(tests::boxMesh(Vec3(0.03, 0.04, 0.05)), kFormats[3], scratch);
  const auto metres = modeling::loadMesh(folderOf(scratch), {"box.glb", MeshUnit::guess, MeshUp::guess});
  REQUIRE(metres.ok());
  CHECK((metres->mesh.box().diagonal() - Vec3(6.0, 10.0, 8.0)).norm() < 1e-4);
}

TEST_CASE("a mesh that is inside out is turned, and told") {
  const tests::ScratchFolder scratch;
  const sim::TriangleMesh box = tests::boxMesh(Vec3::Constant(4.0));
  auto triangles = box.triangles();
  for (auto& triangle : triangles) std::swap(triangle[0], triangle[1]);
  write({box.points(), triangles}, kFormats[1], scratch);
  const auto file = modeling::loadMesh(folderOf(scratch), {"box.ply", MeshUnit::guess, MeshUp::guess});
  REQUIRE(file.ok());
  CHECK(file->mesh.volume() == Approx(512.0));
  CHECK_THAT(file->remark, Catch::Contains("inside out"));
}

TEST_CASE("what is no mesh is a problem that names the file") {
  const tests::ScratchFolder scratch;
  const auto lineOf = [&](const std::string& name, const std::string& text) {
    if (!text.empty()) std::ofstream(scratch.file(name)) << text;
    const auto file = modeling::loadMesh(folderOf(scratch), {name, MeshUnit::guess, MeshUp::guess});
    REQUIRE_FALSE(file.ok());
    CHECK_THAT(file.problem().what, Catch::Contains(name + ": "));
    return file.problem().line();
  };
  CHECK_THAT(lineOf("absent.obj", ""), Catch::Contains("cannot read this file"));
  CHECK_THAT(lineOf("picture.png", "x"), Catch::Contains("no format"));
  CHECK_THAT(lineOf("words.obj", "these are words\n"), Catch::Contains("no OBJ"));
  CHECK_THAT(lineOf("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), Catch::Contains("no faces"));
  CHECK_THAT(lineOf("far.obj", "v 0 0 0\nv 1e30 0 0\nv 0 1 0\nf 1 2 3\n"), Catch::Contains("ten kilometres"));
}

std::string textOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_CASE("a damaged mesh is a problem or a mesh, never a crash, whatever the reader does") {
  const tests::ScratchFolder scratch;
  const sim::TriangleMesh ball = tests::ballMesh(4.0, 5);
  for (const Format& format : kFormats) {
    write(ball, format, scratch);
    const std::string sound = textOf(scratch.file(format.file));
    int problems = 0;
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
      std::ofstream(scratch.file(format.file), std::ios::binary) << tests::damaged(sound, seed);
      const auto file = modeling::loadMesh(folderOf(scratch), {format.file, MeshUnit::guess, MeshUp::guess});
      if (file.ok()) {
        CHECK(file->mesh.box().diagonal().allFinite());
        continue;
      }
      ++problems;
      CHECK_THAT(file.problem().what, Catch::Contains(std::string(format.file) + ": "));
      CHECK(file.problem().line().size() < 600);
    }
    INFO(format.id);
    CHECK(problems > 0);
  }
}

TEST_CASE("a scene takes a mesh as an obstacle with it, so that it is the same without the file") {
  std::optional<tests::ScratchFolder> scratch(std::in_place);
  write(tests::boxMesh(Vec3(3.0, 4.0, 5.0)), kFormats[1], *scratch);
  const std::string text =
      R"({"smithereens": 1, "materials": {"m": {}}, "parts": [{"name": "a", "kind": "slab",
    "material": "m", "size": [1, 1, 1]}], "environment": {"colliders": [{"name": "b", "kind": "mesh",
    "file": "box.ply"}]}})";
  const auto file = modeling::parseScene(text, "scene");
  REQUIRE(file.ok());
  const auto built = modeling::build(file->scene, folderOf(*scratch));
  REQUIRE(built.ok());
  const auto& solid = std::get<sim::SurfaceShape>(built->conditions.environment.colliders[0].shape);
  REQUIRE(solid.mesh);
  CHECK(solid.mesh->volume() == Approx(480.0));
  CHECK(solid.halfThickness == 0.0);
  CHECK(built->scene == file->scene);

  // A run that goes on by a scene that only names the file goes on with the surface it has.
  modeling::Scene unread = file->scene;
  REQUIRE(modeling::takeOverSurfaces(built->scene, unread).ok());
  CHECK(std::get<modeling::MeshObstacle>(unread.environment.colliders[0].form).surface.mesh == solid.mesh);
  std::get<modeling::MeshObstacle>(unread.environment.colliders[0].form) = {.file = "another.ply",
                                                                            .surface = {}};
  CHECK_FALSE(modeling::takeOverSurfaces(built->scene, unread).ok());

  scratch.reset();
  const auto again = modeling::parseScene(modeling::writeScene(built->scene), "written");
  REQUIRE(again.ok());
  const auto rebuilt = modeling::build(again->scene, "/nowhere");
  REQUIRE(rebuilt.ok());
  CHECK(rebuilt->conditions.environment.colliders[0].shape == sim::ColliderShape(solid));
}

TEST_CASE("a scene's mesh becomes a part, and one with a hole is refused by its place in the scene") {
  const tests::ScratchFolder scratch;
  write(tests::ballMesh(3.0, 12), kFormats[0], scratch);
  const auto sceneWith = [&](const std::string& name) {
    return modeling::parseScene(
               R"({"smithereens": 1, "materials": {"m": {}}, "parts": [{"name": "a", "kind": "mesh",
      "material": "m", "file": ")" +
                   name + R"(", "cellSize": 0.75}]})",
               "scene")
        ->scene;
  };
  const auto built = modeling::build(sceneWith("box.obj"), folderOf(scratch));
  REQUIRE(built.ok());
  CHECK(built->network.cellCount() > 100);
  CHECK_FALSE(built->network.validate().has_value());
  REQUIRE(built->warnings.size() >= 2);
  CHECK_THAT(built->warnings[1], Catch::Contains("per cent of the mesh's volume"));

  auto triangles = tests::ballMesh(3.0, 12).triangles();
  triangles.pop_back();
  write({tests::ballMesh(3.0, 12).points(), triangles}, kFormats[1], scratch);
  const auto holed = modeling::build(sceneWith("box.ply"), folderOf(scratch));
  REQUIRE_FALSE(holed.ok());
  CHECK(holed.problem().place == "parts[0].file");
  CHECK_THAT(holed.problem().what, Catch::Contains("not closed"));
}

TEST_CASE("what is wrong with a mesh is said where the scene names it, with its name") {
  const tests::ScratchFolder scratch;
  write(tests::ballMesh(3.0, 12), kFormats[0], scratch);
  std::ofstream(scratch.file("nan.obj")) << "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream(scratch.file("flat.obj")) << "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 1 1\nf 1 2 2\n";
  const auto lineOf = [&](const std::string& part, const std::string& obstacle) {
    const auto file = modeling::parseScene(R"({"smithereens": 1, "materials": {"m": {}},
"parts": [{"name": "a", "kind": "mesh", "material": "m",
"file": "box.obj"}, {"name": "b", "kind": "mesh", "material": "m",
"file": ")" + part + R"("}],
"environment": {"colliders": [{"name": "o", "kind": "mesh",
"file": ")" + obstacle + R"("}]}})",
                                           "table.scene.json");
    REQUIRE(file.ok());
    const auto built = modeling::build(file->scene, folderOf(scratch));
    REQUIRE_FALSE(built.ok());
    return file->located(built.problem()).line();
  };
  CHECK_THAT(lineOf("gone.obj", "box.obj"),
             Catch::Contains("table.scene.json:4:9: gone.obj: cannot read this file"));
  CHECK_THAT(lineOf("nan.obj", "box.obj"), Catch::Contains("table.scene.json:4:9: nan.obj: a corner"));
  CHECK_THAT(lineOf("../gone/parts", "box.obj"), Catch::Contains("table.scene.json:4:9: ../gone/parts: "));
  CHECK_THAT(lineOf("box.obj", "gone.obj"), Catch::Contains("table.scene.json:6:9: gone.obj: cannot"));
  CHECK_THAT(lineOf("box.obj", "flat.obj"),
             Catch::Contains("table.scene.json:6:9: flat.obj: ") && Catch::Contains("has an area"));
}

TEST_CASE("an obstacle whose triangles stand in the scene is refused like one of a file") {
  const auto problemOf = [](const std::string& surface) {
    const auto file =
        modeling::parseScene(R"({"smithereens": 1, "materials": {"m": {}}, "parts": [{"name": "a",
"kind": "slab", "material": "m", "size": [1, 1, 1]}], "environment": {"colliders": [{"name": "b", "kind": "mesh",
"surface": )" + surface + "}]}}",
                             "scene");
    return file.ok() ? std::string() : file.problem().line();
  };
  CHECK(problemOf(R"({"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2]]})").empty());
  CHECK_THAT(problemOf(R"({"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": []})"),
             Catch::Contains("scene:3:") && Catch::Contains("no triangles"));
  CHECK_THAT(
      problemOf(R"({"points": [[0, 0, 0], [1, 0, 0], [2, 0, 0]], "triangles": [[0, 1, 2], [0, 0, 1]]})"),
      Catch::Contains("scene:3:") && Catch::Contains("has an area"));
  CHECK_THAT(problemOf(R"({"points": [[0, 0, 0], [1e308, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2]]})"),
             Catch::Contains("scene:3:") && Catch::Contains("give a number from -1e+06 to 1e+06"));
}

TEST_CASE("bodies within and through each other are counted once, and no smaller cells are advised") {
  const tests::ScratchFolder scratch;
  const auto noteFor = [&](const sim::TriangleMesh& mesh) {
    std::ofstream(scratch.file("a.obj")) << tests::objText(mesh);
    const auto file =
        modeling::parseScene(R"({"smithereens": 1, "materials": {"m": {}}, "parts": [{"name": "a",
"kind": "mesh", "material": "m", "file": "a.obj", "cellSize": 0.5}]})",
                             "scene");
    const auto built = modeling::build(file->scene, folderOf(scratch));
    REQUIRE(built.ok());
    REQUIRE(built->warnings.size() >= 2);
    return built->warnings[0] + "\n" + built->warnings[1];
  };
  const sim::TriangleMesh box = tests::boxMesh(Vec3::Constant(4.0));
  const std::string nested = noteFor(tests::together(box, tests::boxMesh(Vec3::Constant(2.5))));
  CHECK_THAT(nested, Catch::Contains("lies within another") && Catch::Contains("100 per cent") &&
                         Catch::Contains("counted once") && !Catch::Contains("would hold more"));
  const std::string stuck = noteFor(tests::together(box, tests::moved(box, Vec3(3.0, 2.0, 1.0))));
  CHECK_THAT(stuck, Catch::Contains("passes through itself") && !Catch::Contains("would hold more") &&
                        !Catch::Contains("lies within"));
  const std::string hollow =
      noteFor(tests::together(box, tests::insideOut(tests::boxMesh(Vec3::Constant(2.5)))));
  CHECK_THAT(hollow, !Catch::Contains("within another") && !Catch::Contains("counted once"));
}

}  // namespace
