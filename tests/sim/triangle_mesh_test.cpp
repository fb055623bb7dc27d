#include "sim/collider/triangle_mesh.h"

#include <limits>

#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/collider/collider.h"
#include "sim/collider/surface_check.h"
#include "tests/support/meshes.h"
#include "tests/support/spring_network.h"

namespace {

using sim::TriangleMesh;
using sim::Vec3;

Vec3 randomPoint(std::uint64_t counter, double reach) {
  return reach * (2.0 * Vec3(sim::uniformAt(5, 3 * counter), sim::uniformAt(5, 3 * counter + 1),
                             sim::uniformAt(5, 3 * counter + 2)) -
                  Vec3::Ones());
}

/// Exact, inside and out.
double fromBox(const Vec3& halfSize, const Vec3& point) {
  const Vec3 out = point.cwiseAbs() - halfSize;
  return out.cwiseMax(0.0).norm() + std::min(0.0, out.maxCoeff());
}

TEST_CASE("the distance from a box of triangles is a box's, at faces, edges and corners, inside and out") {
  const Vec3 halfSize(1.0, 2.0, 1.5);
  const TriangleMesh box = tests::boxMesh(halfSize);
  REQUIRE(box.closed());
  CHECK(box.volume() == Approx(24.0));
  for (std::uint64_t p = 0; p < 5000; ++p) {
    const Vec3 point = randomPoint(p, 3.0);
    CHECK(box.signedDistance(point) == Approx(fromBox(halfSize, point)).margin(1e-12));
  }
}

TEST_CASE("the tree finds what looking at every triangle finds") {
  const TriangleMesh ball = tests::ballMesh(2.0, 20);
  REQUIRE(ball.closed());
  for (std::uint64_t p = 0; p < 500; ++p) {
    const Vec3 point = randomPoint(p, 3.0);
    double nearest = 1e9;
    for (const TriangleMesh::Triangle& triangle : ball.triangles())
      nearest = std::min(nearest, TriangleMesh(ball.points(), {triangle}).nearest(point).distance);
    CHECK(ball.nearest(point).distance == Approx(nearest).margin(1e-12));
    // The polyhedron lies within 0.012 of its sphere: 2 (1 - cos(pi / 40)) for triangles half as wide as
    // high.
    CHECK(ball.signedDistance(point) == Approx(point.norm() - 2.0).margin(0.025));
  }
}

TEST_CASE("a spike is outside around its point, where normals of faces alone would disagree") {
  // A needle, pointing up.
  const TriangleMesh needle(
      {Vec3(0.1, 0.0, 0.0), Vec3(-0.05, 0.08, 0.0), Vec3(-0.05, -0.08, 0.0), Vec3(0.0, 0.0, 5.0)},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  REQUIRE(needle.closed());
  CHECK(needle.volume() > 0.0);
  for (std::uint64_t p = 0; p < 1000; ++p) {
    const Vec3 point = Vec3(0.0, 0.0, 5.3) + randomPoint(p, 0.25);
    CHECK(needle.signedDistance(point) > 0.0);
  }
  CHECK(needle.signedDistance(Vec3(0.0, 0.0, 4.0)) < 0.0);
}

TEST_CASE("what does not enclose a volume is told by its edges") {
  const TriangleMesh whole = tests::boxMesh(Vec3::Ones());
  auto triangles = whole.triangles();
  SECTION("a hole") {
    triangles.pop_back();
    const TriangleMesh holed(whole.points(), triangles);
    CHECK_FALSE(holed.closed());
    CHECK(holed.gaps().openEdges == 3);
  }
  SECTION("a face turned round") {
    std::swap(triangles[0][0], triangles[0][1]);
    CHECK(TriangleMesh(whole.points(), triangles).gaps().flippedEdges == 3);
  }
  SECTION("a fin") {
    triangles.push_back({0, 1, 7});
    CHECK(TriangleMesh(whole.points(), triangles).gaps().crowdedEdges > 0);
  }
}

/// A stone that flies at the collider.
std::unique_ptr<sim::Simulation> thrown(const sim::Collider& collider, const Vec3& from,
                                        const Vec3& velocity) {
  sim::Environment environment;
  environment.gravity = Vec3::Zero();
  environment.colliders.push_back(collider);
  sim::Blueprint stone;
  stone.materials = {sim::Material{.name = "stone"}};
  stone.partNames = {"stone"};
  stone.nodes.push_back({.position = from, .velocity = velocity, .mass = 1.0});
  sim::Settings settings = tests::losslessSettings();
  settings.step = 1e-4;
  return tests::simulation(std::move(stone), settings, environment);
}

TEST_CASE("nothing leaks through a ball of triangles or the rim of a sheet, wherever it is hit") {
  sim::Collider ball;
  const auto round = std::make_shared<const TriangleMesh>(tests::ballMesh(2.0, 8));
  ball.shape = sim::SurfaceShape{round, 0.0};
  ball.stiffness = 1e5;
  sim::Collider sheet = ball;
  sheet.shape = sim::SurfaceShape{std::make_shared<const TriangleMesh>(tests::sheetMesh(2.0)), 0.3};
  for (std::uint64_t p = 0; p < 60; ++p) {
    // At corners and edges of the ball too: the first are aimed straight at its points.
    const Vec3 aim = p < 30 ? round->points()[3 * p] : Vec3(2.0 * randomPoint(p, 1.0).normalized());
    const auto flight = thrown(ball, 2.0 * aim, -20.0 * aim);
    double deepest = 10.0;
    for (int n = 0; n < 1500; ++n) {
      REQUIRE(flight->stepOnce().ok());
      deepest = std::min(deepest, flight->snapshot().positions[0].norm());
    }
    // Let in by v sqrt(m / k) = 40 * 0.0032 at most, behind the middle of a triangle.
    CHECK(deepest > 2.0 * 0.92 - 0.13);

    const Vec3 above(1.9 * randomPoint(p, 1.0).x(), 1.9 * randomPoint(p, 1.0).y(), 2.0);
    const auto fall = thrown(sheet, above, Vec3(0.0, 0.0, -40.0));
    tests::run(*fall, 0.1);
    CHECK(fall->snapshot().positions[0].z() > 0.0);
    CHECK(fall->snapshot().velocities[0].z() > 0.0);
  }
}

TEST_CASE("whatever point is asked for, something on the surface is the nearest") {
  const TriangleMesh box = tests::boxMesh(Vec3(1.0, 2.0, 1.5));
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  constexpr double kMost = std::numeric_limits<double>::max();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const double odd : {kNone, kMost, -kMost, kInfinite, 1e200}) {
    for (const Vec3& point : {Vec3(odd, 0.0, 0.0), Vec3(odd, odd, odd), Vec3(0.0, 1.0, odd)}) {
      const auto there = box.nearest(point);
      CHECK(there.triangle < box.triangles().size());
      CHECK(there.point.allFinite());
    }
  }
}

TEST_CASE("a surface that nothing can touch or fill is no surface, and the reason is said") {
  using Triangles = std::vector<TriangleMesh::Triangle>;
  const auto reason = [](const std::vector<Vec3>& points, const Triangles& triangles) {
    const sim::Status status = sim::checkSurface(points, triangles);
    return status.ok() ? std::string() : status.problem().what;
  };
  const TriangleMesh ball = tests::ballMesh(2.0, 8);
  CHECK(reason(ball.points(), ball.triangles()).empty());
  CHECK_THAT(reason(ball.points(), {}), Catch::Contains("no triangles"));
  CHECK_THAT(reason({Vec3::Zero(), Vec3::UnitX(), 2.0 * Vec3::UnitX()}, {{0, 1, 2}}),
             Catch::Contains("has an area"));
  CHECK_THAT(reason({Vec3::Zero(), Vec3::UnitX()}, {{0, 1, 1}}), Catch::Contains("has an area"));
  // A stray corner, as a number that cannot be, far beyond anything, or far from all others.
  const auto stray = [&](double along) {
    std::vector<Vec3> points = ball.points();
    points.back() = Vec3(0.0, along, 0.0);
    return reason(points, ball.triangles());
  };
  CHECK_THAT(stray(std::numeric_limits<double>::quiet_NaN()), Catch::Contains("is no number"));
  CHECK_THAT(stray(1e308), Catch::Contains("further than ten kilometres"));
  CHECK_THAT(stray(-2e6), Catch::Contains("further than ten kilometres"));
  CHECK_THAT(stray(5e4), Catch::Contains("a thousand times as far"));
  CHECK(stray(100.0).empty());
  // A floor with a small thing on it has no stray.
  const TriangleMesh floor = tests::sheetMesh(1e4);
  std::vector<Vec3> points = floor.points();
  Triangles triangles = floor.triangles();
  points.insert(points.end(), ball.points().begin(), ball.points().end());
  for (const auto& t : ball.triangles()) triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  CHECK(reason(points, triangles).empty());
}

}  // namespace
