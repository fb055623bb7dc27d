#include "app/bench/accuracy_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>

#include "app/bench/closed_form_chain.h"
#include "modeling/scene/build.h"
#include "modeling/scene/resources.h"
#include "modeling/scene/scene_file.h"
#include "sim/methods/stable_step.h"

namespace app {
namespace {

using sim::Vec3;

AccuracyScene chainScene(const char* name, const char* title, const ClosedFormChain& chain, double periods) {
  AccuracyScene scene;
  scene.name = name;
  scene.title = title;
  scene.network = sim::buildNetwork(chain.blueprint(), 1).value();
  scene.environment.gravity = Vec3::Zero();
  scene.until = periods * chain.longestPeriod();
  scene.exact = [chain](double time) { return chain.positionsAt(time); };
  return scene;
}

/// A beam of 4 x 4 x 24 cells of a substance in which sound takes 1 ms for 20 cm.
sim::Result<AccuracyScene> beamScene(modeling::ThresholdSpec threshold) {
  modeling::Scene document;
  modeling::SceneMaterial material;
  material.name = material.values.name = "ceramic";
  material.values.youngsModulus = 1e9;
  material.values.threshold = threshold;
  document.materials.push_back(material);
  modeling::SlabShape shape;
  shape.size = Vec3(2.0, 2.0, 12.0);
  shape.resolution.counts = {4, 4, 24};
  modeling::Part part;
  part.name = "bar";
  part.material = "ceramic";
  part.shape = shape;
  document.parts.push_back(part);
  document.environment.gravity = Vec3::Zero();
  auto built = modeling::build(document, modeling::resourcesFolder());
  if (!built) return built.problem();
  AccuracyScene scene;
  scene.network = std::move(built->network);
  scene.environment = built->conditions.environment;
  scene.settings = built->conditions.settings;
  return scene;
}

/// Swings along its length and bends at once: both lowest motions of a free bar, roughly.
sim::Result<AccuracyScene> freeBar() {
  auto scene = beamScene({});
  if (!scene) return scene;
  scene->name = "bar-vibration";
  scene->title = "Bar in free vibration";
  for (std::size_t node = 0; node < scene->network.nodeCount(); ++node) {
    const double along = scene->network.positions[node].z() / 6.0 - 1.0;
    scene->network.velocities[node] =
        Vec3(300.0 * (along * along - 1.0 / 3.0), 0.0, 300.0 * std::sin(0.5 * std::numbers::pi * along));
  }
  scene->until = 2e-3;
  return scene;
}

/// Its ends fly at each other, come back, and go on until the first bond breaks, after three quarters of a
/// swing.
sim::Result<AccuracyScene> breakingBar() {
  auto scene = beamScene({.mean = 0.036, .spread = 0.1});
  if (!scene) return scene;
  scene->name = "bar-breaks";
  scene->title = "Bar torn apart, up to the first break";
  for (std::size_t node = 0; node < scene->network.nodeCount(); ++node) {
    const double along = scene->network.positions[node].z() / 6.0 - 1.0;
    scene->network.velocities[node] = Vec3(0.0, 0.0, -900.0 * std::sin(0.5 * std::numbers::pi * along));
  }
  scene->until = 6e-4;
  scene->untilBreak = true;
  return scene;
}

sim::Result<AccuracyScene> fromFile(const char* file, const std::function<void(modeling::Scene&)>& change) {
  const auto folder = modeling::resourcesFolder() / "scenes";
  auto document = modeling::loadScene(folder / file);
  if (!document) return document.problem();
  change(document->scene);
  auto built = modeling::build(document->scene, folder);
  if (!built) return built.problem();
  AccuracyScene scene;
  scene.network = std::move(built->network);
  scene.environment = built->conditions.environment;
  scene.tracks = built->conditions.tracks;
  scene.settings = built->conditions.settings;
  return scene;
}

/// Damps the stiffest swing to so much of critical, half its loss factor, and slower ones less. The gallery's
/// materials lose more, each by its own resolution, to quieten what is too short to be seen; that would
/// favour forward Euler, whose step is its dampers'.
void damp(AccuracyScene& scene, double ratio) {
  scene.dampingRatio = ratio;
  const sim::Spectrum spectrum = sim::measureSpectrum(scene.network);
  const double share = 2.0 * ratio * spectrum.highestFrequency / spectrum.highestDamping;
  for (sim::BondClass& bond : scene.network.classes) bond.damping *= share;
}

/// As much as the substances lose: unfilled rubber 0.03 to 0.1 of a swing's energy a radian, porcelain 1e-3
/// to 1e-2. (The teapot is stiffer than rubber, so that it stands.)
constexpr double kRubber = 0.03;
constexpr double kPorcelain = 0.005;

/// The gallery's scene with its hiccup at once: its first twentieth of a second is all sag and rebound.
sim::Result<AccuracyScene> hiccup(double dampingRatio) {
  auto scene = fromFile("teapot-hiccup.scene.json", [](modeling::Scene& document) {
    for (modeling::SceneTrack& track : document.tracks) track.keys = {{0.0, 5.0}, {0.03, 1.0}};
  });
  if (!scene) return scene;
  scene->name = "teapot-hiccup";
  scene->title = "Soft: the teapot hiccups";
  damp(*scene, dampingRatio);
  scene->until = 0.05;
  scene->leastGain = 20.0;
  return scene;
}

/// Takes away what belongs to sticking rather than to stepping.
void smooth(AccuracyScene& scene) {
  scene.settings.contact.friction = 0.0;
  for (sim::Collider& collider : scene.environment.colliders) collider.friction = 0.0;
}

/// The gallery's cup of real porcelain (65 GPa) just above the floor, tilted, falling at 4 m/s. It never
/// breaks.
sim::Result<AccuracyScene> landing(double dampingRatio) {
  auto scene = fromFile("cup-roll.scene.json", [](modeling::Scene& document) {
    document.materials.front().values.youngsModulus = 6.5e11;
    document.materials.front().values.threshold = {};
    document.environment.colliders.resize(1);
  });
  if (!scene) return scene;
  scene->name = "cup-sticks";
  scene->title = "Stiff: the same with friction on the floor";
  damp(*scene, dampingRatio);
  double lowest = scene->network.positions.front().z();
  for (const Vec3& position : scene->network.positions) lowest = std::min(lowest, position.z());
  for (Vec3& position : scene->network.positions) position.z() += 1e-4 - lowest;
  for (Vec3& velocity : scene->network.velocities) velocity = Vec3(0.0, 0.0, -400.0);
  scene->until = 1e-4;
  return scene;
}

sim::Result<AccuracyScene> smoothLanding(double dampingRatio) {
  auto scene = landing(dampingRatio);
  if (!scene) return scene;
  scene->name = "cup-landing";
  scene->title = "Stiff: a porcelain cup lands at 4 m/s";
  smooth(*scene);
  scene->leastGain = 10.0;
  return scene;
}

/// The same with other dampings, to show what it decides.
sim::Result<AccuracyScene> brief(sim::Result<AccuracyScene> scene) {
  if (!scene) return scene;
  std::array<char, 16> digits{};
  std::snprintf(digits.data(), digits.size(), "-%g", scene->dampingRatio);
  scene->name += digits.data();
  scene->brief = true;
  scene->leastGain = 0.0;
  return scene;
}

void finish(AccuracyScene& scene) {
  scene.settings.skip.sleep = false;
  scene.settings.skip.rigid = false;
  scene.settings.threads = 1;
  const sim::Spectrum spectrum = sim::measureSpectrum(scene.network);
  scene.limit = sim::stableStep(spectrum, {}, sim::Method::velocityVerlet, 1.0);
  scene.forwardLimit = sim::stableStep(spectrum, {}, sim::Method::forwardEuler, 1.0);
}

}  // namespace

sim::Result<std::vector<AccuracyScene>> accuracyScenes(bool quick) {
  std::vector<AccuracyScene> scenes;
  scenes.push_back(chainScene("spring", "Single spring, ten swings",
                              ClosedFormChain({.count = 2, .dampingRatio = 0.02}, 0.1, 0.1), 10.0));
  scenes.push_back(chainScene("chain", "Chain of 64 springs, pulled at one end",
                              ClosedFormChain({.count = 65, .dampingRatio = 0.1}, 2.0, 8.0), 1.0));
  std::vector<std::function<sim::Result<AccuracyScene>()>> others = {
      freeBar, [] { return hiccup(kRubber); }, [] { return smoothLanding(kPorcelain); },
      [] { return landing(kPorcelain); }, breakingBar};
  for (const double ratio : {0.1, 0.03, 0.01}) {
    if (ratio != kRubber) others.emplace_back([ratio] { return brief(hiccup(ratio)); });
    others.emplace_back([ratio] { return brief(smoothLanding(ratio)); });
  }
  if (quick) others = {breakingBar};
  for (const auto& make : others) {
    auto scene = make();
    if (!scene) return scene.problem();
    scenes.push_back(std::move(*scene));
  }
  for (AccuracyScene& scene : scenes) finish(scene);
  return scenes;
}

}  // namespace app
