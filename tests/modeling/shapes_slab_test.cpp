#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "modeling/shapes/quality.h"
#include "modeling/shapes/slab.h"
#include "tests/modeling/lattice_checks.h"

using modeling::SlabShape;
using modeling::Vec3;

TEST_CASE("A slab is cut into equal boxes that fill it", "[shapes]") {
  SlabShape shape;
  shape.size = Vec3(4, 6, 3);
  shape.resolution.counts = {4, 3, 2};
  const auto lattice = build(shape);
  REQUIRE(lattice.ok());
  CHECK(lattice->nodes.size() == 5 * 4 * 3);
  CHECK(lattice->cells.size() == 4 * 3 * 2);
  CHECK(tests::brokenLatticeRule(*lattice).value_or("") == "");
  const auto quality = measure(*lattice);
  CHECK(quality.volume == Approx(72.0).epsilon(1e-14));
  CHECK(quality.minScaledJacobian == Approx(1.0).epsilon(1e-14));
  CHECK(quality.maxAspect == Approx(2.0).epsilon(1e-14));
  CHECK(quality.minEdge == Approx(1.0).epsilon(1e-14));
  CHECK(quality.meanEdge == Approx((1.0 + 2.0 + 1.5) / 3.0).epsilon(1e-14));
}

TEST_CASE("A slab stands on z = 0, centred in x and y", "[shapes]") {
  SlabShape shape;
  shape.size = Vec3(4, 6, 3);
  const auto lattice = build(shape);
  REQUIRE(lattice.ok());
  Vec3 low = lattice->nodes[0], high = low;
  for (const Vec3& node : lattice->nodes) {
    low = low.cwiseMin(node);
    high = high.cwiseMax(node);
  }
  CHECK(low == Vec3(-2, -3, 0));
  CHECK(high == Vec3(2, 3, 3));
}

TEST_CASE("A slab's longest axis is innermost, its shortest next", "[shapes]") {
  for (std::size_t longest = 0; longest < 3; ++longest) {
    const std::size_t shortest = (longest + 1) % 3, middle = (longest + 2) % 3;
    SlabShape shape;
    shape.size = Vec3::Ones();
    shape.resolution.counts[longest] = 7;
    shape.resolution.counts[middle] = 4;
    shape.resolution.counts[shortest] = 2;
    const auto lattice = build(shape);
    REQUIRE(lattice.ok());
    const auto moves = [&](std::size_t step, std::size_t axis) {
      const Vec3 change = lattice->parameters[step] - lattice->parameters[0];
      return change[static_cast<Eigen::Index>(axis)] > 0.0 && change.cwiseSign().sum() == 1.0;
    };
    CHECK(moves(1, longest));
    CHECK(moves(8, shortest));
    CHECK(moves(8 * 3, middle));
  }
}

TEST_CASE("Cell size gives the nearest count, and a count is taken at its word", "[shapes]") {
  SlabShape shape;
  shape.size = Vec3(10, 2.6, 0.1);
  shape.resolution.cellSize = 1.0;
  shape.resolution.counts[0] = 3;
  const auto lattice = build(shape);
  REQUIRE(lattice.ok());
  CHECK(lattice->cells.size() == 3 * 3 * 1);
}

TEST_CASE("A slab that cannot be is a problem with a place and a remedy", "[shapes]") {
  const auto problemOf = [](auto change) {
    SlabShape shape;
    change(shape);
    const auto lattice = build(shape);
    REQUIRE_FALSE(lattice.ok());
    CHECK_FALSE(lattice.problem().what.empty());
    CHECK_FALSE(lattice.problem().remedy.empty());
    return lattice.problem().place;
  };
  const double infinite = std::numeric_limits<double>::infinity(), nan = std::nan("");
  CHECK(problemOf([](SlabShape& s) { s.size.z() = 0.0; }) == "size");
  CHECK(problemOf([](SlabShape& s) { s.size.x() = -1.0; }) == "size");
  CHECK(problemOf([&](SlabShape& s) { s.size.x() = nan; }) == "size");
  CHECK(problemOf([&](SlabShape& s) { s.size.y() = infinite; }) == "size");
  CHECK(problemOf([](SlabShape& s) { s.resolution.counts[1] = 0; }) == "resolution.counts[1]");
  CHECK(problemOf([](SlabShape& s) { s.resolution.counts[2] = -5; }) == "resolution.counts[2]");
  CHECK(problemOf([](SlabShape& s) { s.resolution.counts[2] = 2'000'000'000; }) == "resolution.counts[2]");
  CHECK(problemOf([](SlabShape& s) { s.resolution.cellSize = 0.0; }) == "resolution.cellSize");
  CHECK(problemOf([&](SlabShape& s) { s.resolution.cellSize = nan; }) == "resolution.cellSize");
  CHECK(problemOf([](SlabShape& s) { s.resolution.cellSize = 1e-30; }) == "resolution.cellSize");
  CHECK(problemOf([](SlabShape& s) { s.resolution.cellSize = 0.01; }) == "resolution");
}

TEST_CASE("Quality sees what is wrong with a cell", "[shapes]") {
  modeling::CornerPositions corners;
  for (std::size_t c = 0; c < 8; ++c)
    corners[c] =
        Vec3(static_cast<double>(c & 1U), static_cast<double>((c >> 1) & 1U), static_cast<double>(c >> 2));
  CHECK(modeling::scaledJacobian(corners) == 1.0);
  CHECK(modeling::cellVolume(corners) == Approx(1.0).epsilon(1e-14));

  SECTION("a shear keeps the volume and lowers the Jacobian to the sine of the angle") {
    for (Vec3& corner : corners) corner.x() += corner.y();
    CHECK(modeling::scaledJacobian(corners) == Approx(std::sqrt(0.5)).epsilon(1e-14));
    CHECK(modeling::cellVolume(corners) == Approx(1.0).epsilon(1e-14));
  }
  SECTION("a corner pushed through the opposite corner turns the cell inside out there") {
    corners[7] = Vec3(0.2, 0.2, 0.2);
    CHECK(modeling::scaledJacobian(corners) < 0.0);
  }
  SECTION("mirrored, the cell is negative") {
    for (Vec3& corner : corners) corner.z() = -corner.z();
    CHECK(modeling::scaledJacobian(corners) == -1.0);
    CHECK(modeling::cellVolume(corners) == Approx(-1.0).epsilon(1e-14));
  }
}

TEST_CASE("The volume of a cell with bent faces is that of its trilinear map", "[shapes]") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  modeling::CornerPositions corners;
  for (std::size_t c = 0; c < 8; ++c)
    corners[c] =
        Vec3(static_cast<double>(c & 1U) + shift(random), static_cast<double>((c >> 1) & 1U) + shift(random),
             static_cast<double>(c >> 2) + shift(random));
  const int n = 24;
  const auto map = [&](double x, double y, double z) {
    Vec3 point = Vec3::Zero();
    for (std::size_t c = 0; c < 8; ++c)
      point += (c & 1U ? x : 1 - x) * (c & 2U ? y : 1 - y) * (c & 4U ? z : 1 - z) * corners[c];
    return point;
  };
  double volume = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const double h = 1.0 / n, x = (i + 0.5) * h, y = (j + 0.5) * h, z = (k + 0.5) * h;
        const Vec3 du = map(x + h / 2, y, z) - map(x - h / 2, y, z);
        const Vec3 dv = map(x, y + h / 2, z) - map(x, y - h / 2, z);
        const Vec3 dw = map(x, y, z + h / 2) - map(x, y, z - h / 2);
        volume += du.cross(dv).dot(dw);
      }
  // The midpoint rule is off by h^2/24 of the second derivatives, here about 1e-4.
  CHECK(modeling::cellVolume(corners) == Approx(volume).epsilon(1e-3));
}
