#include "modeling/exchange/export.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include <Eigen/Geometry>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/surface/surface_mesh.h"
#include "tests/support/change_broken.h"
#include "tests/support/grid_network.h"
#include "tests/support/memory_take.h"

namespace {

using modeling::ExportRequest;
using sim::Vec3;
using tests::MemoryTake;

/// Three frames of a bar whose middle is broken from the second on, shaken so that no number is round.
MemoryTake breakingBar() {
  const sim::Network network = tests::gridNetwork(4, 2, 2);
  std::vector<sim::Snapshot> frames;
  for (std::uint64_t number = 0; number < 3; ++number) {
    sim::Snapshot frame = sim::momentAtRest(network);
    frame.time = static_cast<double>(number) / 7.0;
    frame.stepCount = 100 * number;
    for (std::size_t node = 0; node < network.nodeCount(); ++node) {
      for (int axis = 0; axis < 3; ++axis) {
        frame.positions[node][axis] +=
            0.1 * sim::uniformAt(number, 6 * node + static_cast<std::uint64_t>(axis));
        frame.velocities[node][axis] =
            1e-9 * sim::normalAt(number + 10, 3 * node + static_cast<std::uint64_t>(axis));
      }
    }
    if (number > 0) {
      tests::breakBetween(network, 1.5, frame);
      tests::changeBroken(frame, [&](sim::Broken& broken) {
        for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node)
          broken.fragmentOfNode[node] = network.positions[node].x() < 1.5 ? 3 : 5;
      });
    }
    frames.push_back(std::move(frame));
  }
  return {network, std::move(frames)};
}

/// A folder that goes when the test does.
struct Scratch {
  std::filesystem::path folder;
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "smithereens-export-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    folder = name;
  }
  ~Scratch() { std::filesystem::remove_all(folder); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
};

std::vector<std::string> linesOf(const std::filesystem::path& path) {
  std::ifstream stream(path);
  REQUIRE(stream);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST_CASE("extended XYZ reads back to the same numbers, in network order") {
  const MemoryTake take = breakingBar();
  const Scratch scratch;
  const auto path = scratch.folder / "bar.xyz";
  REQUIRE(modeling::writeXyz(take, {.path = path, .firstFrame = 0, .lastFrame = 2, .progress = {}}).ok());
  const auto lines = linesOf(path);
  const std::size_t count = take.network().nodeCount();
  REQUIRE(lines.size() == 3 * (count + 2));
  for (std::size_t index = 0; index < 3; ++index) {
    const sim::Snapshot& frame = **take.frame(index);
    const std::size_t first = index * (count + 2);
    CHECK(lines[first] == std::to_string(count));
    const auto comment = wordsOf(lines[first + 1]);
    REQUIRE(comment.size() == 7);
    CHECK(comment[0] == "Properties=species:S:1:pos:R:3:velo:R:3:fragment:I:1:material:I:1:masses:R:1");
    CHECK(comment[3] == "materials=\"test\"");
    CHECK(std::strtod(comment[1].substr(5).c_str(), nullptr) == frame.time);
    CHECK(comment[2] == "Step=" + std::to_string(frame.stepCount));
    for (std::size_t node = 0; node < count; ++node) {
      const auto words = wordsOf(lines[first + 2 + node]);
      REQUIRE(words.size() == 10);
      CHECK(words[0] == "H");
      CHECK(words[8] == "0");
      CHECK(std::strtod(words[9].c_str(), nullptr) == take.network().masses[node]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<Eigen::Index>(axis);
        CHECK(std::strtod(words[1 + axis].c_str(), nullptr) == frame.positions[node][a]);
        CHECK(std::strtod(words[4 + axis].c_str(), nullptr) == frame.velocities[node][a]);
      }
      CHECK(words[7] == std::to_string(frame.broken->fragmentOfNode[node]));
    }
  }
}

/// What a plain reader makes of an OBJ file.
struct PlainObj {
  std::vector<Vec3> points, normals;
  std::size_t faces = 0;
  std::set<std::string> groups, materials;
  double volume = 0.0;  ///< enclosed, by fans of triangles

  explicit PlainObj(const std::filesystem::path& path) {
    for (const std::string& line : linesOf(path)) {
      const auto words = wordsOf(line);
      if (words[0] == "v" || words[0] == "vn") {
        (words[0] == "v" ? points : normals)
            .emplace_back(std::stod(words[1]), std::stod(words[2]), std::stod(words[3]));
      }
      if (words[0] == "g") groups.insert(words[1]);
      if (words[0] == "usemtl") materials.insert(words[1]);
      if (words[0] == "f") addFace(words);
    }
  }

  void addFace(const std::vector<std::string>& words) {
    ++faces;
    std::vector<Vec3> corners;
    for (std::size_t c = 1; c < words.size(); ++c) {
      const std::size_t slash = words[c].find("//");
      REQUIRE(slash != std::string::npos);
      corners.push_back(points.at(std::stoul(words[c].substr(0, slash)) - 1));
      CHECK(std::abs(normals.at(std::stoul(words[c].substr(slash + 2)) - 1).norm() - 1.0) < 1e-8);
    }
    for (std::size_t c = 2; c < corners.size(); ++c) {
      volume += corners[0].dot(corners[c - 1].cross(corners[c])) / 6.0;
    }
  }
};

TEST_CASE("an OBJ a frame holds the surface in groups of fragments, outside and inside apart") {
  const MemoryTake take = breakingBar();
  const Scratch scratch;
  const auto path = scratch.folder / "bar.obj";
  REQUIRE(modeling::writeObj(take, {.path = path, .firstFrame = 0, .lastFrame = 2, .progress = {}}).ok());
  CHECK_FALSE(std::filesystem::exists(path));

  const PlainObj whole(scratch.folder / "bar.0000.obj");
  CHECK(whole.faces == 2 * (4 * 2 + 4 * 2 + 2 * 2));
  // A point is there once a normal, of which there are three at corners, two at edges.
  CHECK(whole.points.size() == whole.normals.size());
  CHECK(whole.points.size() == 8 * 3 + 4 * (1 + 1 + 3) * 2 + (1 * 1 + 1 * 3 + 1 * 3) * 2);
  CHECK(whole.groups == std::set<std::string>{"fragment_0"});
  CHECK(whole.materials == std::set<std::string>{"test_outside"});

  const PlainObj broken(scratch.folder / "bar.0002.obj");
  const sim::SurfaceMesh mesh = sim::SurfaceBuilder(take.network()).build(**take.frame(2));
  CHECK(broken.faces == mesh.faces.size());
  CHECK(broken.groups == std::set<std::string>{"fragment_3", "fragment_5"});
  CHECK(broken.materials == std::set<std::string>{"test_inside", "test_outside"});
  CHECK(broken.points.size() == broken.normals.size());
  for (const Vec3& point : mesh.points) {
    CHECK(std::any_of(broken.points.begin(), broken.points.end(),
                      [&](const Vec3& written) { return (written - point).norm() < 1e-7; }));
  }
  // Sixteen cells of about one cubic centimetre, with corners moved by up to 0.1.
  CHECK(broken.volume == Approx(16.0).epsilon(0.1));

  const auto library = linesOf(scratch.folder / "bar.0002.obj.mtl");
  CHECK(std::count(library.begin(), library.end(), "newmtl test_outside") == 1);
  CHECK(std::count(library.begin(), library.end(), "newmtl test_inside") == 1);
}

TEST_CASE("a single frame goes into the file as named") {
  const Scratch scratch;
  const auto path = scratch.folder / "one.obj";
  REQUIRE(modeling::writeObj(breakingBar(), {.path = path, .firstFrame = 1, .lastFrame = 1, .progress = {}})
              .ok());
  CHECK(PlainObj(path).groups.size() == 2);
}

TEST_CASE("another program's reader finds the same faces, normals and materials") {
  const Scratch scratch;
  const auto path = scratch.folder / "one.obj";
  REQUIRE(modeling::writeObj(breakingBar(), {.path = path, .firstFrame = 2, .lastFrame = 2, .progress = {}})
              .ok());
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path.string(), aiProcess_ValidateDataStructure);
  REQUIRE(scene != nullptr);
  std::size_t faces = 0;
  std::set<std::string> materials;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh* mesh = scene->mMeshes[m];
    faces += mesh->mNumFaces;
    REQUIRE(mesh->HasNormals());
    materials.insert(scene->mMaterials[mesh->mMaterialIndex]->GetName().C_Str());
  }
  CHECK(faces == PlainObj(path).faces);
  CHECK(materials == std::set<std::string>{"test_inside", "test_outside"});
}

TEST_CASE("what cannot be written is a problem that names the file, and leaves nothing") {
  const MemoryTake take = breakingBar();
  const auto path = std::filesystem::temp_directory_path() / "smithereens-no-such-folder" / "a.xyz";
  for (const auto& format : modeling::exportFormats()) {
    const auto status = format.write(take, {.path = path, .firstFrame = 0, .lastFrame = 0, .progress = {}});
    REQUIRE_FALSE(status.ok());
    CHECK(status.problem().place.find("smithereens-no-such-folder") != std::string::npos);
  }
}

TEST_CASE("each format makes the files that it says, which are of the kinds that it says") {
  const MemoryTake take = breakingBar();
  for (const auto& format : modeling::exportFormats()) {
    INFO(format.name);
    const Scratch scratch;
    const modeling::ExportRequest request{
        .path = scratch.folder / ("bar." + format.name), .firstFrame = 0, .lastFrame = 1, .progress = {}};
    REQUIRE(format.write(take, request).ok());
    std::set<std::filesystem::path> said, made;
    for (const modeling::PlannedFile& file : format.files(request)) {
      said.insert(file.path);
      CHECK(modeling::isOfKind(file.path, *file.kind));
      CHECK_FALSE(modeling::isOfKind(SMITHEREENS_SOURCE_DIR "/README.md", *file.kind));
    }
    for (const auto& entry : std::filesystem::directory_iterator(scratch.folder)) made.insert(entry.path());
    CHECK(said == made);
  }
}

TEST_CASE("a cancelled export leaves no half file") {
  const Scratch scratch;
  const auto path = scratch.folder / "bar.xyz";
  const auto cancel = [](double) { return false; };
  CHECK_FALSE(
      modeling::writeXyz(breakingBar(), {.path = path, .firstFrame = 0, .lastFrame = 2, .progress = cancel})
          .ok());
  CHECK(std::filesystem::is_empty(scratch.folder));
}

TEST_CASE("formats go by name, and an unknown name is told which there are") {
  CHECK(modeling::exportFormatNamed("xyz")->name == "xyz");
  const auto wrong = modeling::exportFormatNamed("objj");
  REQUIRE_FALSE(wrong.ok());
  CHECK(wrong.problem().remedy.find("obj") != std::string::npos);
}

TEST_CASE("frames are numbered with four digits or more before the ending") {
  CHECK(modeling::numberedPath("a/b.png", 7) == "a/b.0007.png");
  CHECK(modeling::numberedPath("a.b/c", 12) == "a.b/c.0012");
  CHECK(modeling::numberedPath("x.obj", 123456) == "x.123456.obj");
}

TEST_CASE("takes of the first layout give what they gave to the program that wrote them") {
  const std::string takes = SMITHEREENS_SOURCE_DIR "/tests/data/takes/";
  const auto take = sim::TakeReader::open(takes + "version-1.take");
  REQUIRE(take);
  REQUIRE((*take)->frameCount() == 9);
  CHECK((*take)->outcome() == "done");
  CHECK((*take)->checkpointFrames().size() == 2);
  const Scratch scratch;
  REQUIRE(modeling::writeXyz(**take, {scratch.folder / "last.xyz", 8, 8, {}}).ok());
  const auto text = [](const std::filesystem::path& file) {
    std::ifstream stream(file);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  // Where nodes are, how fast, and in which fragment; species were names of materials then.
  const auto numbersOf = [](const std::string& all) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream stream(all);
    for (std::string line; std::getline(stream, line);) {
      auto words = wordsOf(line);
      if (words.size() >= 8 && words[0].find('=') == std::string::npos)
        rows.emplace_back(words.begin() + 1, words.begin() + 8);
    }
    return rows;
  };
  const auto then = numbersOf(text(takes + "version-1.xyz"));
  REQUIRE(then.size() == (*take)->network().nodeCount());
  CHECK(numbersOf(text(scratch.folder / "last.xyz")) == then);
}

}  // namespace
