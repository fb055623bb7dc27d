#include "modeling/shapes/mesh_lattice.h"

#include <catch2/catch.hpp>

#include "modeling/shapes/mesh_cells.h"
#include "modeling/shapes/quality.h"
#include "tests/modeling/lattice_checks.h"
#include "tests/support/meshes.h"

/// Closed meshes filled with cells.
namespace {

using modeling::MeshFit;
using sim::TriangleMesh;
using sim::Vec3;

/// The mesh turned and shifted, so that nothing rests on the grid.
TriangleMesh turned(const TriangleMesh& mesh) {
  const Eigen::Isometry3d moved =
      Eigen::Translation3d(0.13, -0.21, 0.37) * Eigen::AngleAxisd(0.5, Vec3(1.0, 2.0, -1.0).normalized());
  std::vector<Vec3> points;
  for (const Vec3& point : mesh.points()) points.emplace_back(moved * point);
  return {points, mesh.triangles()};
}

TEST_CASE("a ball is filled by cells that end on it: no staircase, no bad cell, its volume") {
  const TriangleMesh ball = tests::ballMesh(2.0, 32);
  const double cellSize = GENERATE(0.5, 0.25);
  MeshFit fit;
  const auto lattice = modeling::fillMesh(ball, cellSize, fit);
  REQUIRE(lattice.ok());
  CHECK(tests::brokenLatticeRule(*lattice).value_or("") == "");
  const auto quality = modeling::measure(*lattice);
  CHECK(quality.minScaledJacobian >= 0.11);
  CHECK(quality.meanScaledJacobian > 0.5);
  CHECK(fit.farthest < 0.16 * cellSize);
  CHECK(fit.volumeShare == Approx(1.0).margin(0.03));
}

TEST_CASE("a box that fits the grid is filled by cubes, to its edges and corners") {
  MeshFit fit;
  const auto lattice = modeling::fillMesh(tests::boxMesh(Vec3(1.0, 2.0, 1.5)), 0.5, fit);
  REQUIRE(lattice.ok());
  CHECK(lattice->cells.size() == 4 * 8 * 6);
  CHECK(modeling::measure(*lattice).minScaledJacobian == Approx(1.0));
  CHECK(fit.volumeShare == Approx(1.0));
  CHECK(fit.farthest < 1e-12);
}

TEST_CASE("a box askew keeps its edges and corners as far as cells allow") {
  const TriangleMesh box = turned(tests::boxMesh(Vec3(1.0, 2.0, 1.5)));
  MeshFit fit;
  const auto lattice = modeling::fillMesh(box, 0.25, fit);
  REQUIRE(lattice.ok());
  CHECK(tests::brokenLatticeRule(*lattice).value_or("") == "");
  CHECK(modeling::measure(*lattice).minScaledJacobian >= 0.11);
  CHECK(fit.farthest < 0.3 * 0.25);
  CHECK(fit.volumeShare == Approx(1.0).margin(0.02));
}

TEST_CASE("wherever a mesh is, the surface of its cells is one sheet") {
  // Two balls that touch in a point: half-filled cells would meet by an edge or a corner there.
  for (const double apart : {1.9, 2.0, 2.05}) {
    auto points = tests::ballMesh(1.0, 12).points();
    auto triangles = tests::ballMesh(1.0, 12).triangles();
    const auto count = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < count; ++i)
      points.emplace_back(points[i] + apart * Vec3(1.0, 1.0, 1.0).normalized());
    const auto ball = triangles;
    for (const auto& t : ball) triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
    MeshFit fit;
    const auto lattice = modeling::fillMesh({points, triangles}, 0.3, fit);
    REQUIRE(lattice.ok());
    CHECK(tests::brokenLatticeRule(*lattice).value_or("") == "");
  }
}

TEST_CASE("closed bodies stuck into each other are filled as one, and it is told where they cross") {
  const TriangleMesh box = tests::boxMesh(Vec3(1.0, 1.0, 1.0));
  std::vector<Vec3> points = box.points();
  std::vector<TriangleMesh::Triangle> triangles = box.triangles();
  const auto first = static_cast<std::uint32_t>(points.size());
  for (const Vec3& point : box.points()) points.emplace_back(0.5 * point + Vec3(1.0, 0.13, 0.09));
  for (TriangleMesh::Triangle triangle : box.triangles()) {
    for (std::uint32_t& corner : triangle) corner += first;
    triangles.push_back(triangle);
  }
  const TriangleMesh both(points, triangles);
  REQUIRE(both.closed());
  CHECK(sim::crossingsOf(box).triangles == 0);
  CHECK(sim::crossingsOf(tests::ballMesh(2.0, 32)).triangles == 0);
  const auto crossings = sim::crossingsOf(both);
  // The two of the larger box's side, and of the smaller's four sides both.
  CHECK(crossings.triangles == 10);
  CHECK(crossings.first.x() == Approx(1.0));
  CHECK(std::max(std::abs(crossings.first.y() - 0.13), std::abs(crossings.first.z() - 0.09)) == Approx(0.5));
  MeshFit fit;
  const auto lattice = modeling::fillMesh(both, 0.125, fit);
  REQUIRE(lattice.ok());
  CHECK(fit.crossings.triangles == 10);
  // The half of the smaller that is in the larger counts once.
  CHECK(modeling::measure(*lattice).volume == Approx(8.0 + 0.5).epsilon(0.02));
}

TEST_CASE("what is not closed is refused with where, why and what to do") {
  auto triangles = tests::boxMesh(Vec3::Ones()).triangles();
  triangles.pop_back();
  MeshFit fit;
  const auto holed = modeling::fillMesh({tests::boxMesh(Vec3::Ones()).points(), triangles}, 0.5, fit);
  REQUIRE_FALSE(holed.ok());
  CHECK_THAT(holed.problem().what, Catch::Contains("3 edges of one face only") && Catch::Contains("near ("));
  CHECK_THAT(holed.problem().remedy, Catch::Contains("holes"));
}

TEST_CASE("cells too large or too small for a mesh are refused") {
  MeshFit fit;
  const TriangleMesh plate = tests::boxMesh(Vec3(2.0, 2.0, 0.05));
  CHECK(modeling::fillMesh(plate, 1.0, fit).problem().place == "cellSize");
  CHECK(modeling::fillMesh(plate, 1e-4, fit).problem().place == "cellSize");
}

}  // namespace
