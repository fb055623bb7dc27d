#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "modeling/glue/glue.h"
#include "modeling/shapes/curved_cylinder.h"
#include "modeling/shapes/quality.h"
#include "tests/modeling/lattice_checks.h"
#include "tests/modeling/shapes_teapot.h"

using modeling::CurvedCylinderShape;
using modeling::SweepSection;
using modeling::Vec3;
using std::numbers::pi;

namespace {

modeling::Lattice built(const CurvedCylinderShape& shape) {
  auto lattice = build(shape);
  INFO((lattice.ok() ? "" : lattice.problem().line()));
  REQUIRE(lattice.ok());
  CHECK(tests::brokenLatticeRule(*lattice).value_or("") == "");
  return std::move(lattice).value();
}

CurvedCylinderShape straight(SweepSection section, double halfWidth, double halfDepth) {
  CurvedCylinderShape shape;
  shape.curve = {modeling::straightSegment(Vec3(1, 2, 0), Vec3(1, 2, 8))};
  shape.section = section;
  shape.halfWidth = modeling::constantValue(halfWidth);
  shape.halfDepth = modeling::constantValue(halfDepth);
  return shape;
}

/// A quarter of a circle of radius 6 in the plane y = 0, from (6, 0, 0) to (0, 0, 6); off by 3e-4 of its
/// radius.
modeling::CurveChain quarterCircle() {
  const double handle = 6.0 * 4.0 / 3.0 * std::tan(pi / 8);
  return {{Vec3(6, 0, 0), Vec3(6, 0, handle), Vec3(handle, 0, 6), Vec3(0, 0, 6)}};
}

double polygonShare(int n) {
  return n / (2.0 * pi) * std::sin(2.0 * pi / n);
}

}  // namespace

TEST_CASE("Straight sweeps are the prisms of their sections", "[shapes]") {
  auto shape = straight(SweepSection::rectangle, 1.0, 0.5);
  shape.resolution.counts = {16, 4, 2};
  CHECK(measure(built(shape)).volume == Approx(2 * 1 * 8).epsilon(1e-12));

  shape.section = SweepSection::disc;
  shape.resolution.counts = {16, 24, std::nullopt};
  CHECK(measure(built(shape)).volume == Approx(pi * 0.5 * 8 * polygonShare(24)).epsilon(1e-12));

  shape.section = SweepSection::ring;
  shape.halfDepth = modeling::constantValue(1.0);
  shape.wallThickness = 0.4;
  shape.resolution.counts = {16, 24, 1};
  CHECK(measure(built(shape)).volume == Approx(pi * (1 - 0.36) * 8 * polygonShare(24)).epsilon(1e-9));
}

TEST_CASE("The first axis is where it is asked for, and the second to its left", "[shapes]") {
  auto shape = straight(SweepSection::rectangle, 1.0, 0.5);
  shape.firstAxis = Vec3(3, 0, 7);  // only its part across the curve counts
  shape.resolution.counts = {4, 2, 2};
  const auto lattice = built(shape);
  for (std::size_t node = 0; node < lattice.nodes.size(); ++node) {
    const Vec3& share = lattice.parameters[node];
    const Vec3 expected(1 + 2 * share.y() - 1, 2 + share.z() - 0.5, 8 * share.x());
    CHECK((lattice.nodes[node] - expected).norm() < 1e-9);
  }
}

TEST_CASE("A bent sweep has its section's area times its centre's way", "[shapes]") {
  // Pappus, since the sections stay centred; facets lose what their chords lose.
  for (const auto section : {SweepSection::disc, SweepSection::rectangle, SweepSection::ring}) {
    auto shape = straight(section, 1.0, 1.0);
    shape.curve = quarterCircle();
    shape.wallThickness = 0.5;
    shape.resolution.counts = {40, 32, 2};
    const double area = section == SweepSection::disc        ? pi * polygonShare(32)
                        : section == SweepSection::rectangle ? 4.0
                                                             : pi * (1 - 0.25) * polygonShare(32);
    // 40 chords of a quarter lose 0.03 % of the way; the cubic's 3e-4 comes on top.
    CHECK(measure(built(shape)).volume == Approx(area * 6 * pi / 2).epsilon(1e-3));
  }
}

TEST_CASE("On a plane curve the axis across the plane stays across it", "[shapes]") {
  auto shape = straight(SweepSection::rectangle, 1.0, 0.5);
  shape.curve = quarterCircle();
  shape.resolution.counts = {20, 2, 2};
  const auto lattice = built(shape);  // the first axis is y
  for (std::size_t node = 0; node < lattice.nodes.size(); ++node)
    CHECK(lattice.nodes[node].y() == Approx(2 * lattice.parameters[node].y() - 1).margin(1e-9));
}

TEST_CASE("Carried axes do not twist about a space curve, kept ones do", "[shapes]") {
  auto shape = straight(SweepSection::rectangle, 0.4, 0.4);
  shape.curve = {{Vec3(0, 0, 0), Vec3(6, 0, 0), Vec3(6, 6, 3), Vec3(0, 6, 8)}};
  shape.firstAxis = Vec3::UnitZ();
  shape.resolution.counts = {64, 1, 1};
  // How far the first axis turns about the curve in all: the sum of its turns about the local tangent.
  const auto twist = [&] {
    const auto lattice = built(shape);
    std::vector<std::array<Vec3, 4>> sections(65);
    for (std::size_t node = 0; node < lattice.nodes.size(); ++node) {
      const Vec3& share = lattice.parameters[node];
      sections[static_cast<std::size_t>(std::lround(64 * share.x()))]
              [static_cast<std::size_t>(std::lround(share.y() + 2 * share.z()))] = lattice.nodes[node];
    }
    double sum = 0.0;
    for (std::size_t i = 1; i < sections.size(); ++i) {
      const auto axis = [&](std::size_t at) {
        return Vec3((sections[at][1] - sections[at][0]).normalized());
      };
      const auto centre = [&](std::size_t at) {
        return Vec3(0.25 * (sections[at][0] + sections[at][1] + sections[at][2] + sections[at][3]));
      };
      const Vec3 along = (centre(i) - centre(i - 1)).normalized();
      sum += std::abs(axis(i - 1).cross(axis(i)).dot(along));
    }
    return sum;
  };
  CHECK(twist() < 0.01);
  shape.keepFirstAxis = true;
  CHECK(twist() > 0.1);
}

TEST_CASE("The section's size follows its values along the curve", "[shapes]") {
  auto shape = straight(SweepSection::disc, 1.0, 1.0);
  shape.halfWidth = shape.halfDepth = {{2.0, 2.0 - 1.0 / 3.0, 1.0 + 1.0 / 3.0, 1.0}};  // a cone's trunk
  shape.resolution.counts = {16, 32, std::nullopt};
  CHECK(measure(built(shape)).volume == Approx(pi * 8 / 3 * (4 + 2 + 1) * polygonShare(32)).epsilon(1e-9));
}

TEST_CASE("Two half tubes meet along their edges, and glued are the tube", "[shapes]") {
  auto shape = straight(SweepSection::arc, 1.4, 1.0);
  shape.curve = quarterCircle();
  shape.wallThickness = 0.4;
  shape.resolution.counts = {20, 10, 1};
  std::vector<modeling::GluePart> halves;
  double volume = 0.0;
  for (const double start : {0.0, pi}) {
    shape.startAngle = start;
    shape.endAngle = start + pi;
    const auto lattice = built(shape);
    volume += measure(lattice).volume;
    halves.push_back({start > 0 ? "right" : "left", lattice.nodes, lattice.cells, {}});
  }
  modeling::GlueSettings settings;
  settings.a = 0;
  settings.b = 1;
  settings.reach = 1e-6;
  const auto glued = modeling::glue(halves, {settings});
  REQUIRE(glued.ok());
  CHECK(glued->reports[0].nodesMerged == 2 * 21 * 2);

  shape.section = SweepSection::ring;
  shape.resolution.counts = {20, 20, 1};
  const auto ring = built(shape);
  CHECK(glued->nodeCount == ring.nodes.size());
  CHECK(volume == Approx(measure(ring).volume).epsilon(1e-4));
}

TEST_CASE("The teapot's handle and spout are sweeps between their rails", "[shapes]") {
  for (const double size : {0.8, 0.4}) {
    for (const bool upper : {true, false}) {
      // An ellipse 2.4 times as wide as deep stretches the disc's cells: 127 degrees become 155.
      const auto quality = measure(built(tests::teapotHandleHalf(upper, size)));
      CHECK(quality.minScaledJacobian > 0.35);
      CHECK(quality.maxAspect < 4.0);
    }
    for (const bool left : {true, false}) {
      const auto quality = measure(built(tests::teapotSpoutHalf(left, size)));
      CHECK(quality.minScaledJacobian > 0.3);
      CHECK(quality.maxAspect < 6.0);
    }
  }
}

TEST_CASE("Rails are where the section begins and ends", "[shapes]") {
  CurvedCylinderShape shape;
  shape.section = SweepSection::rectangle;
  shape.curve = {{Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(6, 0, 1), Vec3(8, 0, 3)}};
  shape.secondRail = {{Vec3(0, 0, 2), Vec3(3, 0, 2), Vec3(5, 0, 2.5), Vec3(6, 0, 4)}};
  shape.halfDepth = modeling::constantValue(0.5);
  shape.resolution.counts = {16, 4, 2};
  const auto lattice = built(shape);
  const auto holds = [&](const Vec3& place) {
    for (const Vec3& node : lattice.nodes)
      if ((node - place).norm() < 1e-9) return true;
    return false;
  };
  CHECK(holds(Vec3(0, 0.5, 0)));
  CHECK(holds(Vec3(0, -0.5, 2)));
  CHECK(holds(Vec3(8, 0.5, 3)));
  CHECK(holds(Vec3(6, 0, 4)));
}

TEST_CASE("A sweep far too long for its cells is refused before it is measured", "[shapes]") {
  for (const SweepSection section : {SweepSection::disc, SweepSection::ring}) {
    CurvedCylinderShape shape = straight(section, 0.8, 0.8);
    shape.curve = {modeling::straightSegment(Vec3(0, 0, 0), Vec3(0, 0, 2e6))};
    const auto start = std::chrono::steady_clock::now();
    const auto lattice = build(shape);
    REQUIRE_FALSE(lattice.ok());
    CHECK(lattice.problem().place == "resolution");
    // Measuring four million sections took a minute; this takes no time but for a busy machine's.
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
  }
}

TEST_CASE("Sweeps that cannot be are problems with a remedy", "[shapes]") {
  const auto isProblem = [](auto change) {
    auto shape = straight(SweepSection::ring, 1.0, 1.0);
    change(shape);
    const auto lattice = build(shape);
    return !lattice.ok() && !lattice.problem().what.empty() && !lattice.problem().remedy.empty();
  };
  using Shape = CurvedCylinderShape;
  const double nan = std::nan("");
  CHECK_FALSE(isProblem([](Shape&) {}));
  CHECK(isProblem([](Shape& s) { s.curve.clear(); }));
  CHECK(isProblem([&](Shape& s) { s.curve[0][2].y() = nan; }));
  CHECK(isProblem([](Shape& s) { s.curve[0].fill(Vec3(1, 1, 1)); }));
  CHECK(isProblem([](Shape& s) { s.curve.push_back(s.curve[0]); }));  // a gap
  CHECK(isProblem([](Shape& s) { s.firstAxis = Vec3::Zero(); }));
  CHECK(isProblem([](Shape& s) { s.firstAxis = Vec3::UnitZ(); }));  // along the curve
  CHECK(isProblem([](Shape& s) { s.halfWidth = modeling::constantValue(0.0); }));
  CHECK(isProblem([&](Shape& s) { s.halfDepth[0][1] = nan; }));
  CHECK(isProblem([](Shape& s) { s.halfDepth.push_back(s.halfDepth[0]); }));
  CHECK(isProblem([](Shape& s) { s.wallThickness = 0.0; }));
  CHECK(isProblem([](Shape& s) { s.wallThickness = 1.0; }));
  CHECK(isProblem([](Shape& s) { s.secondRail = s.curve; }));
  CHECK(isProblem([](Shape& s) {
    s.section = SweepSection::arc;
    s.endAngle = s.startAngle;
  }));
  CHECK(isProblem([](Shape& s) {
    s.curve = quarterCircle();
    s.section = SweepSection::disc;
    s.halfWidth = s.halfDepth = modeling::constantValue(7.0);  // wider than its bend
  }));
  CHECK(isProblem([](Shape& s) { s.resolution.counts[1] = 2; }));
  CHECK(isProblem([](Shape& s) { s.resolution.cellSize = 1e-3; }));
}
