#include "modeling/scene/perform.h"

#include <algorithm>
#include <functional>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "tests/modeling/table_scene.h"

// What someone does to a running simulation, and that the scene which comes of it runs the same again.

namespace {

using modeling::Scene;
using modeling::SceneCollider;
using modeling::SceneTrackKey;
using modeling::TargetName;
using sim::Interpolation;
using sim::TrackTarget;
using sim::Vec3;
using tests::started;
using tests::tableScene;

SceneCollider ball(const std::string& name) {
  SceneCollider ball;
  ball.name = name;
  ball.form = modeling::SphereShape{1.0};
  return ball;
}

/// A run that someone plays with.
class Performance {
 public:
  explicit Performance(Scene scene) : scene_(std::move(scene)), simulation_(started(scene_, 1)) {}

  sim::Simulation& simulation() { return *simulation_; }
  const Scene& scene() const { return scene_; }
  void runTo(double time) { REQUIRE(simulation_->advanceTo(time).ok()); }
  void step() { REQUIRE(simulation_->stepOnce().ok()); }

  void key(const char* target, std::variant<double, Vec3> value) {
    modeling::performKey(scene_, TargetName::parse(target).value(), modeling::performTime(*simulation_),
                         value);
    replan();
  }
  /// A ball from one point to another within `seconds`.
  void knock(const Vec3& from, const Vec3& to, double seconds) {
    const double now = modeling::performTime(*simulation_);
    modeling::addPerformer(scene_, ball("knock"), {{now, from}, {now + seconds, to}});
    replan();
  }

 private:
  void replan() {
    const modeling::Conditions conditions = modeling::conditionsOf(scene_, simulation_->network().materials);
    REQUIRE(simulation_->replan(conditions.environment, conditions.tracks).ok());
  }

  Scene scene_;
  std::unique_ptr<sim::Simulation> simulation_;
};

/// The performed scene as a file would hold it, run from the start in one go.
void checkReplay(Performance& live) {
  const auto again = modeling::parseScene(modeling::writeScene(live.scene()), "performed");
  if (!again) FAIL(again.problem().line());
  REQUIRE(again->scene == live.scene());
  for (const int threads : {1, 3}) {
    const auto replay = started(again->scene, threads);
    REQUIRE(replay->advanceTo(live.simulation().time()).ok());
    CHECK(replay->stepCount() == live.simulation().stepCount());
    CHECK(replay->stateHash() == live.simulation().stateHash());
  }
}

void changeGravityScale(Performance& live) {
  live.runTo(0.004);
  live.key("gravity.scale", 5.0);
  live.runTo(0.0081);
  live.key("gravity.scale", 1.0);
}

void turnGravity(Performance& live) {
  live.runTo(0.0033);
  live.key("gravity", Vec3(400.0, 0.0, -981.0));
  for (int n = 0; n < 5; ++n) live.step();
  live.key("gravity", Vec3(0.0, 300.0, 100.0));
}

void sneeze(Performance& live) {
  live.runTo(0.002);
  live.key("stiffness.scale.jelly", 0.01);
  live.runTo(0.006);
  live.key("stiffness.scale.jelly", 3.0);
}

void damp(Performance& live) {
  live.step();
  live.key("damping.scale", 0.0);
  live.runTo(0.005);
  live.key("damping.scale", 0.5);
}

void breakVase(Performance& live) {
  live.runTo(0.001);
  live.knock(Vec3(13.2, 0.0, 3.0), Vec3(9.0, 0.0, 3.0), 0.006);
}

/// Everything, some of it before the first step, and twice between the same two steps.
void performMuch(Performance& live) {
  live.key("gravity.scale", 2.0);
  live.knock(Vec3(1.0, 0.0, 4.0), Vec3(1.0, 0.0, 1.5), 0.004);
  for (int n = 0; n < 3; ++n) live.step();
  live.key("stiffness.scale", 0.5);
  live.key("stiffness.scale", 0.7);
  live.runTo(0.0015);
  live.knock(Vec3(13.2, 0.0, 3.0), Vec3(9.0, 0.0, 3.0), 0.006);
  live.key("damping.scale.glass", 2.0);
  live.runTo(0.00237);
  live.key("gravity", Vec3(100.0, 0.0, -500.0));
  live.runTo(0.0061);
  live.key("stiffness.scale", 1.2);
  // It appears within the block.
  live.knock(Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, 1.5), 0.001);
}

TEST_CASE("what was performed runs again to the same bits") {
  const auto perform = GENERATE(changeGravityScale, turnGravity, sneeze, damp, breakVase, performMuch);
  const auto method = GENERATE(sim::Method::velocityVerlet, sim::Method::rungeKutta);
  const bool driven = GENERATE(false, true);
  Performance live(tableScene(method, driven));
  const std::uint64_t untouched = [&] {
    const auto run = started(live.scene(), 1);
    REQUIRE(run->advanceTo(0.01).ok());
    return run->stateHash();
  }();
  perform(live);
  live.runTo(0.01);
  CHECK(live.simulation().stateHash() != untouched);
  if (perform == breakVase) CHECK(live.simulation().brokenBondCount() > 0);
  checkReplay(live);
}

TEST_CASE("a poke wakes a sleeper, and does so again") {
  Performance live(tableScene(sim::Method::velocityVerlet));
  live.runTo(1.0);
  const auto isAsleep = [&] {
    return live.simulation().snapshot().fragments[0].state == sim::FragmentState::asleep;
  };
  REQUIRE(isAsleep());
  // In slices that fall between steps.
  for (double time = 1.0; time < 1.05; time += 0.0007) live.runTo(time);
  REQUIRE(isAsleep());
  live.knock(Vec3(0.0, 0.0, 3.3), Vec3(0.0, 0.0, 2.5), 0.02);
  live.runTo(live.simulation().time() + 0.015);
  CHECK_FALSE(isAsleep());
  live.runTo(1.2);
  live.key("stiffness.scale.jelly", 0.5);
  live.runTo(1.21);
  checkReplay(live);
}

TEST_CASE("other steps and methods replay as well") {
  Scene scene = tableScene(sim::Method::velocityVerlet);
  SECTION("symplectic Euler") {
    scene.solver.method = sim::Method::symplecticEuler;
  }
  SECTION("the midpoint rule") {
    scene.solver.method = sim::Method::implicitMidpoint;
  }
  SECTION("by a tolerance") {
    scene.solver.step.tolerance = 1e-3;
  }
  SECTION("by a tolerance, in steps taken back") {
    scene.solver.method = sim::Method::rungeKutta;
    scene.solver.step.tolerance = 1e-3;
  }
  Performance live(scene);
  performMuch(live);
  live.runTo(0.008);
  checkReplay(live);
}

TEST_CASE("a performed key leaves what was before it, and ends what was to come") {
  Scene scene = tableScene(sim::Method::velocityVerlet);
  const TargetName target{TrackTarget::gravityScale, ""};
  modeling::performKey(scene, target, 0.5, 2.0);
  REQUIRE(scene.tracks.size() == 1);
  CHECK(scene.tracks[0].keys == std::vector<SceneTrackKey>{{0.0, 1.0}, {0.5, 2.0}});
  modeling::performKey(scene, target, 0.7, 3.0);
  modeling::performKey(scene, target, 0.6, 4.0);
  CHECK(scene.tracks[0].keys == std::vector<SceneTrackKey>{{0.0, 1.0}, {0.5, 2.0}, {0.6, 4.0}});
  // A track whose first key is still to come had that value all the time.
  scene.tracks[0].keys = {{1.0, 7.0}};
  modeling::performKey(scene, target, 0.25, 2.0);
  CHECK(scene.tracks[0].keys == std::vector<SceneTrackKey>{{0.0, 7.0}, {0.25, 2.0}});
  // One that glides is left alone.
  scene.tracks[0].interpolation = Interpolation::linear;
  modeling::performKey(scene, target, 0.5, 2.0);
  REQUIRE(scene.tracks.size() == 2);
  CHECK(scene.tracks[1].interpolation == Interpolation::step);
}

TEST_CASE("performed gravity begins where there was another, and remembers the environment's") {
  Scene scene = tableScene(sim::Method::velocityVerlet);
  const TargetName target{TrackTarget::gravity, ""};
  modeling::performKey(scene, target, 0.5, Vec3(1.0, 0.0, 0.0));
  REQUIRE(scene.tracks.size() == 1);
  CHECK(scene.tracks[0].keys ==
        std::vector<SceneTrackKey>{{0.0, scene.environment.gravity}, {0.5, Vec3(1.0, 0.0, 0.0)}});
  scene.tracks[0].interpolation = Interpolation::smooth;
  modeling::performKey(scene, target, 0.25, Vec3(2.0, 0.0, 0.0));
  REQUIRE(scene.tracks.size() == 2);
  CHECK(scene.tracks[1].keys == std::vector<SceneTrackKey>{{0.25, Vec3(2.0, 0.0, 0.0)}});
}

TEST_CASE("a performer has a name of its own, and is seen by nobody") {
  Scene scene = tableScene(sim::Method::velocityVerlet);
  const std::vector<SceneTrackKey> path = {{1.0, Vec3(0.0, 0.0, 1.0)}, {2.0, Vec3(0.0, 0.0, 3.0)}};
  CHECK(modeling::addPerformer(scene, ball("poke"), path) == "poke 1");
  CHECK(modeling::addPerformer(scene, ball("poke"), path) == "poke 2");
  CHECK(modeling::checkScene(scene).ok());
  CHECK(modeling::collidersAt(scene, 0.5).size() == 1);
  CHECK(modeling::collidersAt(scene, 2.0).size() == 1);
  const std::vector<sim::Collider> there = modeling::collidersAt(scene, 1.5);
  REQUIRE(there.size() == 3);
  CHECK_FALSE(there[2].visible);
  CHECK(there[2].position.z() == Approx(2.0));
}

TEST_CASE("a collider that goes before it comes is refused") {
  Scene scene = tableScene(sim::Method::velocityVerlet);
  scene.environment.colliders[0].active = {2.0, 1.0};
  CHECK(modeling::checkScene(scene).problem().place == "environment.colliders[0].active");
}

}  // namespace
