#include <algorithm>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

#include "modeling/shapes/quality.h"
#include "modeling/shapes/revolution.h"
#include "tests/modeling/lattice_checks.h"
#include "tests/modeling/shapes_profiles.h"

using modeling::RevolutionShape;
using modeling::Vec2;
using modeling::Vec3;
using std::numbers::pi;
using tests::arcProfile;
using tests::lineProfile;

namespace {

modeling::Lattice built(const RevolutionShape& shape) {
  auto lattice = build(shape);
  INFO((lattice.ok() ? "" : lattice.problem().line()));
  REQUIRE(lattice.ok());
  CHECK(tests::brokenLatticeRule(*lattice).value_or("") == "");
  return std::move(lattice).value();
}

RevolutionShape tube(double outer, double inner, double height) {
  RevolutionShape shape;
  shape.outside = lineProfile(outer, 0, outer, height);
  shape.inside = lineProfile(inner, 0, inner, height);
  return shape;
}

/// A circle cut into n chords loses this share of its area.
double chordShare(int n) {
  return 1.0 - n / (2.0 * pi) * std::sin(2.0 * pi / n);
}

}  // namespace

TEST_CASE("A tube has the volume of its prism, and no seam", "[shapes]") {
  RevolutionShape shape = tube(3, 2, 10);
  shape.resolution.counts = {24, 10, 2};
  const auto lattice = built(shape);
  CHECK(lattice.nodes.size() == 24 * 11 * 3);
  CHECK(lattice.cells.size() == 24 * 10 * 2);
  CHECK(measure(lattice).volume == Approx(pi * (9 - 4) * 10 * (1.0 - chordShare(24))).epsilon(1e-12));
}

TEST_CASE("A partial turn is a share of the whole, with both its sides open", "[shapes]") {
  RevolutionShape shape = tube(3, 2, 10);
  shape.turnAngle = pi / 2;
  shape.startAngle = 0.3;
  shape.resolution.counts = {6, 10, 2};
  const auto lattice = built(shape);
  CHECK(lattice.nodes.size() == 7 * 11 * 3);
  CHECK(measure(lattice).volume == Approx(pi * (9 - 4) * 10 / 4 * (1.0 - chordShare(24))).epsilon(1e-12));
  CHECK(std::atan2(lattice.nodes[0].y(), lattice.nodes[0].x()) == Approx(0.3).epsilon(1e-12));
}

TEST_CASE("A tube is laid out with its longest way innermost", "[shapes]") {
  RevolutionShape wide = tube(6, 5, 2);
  wide.resolution.counts = {40, 4, 1};
  const auto around = built(wide);
  CHECK((around.nodes[1] - around.nodes[0]).z() == 0.0);
  RevolutionShape tall = tube(1, 0.5, 40);
  tall.resolution.counts = {12, 60, 1};
  const auto along = built(tall);
  CHECK((along.nodes[1] - along.nodes[0]).z() == Approx(40.0 / 60));
}

TEST_CASE("A disc closed on the axis is a polygon thick as its wall", "[shapes]") {
  RevolutionShape shape;
  shape.outside = lineProfile(0, 0, 5, 0);
  shape.inside = lineProfile(0, 0.5, 5, 0.5);
  for (const int around : {8, 16, 48}) {
    shape.resolution.counts = {around, std::nullopt, 1};
    const auto lattice = built(shape);
    const auto quality = measure(lattice);
    CHECK(quality.volume == Approx(pi * 25 * 0.5 * (1.0 - chordShare(around))).epsilon(1e-12));
    CHECK(quality.minScaledJacobian > 0.75);
  }
}

TEST_CASE("A hollow ball, closed at both poles, has nearly the volume of the shell", "[shapes]") {
  RevolutionShape shape;
  shape.outside = arcProfile(5, -pi / 2, pi / 2);
  shape.inside = arcProfile(4.5, -pi / 2, pi / 2);
  const double exact = 4.0 / 3.0 * pi * (125 - 4.5 * 4.5 * 4.5);
  double before = 1.0;
  for (const double size : {1.0, 0.5, 0.25}) {
    shape.resolution.cellSize = size;
    const auto quality = measure(built(shape));
    // A chord of length h lies h^2 / (8 R) below its arc, two thirds of that on average; two directions, and
    // a volume that goes as R^3: h^2 / (2 R^2) is lost.
    const double lost = 1.0 - quality.volume / exact;
    CHECK(lost > 0.0);
    CHECK(lost < size * size / (2.0 * 25.0));
    CHECK(lost < 0.4 * before);
    CHECK(quality.minScaledJacobian > 0.8);
    before = lost;
  }
}

TEST_CASE("Solid bodies of revolution, with open and closed ends", "[shapes]") {
  RevolutionShape shape;
  shape.inside = lineProfile(0, -5, 0, 5);
  shape.resolution.cellSize = 0.6;
  SECTION("a rod") {
    shape.outside = lineProfile(3, -5, 3, 5);
    shape.resolution.counts[0] = 32;
    const auto quality = measure(built(shape));
    CHECK(quality.volume == Approx(pi * 9 * 10 * (1.0 - chordShare(32))).epsilon(1e-12));
    CHECK(quality.minScaledJacobian > 0.75);
    CHECK(quality.maxAspect < 2.0);
  }
  SECTION("a ball") {
    shape.outside = arcProfile(5, -pi / 2, pi / 2);
    const auto quality = measure(built(shape));
    const double exact = 4.0 / 3.0 * pi * 125;
    // As for the shell: 0.6^2 / (2 25) is 0.7 %.
    CHECK(quality.volume < exact);
    CHECK(quality.volume > 0.992 * exact);
    CHECK(quality.minScaledJacobian > 0.6);
    CHECK(quality.maxAspect < 3.5);
  }
  SECTION("a dome on a flat foot") {
    shape.outside = arcProfile(5, 0, pi / 2);
    shape.inside = lineProfile(0, 0, 0, 5);
    const auto quality = measure(built(shape));
    const double exact = 2.0 / 3.0 * pi * 125;
    CHECK(quality.volume < exact);
    CHECK(quality.volume > 0.992 * exact);
    CHECK(quality.minScaledJacobian > 0.6);
  }
  SECTION("the knob of the teapot's lid, on its neck") {
    shape.outside = {{Vec2(0, 14.2), Vec2(3.6, 14.2), Vec2(0, 12.8), Vec2(0.9, 12.15)}};
    shape.inside = lineProfile(0, 14.2, 0, 12.15);
    for (const double size : {0.8, 0.4, 0.25}) {
      shape.resolution.cellSize = size;
      CHECK(measure(built(shape)).minScaledJacobian > 0.3);
    }
  }
  SECTION("a quarter of a ball") {
    shape.outside = arcProfile(5, -pi / 2, pi / 2);
    shape.turnAngle = pi / 2;
    CHECK(measure(built(shape)).volume == Approx(pi * 125 / 3.0).epsilon(0.008));
  }
}

TEST_CASE("A cup's cells are nearly uniform, its base included", "[shapes]") {
  for (const double size : {0.8, 0.5, 0.3}) {
    const auto quality = measure(built(tests::cup(size)));
    CHECK(quality.minScaledJacobian > 0.55);
    CHECK(quality.meanScaledJacobian > 0.8);
    CHECK(quality.maxAspect < 3.0);
    CHECK(quality.minEdge > 0.5 * size);
  }
}

TEST_CASE("A cup's volume is that of its section turned about the axis", "[shapes]") {
  const auto shape = tests::cup(0.25);
  // Pappus: 2 pi times the integral of r dA, which over the region between two curves is 2 pi times half the
  // integral of r^2 dz along its boundary.
  const auto turned = [](const modeling::ProfileChain& chain) {
    double sum = 0.0;
    for (const auto& p : chain)
      for (int i = 0; i < 1000; ++i) {
        const auto at = [&](double t) -> Vec2 {
          const double s = 1 - t;
          return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
        };
        const Vec2 a = at(i / 1000.0), b = at((i + 1) / 1000.0);
        sum += 0.25 * (a.x() + b.x()) * (a.x() + b.x()) * (b.y() - a.y());
      }
    return pi * sum;
  };
  const double exact = turned(shape.outside) - turned(shape.inside);
  const double volume = measure(built(shape)).volume;
  // 104 chords around lose 0.06 %; those across the foot's bend a little more.
  CHECK(volume < exact);
  CHECK(volume > 0.997 * exact);
}

TEST_CASE("A cup turned partly is that share of the whole cup", "[shapes]") {
  auto shape = tests::cup(0.8);
  shape.resolution.counts = {32, 18, 1};
  const double whole = measure(built(shape)).volume;
  for (const int quarters : {1, 2, 3}) {
    shape.turnAngle = quarters * pi / 2;
    shape.resolution.counts[0] = 8 * quarters;
    CHECK(measure(built(shape)).volume == Approx(whole * quarters / 4).epsilon(1e-10));
  }
  shape.turnAngle = 6.2;  // four sectors that do not close
  shape.resolution.counts[0] = 32;
  CHECK(measure(built(shape)).volume == Approx(whole * 6.2 / (2 * pi)).epsilon(1e-3));
}

TEST_CASE("Most neighbours around a cup are consecutive nodes", "[shapes]") {
  // A wall one cell thick has 5 edges a column of cells (2 around, 2 along, 1 through): 0.4 if there were no
  // seam, less the ends of the rows.
  CHECK(tests::consecutiveShare(built(tests::cup(0.4))) > 0.37);
}

TEST_CASE("Profiles with different numbers of segments face each other by length", "[shapes]") {
  RevolutionShape shape = tube(3, 2, 10);
  shape.inside = lineProfile(2, 0, 2, 1);
  shape.inside.push_back(modeling::straightSegment(Vec2(2, 1), Vec2(2, 10)));
  shape.resolution.counts = {24, 10, 1};
  for (const Vec3& node : built(shape).nodes) CHECK(std::abs(node.z() - std::round(node.z())) < 1e-9);
  shape.correspondence = modeling::ProfileCorrespondence::segments;
  CHECK_FALSE(build(shape).ok());
}

TEST_CASE("Segments that face each other keep a corner opposite its corner", "[shapes]") {
  RevolutionShape shape;
  shape.outside = lineProfile(3, 0, 6, 0);
  shape.outside.push_back(modeling::straightSegment(Vec2(6, 0), Vec2(6, 6)));
  shape.inside = lineProfile(3, 1, 5, 1);
  shape.inside.push_back(modeling::straightSegment(Vec2(5, 1), Vec2(5, 6)));
  shape.correspondence = modeling::ProfileCorrespondence::segments;
  // The spine is 2.5 + 5.5 long, but for the bend: with 16 cells one row falls on the corners.
  shape.resolution.counts = {36, 16, 1};
  int outer = 0, inner = 0;
  for (const Vec3& node : built(shape).nodes) {
    const Vec2 point(std::hypot(node.x(), node.y()), node.z());
    outer += (point - Vec2(6, 0)).norm() < 0.1;
    inner += (point - Vec2(5, 1)).norm() < 0.1;
  }
  CHECK(outer == 36);
  CHECK(inner == 36);
}

TEST_CASE("Random walls closed at one end are sound lattices", "[shapes]") {
  std::mt19937_64 random(20240601);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int trial = 0; trial < 40; ++trial) {
    const double base = uniform(1.5, 5), belly = base * uniform(1.0, 1.5), rim = base * uniform(0.8, 1.6);
    const double height = uniform(2, 12), wall = uniform(0.2, 0.5);
    const auto profile = [&](double inset) -> modeling::ProfileChain {
      const Vec2 foot(base - 0.5 * inset, inset), top(rim - inset, height);
      const Vec2 flat = foot - Vec2(0.6, 0), side(base - inset, std::min(height * 0.2, 1.0) + inset);
      return {modeling::straightSegment(Vec2(0, inset), flat),
              {flat, foot, Vec2(side - Vec2(0, 0.3)), side},
              {side, Vec2(belly - inset, height * 0.4), Vec2(belly - inset, height * 0.7), top}};
    };
    RevolutionShape shape;
    shape.outside = profile(0.0);
    shape.inside = profile(wall);
    shape.resolution.cellSize = uniform(0.3, 1.0);
    if (trial % 3 == 1) shape.turnAngle = uniform(0.5, 6.0);
    if (trial % 2 == 1)  // from the rim to the base instead
      for (auto* chain : {&shape.outside, &shape.inside}) {
        std::reverse(chain->begin(), chain->end());
        for (auto& segment : *chain) std::reverse(segment.begin(), segment.end());
      }
    INFO("trial " << trial);
    CHECK(measure(built(shape)).minScaledJacobian > 0.2);
  }
}

TEST_CASE("Revolutions that cannot be are problems with a remedy", "[shapes]") {
  const auto isProblem = [](auto change) {
    RevolutionShape shape = tube(3, 2, 10);
    change(shape);
    const auto lattice = build(shape);
    return !lattice.ok() && !lattice.problem().what.empty() && !lattice.problem().remedy.empty();
  };
  const double nan = std::nan("");
  CHECK_FALSE(isProblem([](RevolutionShape&) {}));
  CHECK(isProblem([](RevolutionShape& s) { s.outside.clear(); }));
  CHECK(isProblem([](RevolutionShape& s) { s.inside = s.outside; }));
  CHECK(isProblem([](RevolutionShape& s) { s.inside = lineProfile(2, 0, 4, 10); }));  // crossing
  CHECK(isProblem([](RevolutionShape& s) { s.inside = lineProfile(2, 10, 2, 0); }));  // running the other way
  CHECK(
      isProblem([](RevolutionShape& s) { s.inside = lineProfile(0, 0, 2, 10); }));  // only one meets the axis
  CHECK(isProblem([](RevolutionShape& s) { s.outside = lineProfile(-3, 0, 3, 10); }));
  CHECK(isProblem([&](RevolutionShape& s) { s.outside[0][1].x() = nan; }));
  CHECK(isProblem([](RevolutionShape& s) { s.outside.push_back(s.outside[0]); }));  // a gap
  CHECK(isProblem([](RevolutionShape& s) { s.turnAngle = 0.0; }));
  CHECK(isProblem([](RevolutionShape& s) { s.turnAngle = 7.0; }));
  CHECK(isProblem([&](RevolutionShape& s) { s.turnAngle = nan; }));
  CHECK(isProblem([&](RevolutionShape& s) { s.startAngle = nan; }));
  CHECK(isProblem([](RevolutionShape& s) { s.resolution.counts = {2, 1, 1}; }));
  CHECK(isProblem([](RevolutionShape& s) { s.resolution.counts = {12, 0, 1}; }));
  CHECK(isProblem([](RevolutionShape& s) { s.resolution.cellSize = 0.005; }));
}

TEST_CASE("Closed on the axis, the cells around must suit the sectors", "[shapes]") {
  auto shape = tests::cup(0.8);
  shape.resolution.counts[0] = 30;
  const auto lattice = build(shape);
  REQUIRE_FALSE(lattice.ok());
  CHECK(lattice.problem().place == "resolution.counts[0]");
  CHECK(lattice.problem().remedy == "use 24 or 32");
  shape.resolution.counts = {32, 4, 1};
  const auto tooFewAlong = build(shape);
  REQUIRE_FALSE(tooFewAlong.ok());
  CHECK(tooFewAlong.problem().place == "resolution.counts[1]");
}
