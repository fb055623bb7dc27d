#include "ui/panels/live_values.h"

#include <catch2/catch.hpp>

#include "modeling/scene/perform.h"
#include "tests/ui/window_scenes.h"

namespace {

using modeling::Scene;
using sim::TrackTarget;

TEST_CASE("Values at a moment are those of all tracks together") {
  Scene scene = tests::fallingSlab();
  CHECK(ui::liveValuesAt(scene, 0.0).gravity == scene.environment.gravity);
  const auto add = [&](TrackTarget target, std::vector<modeling::SceneTrackKey> keys) {
    modeling::SceneTrack track;
    track.target.target = target;
    track.keys = std::move(keys);
    scene.tracks.push_back(track);
  };
  add(TrackTarget::stiffnessScale, {{0.0, 1.0}, {1.0, 3.0}});
  add(TrackTarget::stiffnessScale, {{0.0, 0.5}});
  scene.tracks.back().interpolation = sim::Interpolation::step;
  CHECK(ui::liveValuesAt(scene, 0.5).stiffness == Approx(1.0));
  // For the whole to be 0.4, the track that is performed in has to undo what the other does.
  const modeling::TargetName stiffness{TrackTarget::stiffnessScale, {}};
  CHECK(modeling::performedScale(scene, stiffness, 0.5, 0.4) == Approx(0.2));
  ui::setLiveValue(scene, TrackTarget::stiffnessScale, 0.5, 0.4);
  CHECK(ui::liveValuesAt(scene, 0.5).stiffness == Approx(0.4));
  add(TrackTarget::gravity, {{0.0, sim::Vec3(0.0, 0.0, -1.0)}});
  add(TrackTarget::gravity, {{0.7, sim::Vec3(0.0, 0.0, -2.0)}});
  CHECK(ui::liveValuesAt(scene, 0.5).gravity.z() == -1.0);
  CHECK(ui::liveValuesAt(scene, 0.8).gravity.z() == -2.0);
}

TEST_CASE("A hiccup is five g whatever gravity is, and falls back to none where there is none") {
  Scene scene = tests::fallingSlab();
  scene.environment.gravity = sim::Vec3(0.0, 0.0, -0.5 * ui::kStandardGravity);
  const ui::LiveKeys keys = ui::hiccup(scene, 0.0);
  CHECK(keys.target.target == TrackTarget::gravityScale);
  CHECK(std::get<double>(keys.keys[0].value) == Approx(10.0));
  CHECK(std::get<double>(keys.keys[1].value) == Approx(1.0));
  scene.environment.gravity.setZero();
  const ui::LiveKeys weightless = ui::hiccup(scene, 0.0);
  CHECK(weightless.target.target == TrackTarget::gravity);
  CHECK(modeling::asVector(weightless.keys[0].value).z() == Approx(-5.0 * ui::kStandardGravity));
  CHECK(modeling::asVector(weightless.keys[1].value).norm() == 0.0);
}

TEST_CASE("A second hiccup in the middle of the first one ends where the first would have ended") {
  Scene scene = tests::fallingSlab();
  modeling::SceneTrack track;
  track.target.target = TrackTarget::gravityScale;
  track.interpolation = sim::Interpolation::step;
  track.keys = {{0.0, 1.0}, {0.5, 5.0}, {0.6, 1.0}};
  scene.tracks.push_back(track);
  const ui::LiveKeys keys = ui::hiccup(scene, 0.55);
  CHECK(std::get<double>(keys.keys[0].value) == Approx(5.0));
  CHECK(std::get<double>(keys.keys[1].value) == Approx(1.0));
}

}  // namespace
