#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "modeling/shapes/bezier.h"
#include "modeling/shapes/bezier_patch.h"
#include "modeling/shapes/quality.h"
#include "tests/modeling/lattice_checks.h"

using modeling::BezierPatchShape;
using modeling::ControlNet;
using modeling::PatchSide;
using modeling::Vec3;

namespace {

modeling::Lattice built(const BezierPatchShape& shape) {
  auto lattice = build(shape);
  INFO((lattice.ok() ? "" : lattice.problem().line()));
  REQUIRE(lattice.ok());
  CHECK(tests::brokenLatticeRule(*lattice).value_or("") == "");
  return std::move(lattice).value();
}

/// A flat net of 6 x 4 cm at height z, its inner control points uneven along u.
ControlNet flat(double z) {
  ControlNet net;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      net[i][j] = Vec3(std::array{0.0, 0.5, 3.0, 6.0}[i], static_cast<double>(j) * 4.0 / 3.0, z);
  return net;
}

/// A quarter of a cylinder of radius 5 about the y axis and 4 long: normals point outwards, true to 3e-4 of
/// the radius.
ControlNet quarterCylinder() {
  const double handle = 5.0 * 4.0 / 3.0 * std::tan(std::numbers::pi / 8);
  const std::array<std::array<double, 2>, 4> arc{{{0, 5}, {handle, 5}, {5, handle}, {5, 0}}};
  ControlNet net;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      net[i][j] = Vec3(arc[i][0], static_cast<double>(j) * 4.0 / 3.0, arc[i][1]);
  return net;
}

std::array<double, 2> radiiOf(const modeling::Lattice& lattice) {
  std::array<double, 2> range{1e9, 0.0};
  for (const Vec3& node : lattice.nodes) {
    const double radius = std::hypot(node.x(), node.z());
    range = {std::min(range[0], radius), std::max(range[1], radius)};
  }
  return range;
}

}  // namespace

TEST_CASE("A flat patch is a slab, evenly cut whatever its control points", "[shapes]") {
  BezierPatchShape shape;
  shape.net = flat(1.0);
  shape.thickness = 0.5;
  shape.resolution.counts = {12, 8, 1};
  const auto lattice = built(shape);
  const auto quality = measure(lattice);
  CHECK(lattice.nodes.size() == 13 * 9 * 2);
  CHECK(quality.volume == Approx(6 * 4 * 0.5).epsilon(1e-12));
  // Spaced by a table of 256 steps: true to 1e-4.
  CHECK(quality.minEdge == Approx(0.5).epsilon(1e-3));
  CHECK(quality.maxEdge == Approx(0.5).epsilon(1e-3));
}

TEST_CASE("A patch is thickened on the side that is asked for", "[shapes]") {
  BezierPatchShape shape;
  shape.net = quarterCylinder();
  shape.thickness = 1.0;
  shape.resolution.counts = {16, 8, 2};
  const auto check = [&](PatchSide side, double inner, double outer) {
    shape.side = side;
    const auto lattice = built(shape);
    const auto radii = radiiOf(lattice);
    CHECK(radii[0] == Approx(inner).epsilon(1e-3));
    CHECK(radii[1] == Approx(outer).epsilon(1e-3));
    // 16 chords of a quarter lose 0.16 % of the area.
    const double exact = std::numbers::pi / 4 * (outer * outer - inner * inner) * 4;
    CHECK(measure(lattice).volume == Approx(exact).epsilon(0.003));
  };
  // The net runs from z to x and along y: its normal points outwards or inwards as (d/du) x (d/dv) says.
  const Vec3 normal = Vec3(1, 0, 0).cross(Vec3(0, 1, 0));  // at the top, where u runs along x
  const bool outwards = normal.z() > 0.0;
  REQUIRE(outwards);
  check(PatchSide::centred, 4.5, 5.5);
  check(PatchSide::outside, 5.0, 6.0);
  check(PatchSide::inside, 4.0, 5.0);
}

TEST_CASE("Between two patches lies their ruled solid", "[shapes]") {
  BezierPatchShape shape;
  shape.net = flat(0.0);
  shape.oppositeNet = flat(1.0);
  for (auto& row : *shape.oppositeNet)
    for (Vec3& point : row) point.z() += 0.25 * point.x();  // a wedge: 1 to 2.5 thick
  shape.thickness = -1.0;                                   // not read
  shape.resolution.cellSize = 0.5;
  CHECK(measure(built(shape)).volume == Approx(6 * 4 * 1.75).epsilon(1e-6));
  std::swap(shape.net, *shape.oppositeNet);  // either way round
  CHECK(measure(built(shape)).volume == Approx(6 * 4 * 1.75).epsilon(1e-6));
}

TEST_CASE("Patches that cannot be are problems with a remedy", "[shapes]") {
  const auto isProblem = [](auto change) {
    BezierPatchShape shape;
    shape.net = quarterCylinder();
    change(shape);
    const auto lattice = build(shape);
    return !lattice.ok() && !lattice.problem().what.empty() && !lattice.problem().remedy.empty();
  };
  CHECK_FALSE(isProblem([](BezierPatchShape&) {}));
  CHECK(isProblem([](BezierPatchShape& s) { s.thickness = 0.0; }));
  CHECK(isProblem([](BezierPatchShape& s) { s.thickness = std::nan(""); }));
  CHECK(isProblem([](BezierPatchShape& s) { s.thickness = 12.0; }));  // folds inside the bend of radius 5
  CHECK(isProblem([](BezierPatchShape& s) { s.net[1][2].x() = std::nan(""); }));
  CHECK(isProblem([](BezierPatchShape& s) {
    s.net = ControlNet{};
    for (auto& row : s.net) row.fill(Vec3::Zero());
  }));
  CHECK(isProblem([](BezierPatchShape& s) { s.oppositeNet = s.net; }));
  CHECK(isProblem([](BezierPatchShape& s) { s.resolution.counts[0] = 0; }));
}
