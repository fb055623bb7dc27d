#include "modeling/import/mesh_bodies.h"

#include <catch2/catch.hpp>

#include "tests/modeling/written_mesh.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/meshes.h"

/// Meshes of several bodies, some of them inside out.
namespace {

using Catch::Contains;
using sim::TriangleMesh;
using sim::Vec3;
using tests::insideOut;
using tests::moved;
using tests::together;

struct Turned {
  TriangleMesh mesh;
  modeling::MeshBodies report;
};

Turned turned(const TriangleMesh& mesh) {
  auto triangles = mesh.triangles();
  const modeling::MeshBodies report = modeling::turnOutwards(mesh.points(), triangles);
  return {TriangleMesh(mesh.points(), triangles), report};
}

const TriangleMesh kOuter = tests::boxMesh(Vec3::Constant(3.0));  // 216
const TriangleMesh kInner = tests::ballMesh(2.0, 8);
const double kBall = kInner.volume();

TEST_CASE("of bodies beside each other, those that are inside out are turned") {
  const auto made = turned(together(kOuter, moved(insideOut(kInner), Vec3(9.0, 0.0, 0.0))));
  CHECK(made.mesh.volume() == Approx(216.0 + kBall));
  CHECK(made.report.turned == 1);
  CHECK(made.report.closed == 2);
  CHECK(made.report.filled == 0);
}

TEST_CASE(
    "a hollow stays a hollow, also where all of it is inside out, and a body within the hollow stays whole") {
  const TriangleMesh hollow = together(kOuter, insideOut(kInner));
  const TriangleMesh yolk = tests::boxMesh(Vec3::Constant(0.5));
  for (const bool isTurned : {false, true}) {
    const TriangleMesh made = isTurned ? insideOut(hollow) : hollow;
    CHECK(turned(made).mesh.volume() == Approx(216.0 - kBall));
    CHECK(turned(made).report.filled == 0);
    CHECK(turned(made).report.turned == (isTurned ? 2U : 0U));
    const TriangleMesh full = together(made, isTurned ? insideOut(yolk) : yolk);
    CHECK(turned(full).mesh.volume() == Approx(216.0 - kBall + 1.0));
  }
}

TEST_CASE("a body within another that faces the same way is filled, which is told") {
  const auto made = turned(together(kOuter, kInner));
  CHECK(made.mesh.volume() == Approx(216.0 + kBall));
  CHECK(made.report.filled == 1);
  const auto file = tests::meshOf("a.obj", tests::objText(together(kOuter, kInner)));
  REQUIRE(file.ok());
  CHECK_THAT(file->remark, Contains("lies within another") && Contains("flip its normals"));
}

TEST_CASE("bodies stuck into each other are not within each other") {
  const auto made = turned(together(kOuter, insideOut(moved(kInner, Vec3(3.0, 0.0, 0.0)))));
  CHECK(made.report.filled == 0);
  CHECK(made.report.turned == 1);
  CHECK(made.mesh.volume() == Approx(216.0 + kBall));
}

TEST_CASE("an open body is left as it is") {
  auto triangles = insideOut(kInner).triangles();
  triangles.pop_back();
  const auto made =
      turned(together(insideOut(kOuter), moved({kInner.points(), triangles}, Vec3(9.0, 0.0, 0.0))));
  CHECK(made.report.closed == 1);
  CHECK(made.report.turned == 1);
}

TEST_CASE("an STL of which one body is mirrored is right") {
  const TriangleMesh pair =
      together(tests::boxMesh(Vec3(10.0, 20.0, 30.0)),
               moved(insideOut(tests::boxMesh(Vec3(10.0, 20.0, 30.0))), Vec3(50.0, 0.0, 0.0)));
  const auto file = tests::meshOf("a.stl", tests::stlBytes(pair));
  REQUIRE(file.ok());
  CHECK(file->mesh.volume() == Approx(2.0 * 48.0).epsilon(1e-5));
  CHECK_THAT(file->remark, Contains("1 of its 2 bodies was inside out"));
}

}  // namespace
