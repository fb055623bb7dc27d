#include <random>

#include <catch2/catch.hpp>

#include "modeling/shapes/measured_chain.h"
#include "modeling/shapes/quality.h"
#include "ui/editors/offset_profile.h"
#include "ui/editors/profile_model.h"
#include "ui/kinds/bezier_edit.h"
#include "ui/kinds/part_presets.h"

using modeling::ProfileChain;
using modeling::RevolutionShape;
using modeling::Vec2;
using namespace ui;

namespace {

std::vector<Vec2> samplesOf(const ProfileChain& chain, int each = 400) {
  std::vector<Vec2> samples;
  for (const auto& segment : chain)
    for (int i = 0; i <= each; ++i) samples.push_back(modeling::evaluate(segment, double(i) / each));
  return samples;
}

double distanceTo(const ProfileChain& chain, const Vec2& point) {
  return nearestPlace(chain, [&](const Vec2& at) { return (at - point).norm(); }).distance;
}

void requireEnds(const ProfileModel& model) {
  for (const ProfileSide side : {ProfileSide::outside, ProfileSide::inside}) {
    REQUIRE(!modeling::checkChain(model.chain(side), ""));
    for (const auto& segment : model.chain(side))
      for (const Vec2& point : segment) REQUIRE(point.x() >= 0.0);
  }
  const auto on = [](const Vec2& point) { return point.x() < 1e-6; };
  REQUIRE(on(model.chain(ProfileSide::outside).front()[0]) ==
          on(model.chain(ProfileSide::inside).front()[0]));
  REQUIRE(on(model.chain(ProfileSide::outside).back()[3]) == on(model.chain(ProfileSide::inside).back()[3]));
  if (model.shape().correspondence == modeling::ProfileCorrespondence::segments)
    REQUIRE(model.shape().outside.size() == model.shape().inside.size());
}

RevolutionShape reversed(RevolutionShape shape) {
  for (ProfileChain* chain : {&shape.outside, &shape.inside}) {
    std::reverse(chain->begin(), chain->end());
    for (auto& segment : *chain) std::reverse(segment.begin(), segment.end());
  }
  return shape;
}

}  // namespace

TEST_CASE("Presets are dishes that can be built of good cells", "[profile]") {
  for (const ProfilePreset preset : kProfilePresets) {
    CAPTURE(nameOf(preset).toStdString());
    const auto lattice = modeling::build(shapeOf(preset));
    if (!lattice) FAIL(lattice.problem().line());
    const modeling::LatticeQuality quality = modeling::measure(*lattice);
    CHECK(quality.minScaledJacobian > 0.25);
    CHECK(quality.maxAspect < 8.0);
  }
}

TEST_CASE("A point inserted leaves both curves where they were", "[profile]") {
  for (const ProfilePreset preset : kProfilePresets) {
    const ProfileModel before(shapeOf(preset));
    ProfileModel after = before;
    const ControlId point = after.insert(ProfileSide::outside, 1, 0.3);
    CHECK(point.index == 6);
    CHECK(after.chain(ProfileSide::outside).size() == before.chain(ProfileSide::outside).size() + 1);
    CHECK(after.chain(ProfileSide::inside).size() == before.chain(ProfileSide::inside).size() + 1);
    requireEnds(after);
    const auto& whole = before.chain(ProfileSide::outside)[1];
    for (int i = 0; i <= 50; ++i) {
      const double t = i / 50.0;
      const Vec2 first = modeling::evaluate(after.chain(ProfileSide::outside)[1], t);
      const Vec2 second = modeling::evaluate(after.chain(ProfileSide::outside)[2], t);
      CHECK((first - modeling::evaluate(whole, 0.3 * t)).norm() < 1e-12);
      CHECK((second - modeling::evaluate(whole, 0.3 + 0.7 * t)).norm() < 1e-12);
    }
  }
}

TEST_CASE("Deleting a point that was inserted brings the curve back", "[profile]") {
  const ProfileModel before(shapeOf(ProfilePreset::cup));
  ProfileModel model = before;
  REQUIRE(model.remove({model.insert(ProfileSide::outside, 2, 0.4)}));
  CHECK(model.chain(ProfileSide::outside).size() == 3);
  CHECK(model.chain(ProfileSide::inside).size() == 3);
  for (const Vec2& point : samplesOf(model.chain(ProfileSide::outside), 50))
    CHECK(distanceTo(before.chain(ProfileSide::outside), point) < 0.01);
  CHECK_FALSE(model.remove({{ProfileSide::outside, 0}}));
}

TEST_CASE("An offset inside is one thickness from the outside everywhere", "[profile]") {
  for (const ProfilePreset preset : kProfilePresets)
    for (const double thickness : {0.15, 0.3, 0.45, 0.6})
      for (const bool reverse : {false, true}) {
        CAPTURE(nameOf(preset).toStdString(), thickness, reverse);
        const RevolutionShape shape = reverse ? reversed(shapeOf(preset)) : shapeOf(preset);
        ProfileModel model(shape);
        const auto done = model.offsetInside(thickness);
        if (!done) FAIL(done.problem().line());
        requireEnds(model);
        double least = 1e9;
        double most = 0.0;
        for (const Vec2& point : samplesOf(model.chain(ProfileSide::inside), 60)) {
          const double distance = distanceTo(shape.outside, point);
          least = std::min(least, distance);
          most = std::max(most, distance);
        }
        CHECK(least > 0.97 * thickness);
        CHECK(most < 1.03 * thickness);
        for (const Vec2& point : samplesOf(model.chain(ProfileSide::outside), 20))
          CHECK(distanceTo(shape.outside, point) < 1e-7);
        CHECK(model.chain(ProfileSide::inside).size() <= 12);
        if (const auto problem = model.problem()) FAIL_CHECK(problem->line());
      }
}

TEST_CASE("An offset turns a sharp corner into one of the inside, and ends level on the axis", "[profile]") {
  ProfileModel model(shapeOf(ProfilePreset::cup));
  RevolutionShape can = model.shape();
  can.outside = {modeling::straightSegment(Vec2(0, 0), Vec2(3, 0)),
                 modeling::straightSegment(Vec2(3, 0), Vec2(3, 8))};
  model = ProfileModel(can);
  REQUIRE(model.offsetInside(0.5));
  const ProfileChain& inside = model.chain(ProfileSide::inside);
  REQUIRE(inside.size() == 2);
  CHECK((inside[0][0] - Vec2(0, 0.5)).norm() < 1e-9);
  CHECK((inside[0][3] - Vec2(2.5, 0.5)).norm() < 1e-9);
  CHECK((inside[1][3] - Vec2(2.5, 8)).norm() < 1e-9);
  CHECK(model.shape().correspondence == modeling::ProfileCorrespondence::segments);
  CHECK(modeling::build(model.shape()));
}

TEST_CASE("A wall too thick for what it encloses is refused and changes nothing", "[profile]") {
  ProfileModel model(shapeOf(ProfilePreset::bottle));
  const RevolutionShape before = model.shape();
  CHECK_FALSE(model.offsetInside(2.0));
  CHECK_FALSE(model.offsetInside(0.0));
  CHECK_FALSE(model.offsetInside(-1.0));
  CHECK(model.shape() == before);
}

TEST_CASE("A smooth point keeps its handles in line, a corner has its own", "[profile]") {
  ProfileModel model(shapeOf(ProfilePreset::vase));
  const ControlId point{ProfileSide::outside, 6};
  REQUIRE(model.isSmooth(point));
  model.move({{ProfileSide::outside, 7}}, Vec2(0.6, 0.2));
  CHECK(model.isSmooth(point));
  model.move({{ProfileSide::outside, 7}}, Vec2(0.6, 0.2), HandleRule::free);
  CHECK_FALSE(model.isSmooth(point));
  const double length = (model.position({ProfileSide::outside, 5}) - model.position(point)).norm();
  model.makeSmooth({point});
  CHECK(model.isSmooth(point));
  CHECK((model.position({ProfileSide::outside, 5}) - model.position(point)).norm() == Approx(length));
  model.makeCorner({point});
  CHECK_FALSE(model.isSmooth(point));
}

TEST_CASE("A point takes its handles along, and never crosses the axis", "[profile]") {
  ProfileModel model(shapeOf(ProfilePreset::vase));
  const Vec2 handle = model.position({ProfileSide::outside, 5});
  model.move({{ProfileSide::outside, 6}}, Vec2(0.5, -0.25));
  CHECK((model.position({ProfileSide::outside, 5}) - handle - Vec2(0.5, -0.25)).norm() < 1e-12);
  model.move({{ProfileSide::outside, 6}}, Vec2(-100, 0));
  requireEnds(model);
}

TEST_CASE("Ends close and open for both profiles together", "[profile]") {
  ProfileModel model(shapeOf(ProfilePreset::cup));
  CHECK(model.isClosed(ProfileEnd::start));
  CHECK_FALSE(model.isClosed(ProfileEnd::end));
  model.move({{ProfileSide::outside, 0}}, Vec2(1.0, 0.1));
  CHECK(model.isClosed(ProfileEnd::start));
  requireEnds(model);
  model.open(ProfileEnd::start);
  CHECK_FALSE(model.isClosed(ProfileEnd::start));
  requireEnds(model);
  CHECK(modeling::build(model.shape()));
  model.close(ProfileEnd::start);
  CHECK(model.isClosed(ProfileEnd::start));
  requireEnds(model);
  CHECK(modeling::build(model.shape()));
}

TEST_CASE("Whatever is done to profiles, they stay profiles", "[profile]") {
  std::mt19937 random(7);
  const auto below = [&](std::size_t count) { return std::size_t(random() % count); };
  for (int sequence = 0; sequence < 40; ++sequence) {
    ProfileModel model(shapeOf(kProfilePresets[below(kProfilePresets.size())]));
    int built = 0;
    for (int step = 0; step < 30; ++step) {
      const ProfileSide side = below(2) == 0 ? ProfileSide::outside : ProfileSide::inside;
      const ControlId control{side, below(model.controlCount(side))};
      const double scale = sequence % 2 == 0 ? 0.05 : 3.0;
      const Vec2 by(scale * (double(below(2001)) / 1000.0 - 1.0),
                    scale * (double(below(2001)) / 1000.0 - 1.0));
      switch (below(9)) {
        case 0:
          if (model.chain(side).size() < 8)
            model.insert(side, below(model.chain(side).size()), 0.2 + 0.1 * double(below(7)));
          break;
        case 1: {
          const auto removed = model.remove({control});
          CHECK((removed || !control.isPoint() || model.isEnd(control)));
          break;
        }
        case 2:
          model.makeSmooth({control});
          break;
        case 3:
          if (sequence % 2 == 1) model.makeCorner({control});
          break;
        case 4:
          if (sequence % 2 == 1) model.straighten({control});
          break;
        case 5: {
          const ProfileModel before = model;
          const auto done = model.offsetInside(0.2 + 0.1 * double(below(4)));
          if (!done) CHECK(model.shape() == before.shape());
          break;
        }
        case 6:
          if (sequence % 2 == 1) model.open(ProfileEnd::start);
          break;
        default:
          model.move({control}, by);
      }
      requireEnds(model);
    }
    const auto lattice = modeling::build(model.shape());
    if (lattice) ++built;
    if (!lattice) CHECK_FALSE(lattice.problem().what.empty());
    if (sequence % 2 == 0 && !lattice) WARN(lattice.problem().line());
  }
}
