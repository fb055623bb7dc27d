#include "modeling/scene/tracks.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/perform.h"
#include "sim/control/controls.h"

// What tracks mean, asked of a scene, is what a simulation of the scene does by them: to the bit, since both
// ask the same functions.

namespace {

using modeling::Scene;
using modeling::SceneTrack;
using modeling::TargetName;
using modeling::TrackValue;
using sim::Interpolation;
using sim::TrackTarget;
using sim::Vec3;

constexpr int kScenes = 60;
constexpr int kTimes = 40;
constexpr double kLatest = 2.0;  ///< s: keys and times asked about lie before this

/// Random numbers, the same in every run of the test.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}

  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_);
  }
  Vec3 vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }
  bool now(double share) { return between(0.0, 1.0) < share; }

 private:
  std::mt19937 engine_;
};

/// Two materials and three colliders, one of which comes and goes.
Scene worldWithoutTracks(Dice& dice) {
  Scene scene;
  scene.environment.gravity = dice.vector(1000.0);
  for (const char* name : {"glass", "rubber"}) {
    scene.materials.emplace_back().name = name;
    scene.materials.back().values.name = name;
  }
  for (const char* name : {"floor", "ball", "box"}) {
    modeling::SceneCollider& collider = scene.environment.colliders.emplace_back();
    collider.name = name;
    collider.position = dice.vector(10.0);
    collider.rotation.value = dice.vector(180.0);
  }
  scene.environment.colliders[1].form = modeling::SphereShape{2.0};
  scene.environment.colliders[2].form = modeling::BoxShape{Vec3(1.0, 2.0, 3.0)};
  scene.environment.colliders[2].active = {0.4, 1.3};
  return scene;
}

TrackValue randomValue(Dice& dice, const TargetName& target) {
  if (!target.isVector()) return dice.between(0.0, 3.0);
  return target.target == TrackTarget::gravity ? dice.vector(2000.0) : dice.vector(200.0);
}

SceneTrack randomTrack(Dice& dice, const Scene& scene) {
  const std::vector<TargetName> targets = modeling::targetsOf(scene);
  SceneTrack track;
  track.target = targets[dice.below(targets.size())];
  track.interpolation =
      std::vector{Interpolation::step, Interpolation::linear, Interpolation::smooth}[dice.below(3)];
  const std::size_t count = 1 + dice.below(4);
  std::vector<double> times;
  while (times.size() < count) times.push_back(dice.between(0.0, kLatest));
  std::ranges::sort(times);
  for (const double time : times) track.keys.push_back({time, randomValue(dice, track.target)});
  return track;
}

/// Several tracks of one target are as likely as not.
Scene randomScene(Dice& dice) {
  Scene scene = worldWithoutTracks(dice);
  const std::size_t count = dice.below(12);
  for (std::size_t t = 0; t < count; ++t) {
    scene.tracks.push_back(randomTrack(dice, scene));
    if (dice.now(0.5)) {
      SceneTrack& last = scene.tracks.back();
      const TargetName& before = scene.tracks[dice.below(scene.tracks.size())].target;
      if (before.isVector() == last.target.isVector()) last.target = before;
    }
  }
  return scene;
}

/// The second material is there in two variants.
std::vector<sim::Material> materialsOfNetwork() {
  return {{.name = "glass"}, {.name = "rubber"}, {.name = "rubber"}};
}

/// Times between keys, beyond them and at them.
double randomTime(Dice& dice, const Scene& scene) {
  if (!scene.tracks.empty() && dice.now(0.3)) {
    const SceneTrack& track = scene.tracks[dice.below(scene.tracks.size())];
    return track.keys[dice.below(track.keys.size())].time;
  }
  return dice.between(0.0, 1.2 * kLatest);
}

void checkColliders(const Scene& scene, const sim::Controls& controls, double time) {
  std::vector<sim::Collider> acting;
  for (const sim::MovingCollider& collider : controls.colliders()) {
    if (collider.active) acting.push_back(collider.shape);
  }
  const std::vector<sim::Collider> asked = modeling::collidersAt(scene, time);
  REQUIRE(asked.size() == acting.size());
  for (std::size_t c = 0; c < asked.size(); ++c) {
    CHECK(asked[c].name == acting[c].name);
    CHECK(asked[c].position == acting[c].position);
    CHECK(asked[c].rotation.coeffs() == acting[c].rotation.coeffs());
  }
}

TEST_CASE("what is asked of a scene's tracks is what a simulation does by them") {
  sim::Network network;
  network.materials = materialsOfNetwork();
  for (unsigned seed = 0; seed < kScenes; ++seed) {
    INFO("seed " << seed);
    Dice dice(seed);
    const Scene scene = randomScene(dice);
    const modeling::Conditions conditions = modeling::conditionsOf(scene, network.materials);
    sim::Controls controls(network, conditions.environment, conditions.tracks);
    std::vector<double> times;
    for (int n = 0; n < kTimes; ++n) times.push_back(randomTime(dice, scene));
    // A simulation's time goes on.
    std::ranges::sort(times);
    for (const double time : times) {
      INFO("time " << time);
      controls.moveTo(time);
      CHECK(modeling::gravityAt(scene, time) == controls.gravity());
      CHECK(Vec3(modeling::scaleAt(scene, {TrackTarget::gravityScale, ""}, time) *
                 modeling::unscaledGravityAt(scene, time)) == controls.gravity());
      const std::vector<sim::MaterialNow>& materials = controls.materials();
      for (std::size_t m = 0; m < materials.size(); ++m) {
        const std::string& name = network.materials[m].name;
        CHECK(modeling::scaleAt(scene, {TrackTarget::stiffnessScale, name}, time) ==
              materials[m].stiffnessScale);
        CHECK(modeling::scaleAt(scene, {TrackTarget::dampingScale, name}, time) == materials[m].dampingScale);
      }
      checkColliders(scene, controls, time);
    }
  }
}

TEST_CASE("until the time that is said to be constant nothing changes") {
  sim::Network network;
  network.materials = materialsOfNetwork();
  for (unsigned seed = 0; seed < kScenes; ++seed) {
    INFO("seed " << seed);
    Dice dice(1000 + seed);
    const Scene scene = randomScene(dice);
    const modeling::Conditions conditions = modeling::conditionsOf(scene, network.materials);
    const double time = randomTime(dice, scene);
    sim::Controls controls(network, conditions.environment, conditions.tracks);
    controls.moveTo(time);
    // A collider that leapt here has moved, and rests from the next time on.
    controls.moveTo(time);
    const double until = std::min(controls.constantUntil(), 2.0 * kLatest);
    if (until <= time) continue;
    for (int n = 0; n < 5; ++n) {
      const double later = time + (until - time) * dice.between(0.0, 0.999);
      INFO("from " << time << " until " << until << ", at " << later);
      CHECK_FALSE(controls.moveTo(later).any());
    }
  }
}

TEST_CASE("a performed scale makes the whole what it is to be, whatever other tracks do") {
  for (unsigned seed = 0; seed < kScenes; ++seed) {
    INFO("seed " << seed);
    Dice dice(2000 + seed);
    Scene scene = randomScene(dice);
    const double time = dice.between(0.01, kLatest);
    for (const TargetName& target :
         {TargetName{TrackTarget::stiffnessScale, ""}, TargetName{TrackTarget::dampingScale, "rubber"},
          TargetName{TrackTarget::gravityScale, ""}}) {
      const double total = dice.between(0.1, 5.0);
      const double value = modeling::performedScale(scene, target, time, total);
      modeling::performKey(scene, target, time, value);
      REQUIRE(modeling::scaleAt(scene, target, time) == Approx(total).epsilon(1e-12));
    }
  }
}

TEST_CASE("keys stay in order whatever is added, moved and removed") {
  for (unsigned seed = 0; seed < kScenes; ++seed) {
    INFO("seed " << seed);
    Dice dice(3000 + seed);
    Scene scene = worldWithoutTracks(dice);
    scene.parts.emplace_back().name = "slab";
    scene.parts.back().material = "glass";
    const std::vector<TargetName> targets = modeling::targetsOf(scene);
    for (int n = 0; n < 40; ++n) {
      if (scene.tracks.empty()) modeling::addTrack(scene, targets[dice.below(targets.size())]);
      SceneTrack& track = scene.tracks.front();
      // Some of them so close together that there is no room between them.
      const double time = dice.now(0.5) ? dice.between(-0.1, 1.0) : dice.between(0.0, 5e-6);
      const double act = dice.between(0.0, 1.0);
      if (act < 0.5) {
        const TrackValue value = randomValue(dice, track.target);
        const std::size_t key = modeling::addKey(track, time, value);
        REQUIRE(track.keys[key].value == value);
        CHECK(std::abs(track.keys[key].time - std::max(time, 0.0)) <= modeling::kKeyDistance);
      } else if (act < 0.8) {
        modeling::moveKey(track, dice.below(track.keys.size()), time);
      } else {
        modeling::removeKey(scene, 0, dice.below(track.keys.size()));
      }
      const sim::Status status = modeling::checkScene(scene);
      if (!status) FAIL(status.problem().line());
    }
  }
}

TEST_CASE("a key between performed ones that leave it no room stays where it is") {
  SceneTrack track;
  track.keys = {{0.0, 1.0}, {1e-9, 2.0}, {2e-9, 3.0}};
  modeling::moveKey(track, 1, 0.5);
  CHECK(track.keys[1].time == 1e-9);
}

TEST_CASE(
    "a new track changes nothing, and one that drives something else begins with what changes nothing") {
  Dice dice(7);
  const Scene before = worldWithoutTracks(dice);
  for (const TargetName& target : modeling::targetsOf(before)) {
    INFO(target.text());
    Scene scene = before;
    const std::size_t track = modeling::addTrack(scene, target);
    for (const double time : {0.0, 0.5, 1.0}) {
      CHECK(modeling::gravityAt(scene, time) == before.environment.gravity);
      CHECK(modeling::scaleAt(scene, {TrackTarget::stiffnessScale, "glass"}, time) == 1.0);
      const auto there = modeling::collidersAt(scene, time);
      const auto usual = modeling::collidersAt(before, time);
      REQUIRE(there.size() == usual.size());
      for (std::size_t c = 0; c < there.size(); ++c) {
        CHECK(there[c].position == usual[c].position);
        CHECK(there[c].rotation.isApprox(usual[c].rotation, 1e-15));
      }
    }
    for (const TargetName& other : modeling::targetsOf(before)) {
      Scene changed = scene;
      modeling::setTarget(changed, track, other);
      REQUIRE(changed.tracks[track].keys.size() == 1);
      const TrackValue& value = changed.tracks[track].keys[0].value;
      CHECK(std::holds_alternative<Vec3>(value) == other.isVector());
      if (other.isVector() != target.isVector()) CHECK(value == modeling::neutralValue(before, other));
    }
  }
}

TEST_CASE("a single material is a target of its own only where a track names it") {
  Scene scene;
  scene.materials.emplace_back().name = "glass";
  const auto names = [&](const char* text) {
    const std::vector<TargetName> targets = modeling::targetsOf(scene);
    return std::ranges::find(targets, TargetName::parse(text).value()) != targets.end();
  };
  CHECK_FALSE(names("stiffness.scale.glass"));
  scene.tracks.push_back({TargetName::parse("stiffness.scale.glass").value(), {{0.0, 1.0}}});
  CHECK(names("stiffness.scale.glass"));
  CHECK_FALSE(names("damping.scale.glass"));
  scene.materials.emplace_back().name = "rubber";
  CHECK(names("damping.scale.rubber"));
}

}  // namespace
