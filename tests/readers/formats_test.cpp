#include <map>
#include <sstream>

#include <catch2/catch.hpp>

#include "modeling/exchange/export.h"
#include "modeling/exchange/surface_vertices.h"
#include "tests/support/flying_pieces.h"
#include "tests/support/run_program.h"

/// What ASE, meshio and VTK make of our files, where they are installed.
namespace {

/// Debian's Python has the packages of Debian; another one may come first in the path.
const std::string kRead = "/usr/bin/python3 \"" SMITHEREENS_SOURCE_DIR "/tests/readers/read_formats.py\" ";

bool have(const std::string& reader) {
  if (tests::runCommand(kRead + "has-" + reader).status == 0) return true;
  WARN("Python's " << reader << " is not installed: what it makes of our files was not tested");
  return false;
}

std::map<std::string, double> read(const std::string& reader, const std::string& file) {
  const auto answer = tests::runCommand(kRead + reader + " \"" + file + "\"");
  INFO(reader << " " << file << "\n" << answer.errors);
  REQUIRE(answer.status == 0);
  std::map<std::string, double> said;
  std::istringstream stream(answer.output);
  std::string key;
  for (double value = 0.0; stream >> key >> value;) said[key] = value;
  return said;
}

/// Bonds without cells, as a network from a file has: there is no surface.
tests::MemoryTake withoutCells() {
  const tests::MemoryTake take = tests::flyingPieces(2, 2);
  sim::Network network = take.network();
  network.cells.clear();
  std::vector<sim::Snapshot> frames;
  for (std::size_t i = 0; i < 2; ++i) {
    sim::Snapshot frame = **take.frame(i);
    sim::Broken broken = *frame.broken;
    broken.cells.clear();
    frame.broken = sim::sealed(std::move(broken));
    frames.push_back(std::move(frame));
  }
  return {network, std::move(frames)};
}

struct Kind {
  const char* name;
  tests::MemoryTake take;
};

std::vector<Kind> kinds() {
  std::vector<Kind> all;
  all.push_back({"broken", tests::flyingPieces(4, 3)});
  all.push_back({"whole", tests::flyingPieces(1, 3)});
  return all;
}

TEST_CASE("ASE reads species, positions and velocities of all frames") {
  if (!have("ase")) return;
  const std::string folder = tests::freshFolder("smithereens-formats");
  for (const tests::MemoryTake& take : {tests::flyingPieces(4, 3), withoutCells()}) {
    const std::string file = folder + "/take.xyz";
    const std::size_t last = take.frameCount() - 1;
    REQUIRE(modeling::writeXyz(take, {.path = file, .lastFrame = last, .progress = {}}).ok());
    const auto said = read("ase", file);
    const sim::SnapshotPointer frame = *take.frame(last);
    CHECK(said.at("frames") == static_cast<double>(take.frameCount()));
    CHECK(said.at("points") == static_cast<double>(take.network().nodeCount()));
    CHECK(said.at("time") == frame->time);
    double sum = 0.0;
    for (const sim::Vec3& position : frame->positions) sum += position.sum();
    CHECK(said.at("sum") == Approx(sum));
  }
}

TEST_CASE("meshio and VTK read the same surface from OBJ, PLY and the OBJ of a point cache") {
  const bool meshio = have("meshio");
  const bool vtk = have("vtk");
  const std::string folder = tests::freshFolder("smithereens-formats");
  for (const auto& [name, take] : kinds()) {
    INFO(name);
    const std::string base = folder + "/" + name;
    REQUIRE(modeling::writeObj(take, {.path = base + ".obj", .lastFrame = 2, .progress = {}}).ok());
    REQUIRE(modeling::writePly(take, {.path = base + ".ply", .lastFrame = 2, .progress = {}}).ok());
    REQUIRE(modeling::writePc2(take, {.path = base + "-cache.pc2", .lastFrame = 2, .progress = {}}).ok());
    const sim::SurfaceMesh mesh = sim::SurfaceBuilder(take.network()).build(**take.frame(2));
    const auto vertices = static_cast<double>(modeling::verticesOf(mesh).vertices.size());
    const auto faces = static_cast<double>(mesh.faces.size());
    for (const std::string& file : {base + ".0002.obj", base + ".0002.ply", base + "-cache.obj"}) {
      INFO(file);
      if (meshio) {
        const auto said = read("meshio", file);
        CHECK(said.at("points") == vertices);
        CHECK(said.at("faces") == faces);
        if (file.ends_with(".ply")) CHECK(said.contains("has-fragment"));
      }
      // VTK's reader of OBJ gives each face points of its own.
      if (vtk) CHECK(read(file.ends_with(".ply") ? "vtk-ply" : "vtk-obj", file).at("faces") == faces);
    }
  }
}

TEST_CASE("VTK finds the materials of every frame of an OBJ sequence, and of a single one") {
  if (!have("vtk")) return;
  const tests::MemoryTake take = tests::flyingPieces(4, 3);
  const std::string folder = tests::freshFolder("smithereens-formats");
  REQUIRE(modeling::writeObj(take, {.path = folder + "/take.obj", .lastFrame = 2, .progress = {}}).ok());
  REQUIRE(
      modeling::writeObj(take, {.path = folder + "/one.obj", .firstFrame = 2, .lastFrame = 2, .progress = {}})
          .ok());
  for (const char* const name : {"take.0000.obj", "take.0002.obj", "one.obj"}) {
    INFO(name);
    const auto said = read("vtk-materials", folder + "/" + name);
    CHECK(said.at("errors") == 0.0);
    CHECK(said.at("actors") > 0.0);
    if (std::string_view(name) != "take.0000.obj") CHECK(said.at("colours") == 2.0);
  }
}

TEST_CASE("a network without cells has an empty surface that readers take as such") {
  const std::string folder = tests::freshFolder("smithereens-formats");
  const tests::MemoryTake take = withoutCells();
  REQUIRE(modeling::writeObj(take, {.path = folder + "/net.obj", .progress = {}}).ok());
  REQUIRE(modeling::writePly(take, {.path = folder + "/net.ply", .progress = {}}).ok());
  for (const char* const ending : {"obj", "ply"}) {
    INFO(ending);
    if (have("meshio")) CHECK(read("meshio", folder + "/net." + ending).at("faces") == 0.0);
    if (have("vtk")) CHECK(read(std::string("vtk-") + ending, folder + "/net." + ending).at("faces") == 0.0);
  }
}

}  // namespace
