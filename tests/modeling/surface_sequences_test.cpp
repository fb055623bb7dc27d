#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

#include <Eigen/Geometry>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <catch2/catch.hpp>

#include "modeling/exchange/export.h"
#include "modeling/exchange/surface_vertices.h"
#include "sim/surface/level_surface.h"
#include "tests/sim/take_sample.h"
#include "tests/support/change_broken.h"
#include "tests/support/flying_pieces.h"
#include "tests/support/point_sets.h"

/// Formats that hold a take's deforming surface, or its fragments as numbers.
namespace {

using sim::Vec3;

std::vector<Vec3> pointsOf(const aiScene& scene) {
  std::vector<Vec3> points;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    for (unsigned v = 0; v < scene.mMeshes[m]->mNumVertices; ++v) {
      const aiVector3D& at = scene.mMeshes[m]->mVertices[v];
      points.emplace_back(static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z));
    }
  }
  return points;
}

TEST_CASE("another program reads the surface of every frame from PLY files and OBJ files") {
  const tests::MemoryTake take = tests::flyingPieces(3, 4);
  const tests::ScratchFolder scratch;
  const std::string ending = GENERATE(".ply", ".obj");
  const auto path = scratch.file("pieces" + ending);
  const bool level = GENERATE(false, true);
  const modeling::ExportRequest request{.path = path, .lastFrame = 3, .progress = {}, .levelSurface = level};
  REQUIRE((ending == ".ply" ? modeling::writePly : modeling::writeObj)(take, request).ok());
  for (std::size_t frame = 0; frame < 4; ++frame) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(modeling::numberedPath(path, frame).string(), 0);
    INFO(importer.GetErrorString());
    REQUIRE(scene != nullptr);
    const sim::SnapshotPointer kept = *take.frame(frame);
    const sim::Snapshot& moment = *kept;
    const sim::SurfaceMesh mesh = level ? sim::levelSurfaceOf(take.network(), moment, {})
                                        : sim::SurfaceBuilder(take.network()).build(moment);
    CHECK(tests::apart(mesh.points, pointsOf(*scene)) < 1e-5);
    unsigned faces = 0;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
      faces += scene->mMeshes[m]->mNumFaces;
      CHECK(scene->mMeshes[m]->HasNormals());
    }
    CHECK(faces == mesh.faces.size());
  }
}

/// Pieces of which one has lost a node.
tests::MemoryTake withCrumb() {
  const tests::MemoryTake take = tests::flyingPieces(2, 2);
  const sim::Network& network = take.network();
  sim::Snapshot moment = **take.frame(1);
  sim::Broken broken = *moment.broken;
  const auto crumb = static_cast<sim::NodeIndex>(network.nodeCount() - 1);
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond)
      if (a == crumb || network.bondEnds[bond] == crumb) broken.bonds[bond] = 1;
  }
  for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    const sim::CellCorners& corners = network.cells[cell];
    if (std::find(corners.begin(), corners.end(), crumb) != corners.end()) broken.cells[cell] = 1;
  }
  broken.fragmentOfNode[crumb] = 7;
  broken.fragments.push_back({.id = 7, .parent = 1, .nodeCount = 1, .mass = 1.0});
  moment.broken = sim::sealed(std::move(broken));
  moment.fragments.push_back({.id = 7});
  return {network, {moment}};
}

TEST_CASE("a crumb is exported as what is asked for") {
  const tests::MemoryTake take = withCrumb();
  const tests::ScratchFolder scratch;
  const auto kind = GENERATE(sim::LooseNodes::shards, sim::LooseNodes::tetrahedra, sim::LooseNodes::spheres,
                             sim::LooseNodes::givenToNeighbours);
  const sim::SurfaceMesh mesh = sim::SurfaceBuilder(take.network(), kind).build(**take.frame(0));
  const bool has =
      std::any_of(mesh.faces.begin(), mesh.faces.end(), [](const auto& face) { return face.fragment == 7; });
  CHECK(has == (kind != sim::LooseNodes::givenToNeighbours));
  for (const auto write : {modeling::writePly, modeling::writeObj, modeling::writePc2, modeling::writeGlb}) {
    const bool glb = write == modeling::writeGlb;
    const std::string ending = glb ? ".glb" : write == modeling::writePly ? ".ply" : ".obj";
    const auto path = scratch.file("crumb" + (write == modeling::writePc2 ? ".pc2" : ending));
    REQUIRE(write(take, {.path = path, .progress = {}, .looseNodes = kind}).ok());
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(scratch.file("crumb" + ending).string(), 0);
    REQUIRE(scene != nullptr);
    unsigned faces = 0;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) faces += scene->mMeshes[m]->mNumFaces;
    // Faces of a glTF are triangles, of which others may have four corners.
    CHECK((glb ? faces >= mesh.faces.size() : faces == mesh.faces.size()));
    if (!glb) continue;
    const aiNode* node = scene->mRootNode->FindNode("fragment_7");
    CHECK((node != nullptr && node->mNumMeshes > 0) == has);
    CHECK((node == nullptr) == (kind == sim::LooseNodes::givenToNeighbours));
  }
}

std::vector<char> bytesOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  REQUIRE(stream);
  return {std::istreambuf_iterator<char>(stream), {}};
}

template <class Number>
Number numberAt(const std::vector<char>& bytes, std::size_t offset) {
  REQUIRE(offset + sizeof(Number) <= bytes.size());
  Number number;
  std::memcpy(&number, bytes.data() + offset, sizeof(Number));
  return number;
}

TEST_CASE("a point cache moves the points of its OBJ through all frames, with all breaks from the start") {
  const tests::MemoryTake take = tests::flyingPieces(3, 4);
  const tests::ScratchFolder scratch;
  REQUIRE(
      modeling::writePc2(take, {.path = scratch.file("pieces.pc2"), .lastFrame = 3, .progress = {}}).ok());
  const auto bytes = bytesOf(scratch.file("pieces.pc2"));
  REQUIRE(std::string(bytes.data(), 11) == "POINTCACHE2");
  const auto points = static_cast<std::size_t>(numberAt<std::int32_t>(bytes, 16));
  CHECK(numberAt<std::int32_t>(bytes, 28) == 4);
  REQUIRE(bytes.size() == 32 + 4 * points * 12);
  std::ifstream object(scratch.file("pieces.obj"));
  std::size_t vertices = 0;
  for (std::string line; std::getline(object, line);) vertices += line.starts_with("v ") ? 1 : 0;
  CHECK(vertices == points);
  for (std::size_t frame = 0; frame < 4; ++frame) {
    const sim::SurfaceMesh mesh = tests::surfaceOfPieces(take, frame);
    const auto corners = modeling::verticesOf(mesh).vertices;
    REQUIRE(corners.size() == points);
    for (std::size_t point = 0; point < points; ++point) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float read = numberAt<float>(bytes, 32 + 12 * (frame * points + point) + 4 * axis);
        CHECK(static_cast<double>(read) ==
              Approx(mesh.points[corners[point].point][static_cast<Eigen::Index>(axis)]).margin(1e-5));
      }
    }
  }
}

using Table = std::vector<std::map<std::string, std::string>>;

Table tableOf(const std::filesystem::path& path) {
  std::ifstream stream(path);
  REQUIRE(stream);
  const auto cut = [](const std::string& line) {
    std::vector<std::string> cells{""};
    for (const char letter : line) {
      if (letter == ',')
        cells.emplace_back();
      else
        cells.back() += letter;
    }
    return cells;
  };
  std::string line;
  std::getline(stream, line);
  const auto head = cut(line);
  Table table;
  while (std::getline(stream, line)) {
    const auto cells = cut(line);
    REQUIRE(cells.size() == head.size());
    auto& row = table.emplace_back();
    for (std::size_t i = 0; i < head.size(); ++i) row[head[i]] = cells[i];
  }
  return table;
}

TEST_CASE("tables say where each fragment is, how it is turned and how it moves") {
  // Pieces spin steadily, so their velocities follow from any two frames.
  tests::MemoryTake take = tests::flyingPieces(3, 6);
  const tests::ScratchFolder scratch;
  REQUIRE(modeling::writeCsv(take, {.path = scratch.file("t.csv"), .lastFrame = 5, .progress = {}}).ok());
  const Table rows = tableOf(scratch.file("t.csv"));
  REQUIRE(rows.size() == 1 + 5 * 3);
  CHECK(tableOf(scratch.file("t.ledger.csv")).size() == 6);
  CHECK(tableOf(scratch.file("t.events.csv")).empty());
  const auto turn = [&](std::size_t row) {
    const auto number = [&](const char* key) { return std::stod(rows[row].at(key)); };
    return Eigen::Quaterniond(number("qw"), number("qx"), number("qy"), number("qz"));
  };
  for (std::size_t piece = 0; piece < 3; ++piece) {
    const auto first = turn(1 + piece);
    const auto second = turn(4 + piece);
    CHECK(first.angularDistance(second) == Approx(second.angularDistance(turn(7 + piece))).margin(1e-6));
    CHECK(rows[1 + piece].at("parent") == (piece == 0 ? "" : "0"));
    CHECK(rows[1 + piece].at("nodes") == "8");
  }
  CHECK(turn(1).angularDistance(Eigen::Quaterniond::Identity()) < 1e-6);
  CHECK(turn(2).angularDistance(Eigen::Quaterniond::Identity()) > 1e-3);
}

TEST_CASE("angular velocities are those of the momentum that the nodes carry") {
  const sim::Network network = tests::flyingPieces(1, 1).network();
  sim::Snapshot frame = sim::momentAtRest(network);
  const Vec3 spin(1.0, -2.0, 3.0);
  for (std::size_t node = 0; node < network.nodeCount(); ++node)
    frame.velocities[node] = Vec3(5.0, 6.0, 7.0) + spin.cross(network.positions[node]);
  tests::changeBroken(
      frame, [](sim::Broken& broken) { broken.fragments = {{.id = 0, .nodeCount = 8, .mass = 8.0}}; });
  frame.fragments = {{.id = 0}};
  const tests::MemoryTake take(network, {frame});
  const tests::ScratchFolder scratch;
  REQUIRE(modeling::writeCsv(take, {.path = scratch.file("t.csv"), .progress = {}}).ok());
  const Table rows = tableOf(scratch.file("t.csv"));
  REQUIRE(rows.size() == 1);
  CHECK(std::stod(rows[0].at("wx_rad_per_s")) == Approx(spin.x()));
  CHECK(std::stod(rows[0].at("wy_rad_per_s")) == Approx(spin.y()));
  CHECK(std::stod(rows[0].at("wz_rad_per_s")) == Approx(spin.z()));
}

}  // namespace
