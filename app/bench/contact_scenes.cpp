#include "app/bench/contact_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "modeling/scene/resources.h"
#include "modeling/scene/scene_file.h"

namespace app {
namespace {

using sim::Vec3;

constexpr double kGravity = 981.0;  // cm/s^2
constexpr double kFriction = 0.4;

std::string text(const char* format, double value) {
  std::array<char, 96> digits{};
  std::snprintf(digits.data(), digits.size(), format, value);
  return digits.data();
}

std::string onCells(double upper, double lower) {
  return text("%g on ", upper) + text("%g", lower);
}

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

/// Weightless and empty, of a soft material that never breaks.
modeling::Scene emptyScene(double youngsModulus = 1e8) {
  modeling::Scene scene;
  modeling::SceneMaterial material;
  material.name = material.values.name = "soft";
  material.values.youngsModulus = youngsModulus;
  material.values.density = 1.0;
  scene.materials.push_back(material);
  scene.environment.gravity = Vec3::Zero();
  return scene;
}

/// Weight as on a slope of so many degrees, downhill along x: gravity is tilted, so that all else may lie
/// flat.
void addGravity(modeling::Scene& scene, double degrees = 0.0) {
  scene.environment.gravity = kGravity * Vec3(std::sin(radians(degrees)), 0.0, -std::cos(radians(degrees)));
}

void addFloor(modeling::Scene& scene) {
  modeling::SceneCollider floor;
  floor.name = "floor";
  floor.form = modeling::FloorShape{};
  floor.friction = kFriction;
  scene.environment.colliders.push_back(floor);
}

/// The part, which stays where it is until the next is added.
modeling::Part& addSlab(modeling::Scene& scene, const Vec3& size, double cell, const Vec3& position) {
  modeling::SlabShape slab;
  slab.size = size;
  slab.resolution.cellSize = cell;
  modeling::Part part;
  part.name = "part " + std::to_string(scene.parts.size());
  part.shape = slab;
  part.material = scene.materials.front().name;
  part.worldFromPart.position = position;
  scene.parts.push_back(part);
  return scene.parts.back();
}

constexpr double kFar = 99.0;  // cm: beyond every part

void holdAll(modeling::Part& part) {
  part.hold = {{Vec3::Constant(-kFar), Vec3::Constant(kFar)}};
}

/// Off every symmetry, so that no node is above another one by chance.
Vec3 aside(double height) {
  return Vec3(0.13, 0.21, height);
}

const Vec3 kBlock = Vec3::Constant(2.0);  // cm

ContactCase ofScene(std::string what, std::string cells, const modeling::Scene& scene,
                    const ContactMeasure& measure, std::vector<ContactQuantity> quantities) {
  ContactCase made;
  made.what = std::move(what);
  made.cells = std::move(cells);
  made.quantities = std::move(quantities);
  made.run = [scene, measure](sim::ContactKind kind) { return measured(scene, kind, measure); };
  return made;
}

using Cases = std::vector<ContactCase>;

void addGaps(Cases& cases) {
  constexpr std::array<std::pair<double, double>, 5> kCells{
      {{1.0, 1.0}, {0.5, 0.5}, {0.25, 0.25}, {1.0, 0.5}, {0.5, 1.0}}};
  for (const auto& [upper, lower] : kCells) {
    modeling::Scene scene = emptyScene();
    addGravity(scene);
    addFloor(scene);
    addSlab(scene, Vec3(3.0, 3.0, 2.0), lower, Vec3(0.0, 0.0, 0.01));
    addSlab(scene, kBlock, upper, aside(2.15));
    cases.push_back(ofScene("block on a block", onCells(upper, lower), scene, gapAt(0.8),
                            {{"gap", "cells", 0.0, "at most 0.03"}}));
    cases.back().slow = std::min(upper, lower) < 0.5;
  }
}

/// A block on a held slab, where it touches.
modeling::Scene onSlab(double cell, double friction) {
  constexpr double kTouching = 0.02;  // of the lesser cell
  modeling::Scene scene = emptyScene();
  holdAll(addSlab(scene, Vec3(45.0, 6.0, 1.0), 1.0, Vec3(17.0, 0.0, 0.0)));
  addSlab(scene, kBlock, cell, aside(1.0 + kTouching * cell));
  scene.solver.contact.friction = friction;
  return scene;
}

void addSlide(Cases& cases, double degrees, double friction, double cell) {
  constexpr double kTime = 0.4;  // s
  modeling::Scene scene = onSlab(cell, friction);
  addGravity(scene, degrees);
  const double slope = radians(degrees);
  const double expected = 0.5 * kGravity * (std::sin(slope) - friction * std::cos(slope)) * kTime * kTime;
  std::string what = text("slides down a slab of %g degrees, ", degrees) +
                     (friction > 0.0 ? text("friction %g", friction) : "no friction");
  cases.push_back(ofScene(std::move(what), onCells(cell, 1.0), scene, slideUntil(kTime),
                          {{"way in 0.4 s", "cm", expected, "within 3 %"}}));
}

void addSlides(Cases& cases) {
  for (const double cell : {1.0, 0.5}) {
    for (const double degrees : {5.0, 10.0}) addSlide(cases, degrees, 0.0, cell);
    for (const double degrees : {25.0, 30.0, 40.0}) addSlide(cases, degrees, kFriction, cell);
  }
}

/// Below the angle of friction, 21.8 degrees.
void addRests(Cases& cases) {
  const std::vector<ContactQuantity> quantities = {{"way in the second second", "cm", 0.0, "0.000"},
                                                   {"asleep after", "s", std::nullopt}};
  for (const double degrees : {10.0, 18.0, 21.0}) {
    modeling::Scene slab = onSlab(1.0, kFriction);
    addGravity(slab, degrees);
    cases.push_back(ofScene(text("rests on a slab of %g degrees", degrees), onCells(1.0, 1.0), slab,
                            lateSlideUntil(2.0), quantities));
    modeling::Scene obstacle = emptyScene();
    addFloor(obstacle);
    addSlab(obstacle, kBlock, 1.0, aside(0.0));
    addGravity(obstacle, degrees);
    cases.push_back(ofScene(text("rests on an obstacle of %g degrees", degrees), "1", obstacle,
                            lateSlideUntil(2.0), quantities));
  }
}

/// A rod of square section falls on a slab of cells much larger than it, an edge first.
modeling::Scene rodOnSlab() {
  modeling::Scene scene = emptyScene();
  addGravity(scene);
  holdAll(addSlab(scene, Vec3(10.0, 10.0, 2.0), 2.0, Vec3::Zero()));
  modeling::Part& rod = addSlab(scene, Vec3(0.42, 6.0, 0.42), 0.42, Vec3(0.37, 0.21, 2.6));
  rod.worldFromPart.rotation.value = Vec3(0.0, 45.0, 0.0);
  return scene;
}

modeling::Scene sheetOnBlock() {
  modeling::Scene scene = emptyScene();
  addGravity(scene);
  holdAll(addSlab(scene, Vec3(4.0, 4.0, 2.0), 1.0, Vec3::Zero()));
  addSlab(scene, Vec3(2.0, 0.3, 2.0), 0.5, aside(2.1));
  return scene;
}

/// A block of rubber is thrown at a sheet of rubber that is held around its rim.
modeling::Scene blockOnSheet(double speed, double cell) {
  constexpr double kThickness = 0.3, kRim = 3.7;  // cm: from the rim on it is held
  modeling::Scene scene = emptyScene(1e7);
  modeling::Part& sheet = addSlab(scene, Vec3(8.0, 8.0, kThickness), cell, Vec3::Zero());
  sheet.hold = {{Vec3::Constant(-kFar), Vec3(-kRim, kFar, kFar)},
                {Vec3(kRim, -kFar, -kFar), Vec3::Constant(kFar)},
                {Vec3::Constant(-kFar), Vec3(kFar, -kRim, kFar)},
                {Vec3(-kFar, kRim, -kFar), Vec3::Constant(kFar)}};
  addSlab(scene, kBlock, cell, aside(kThickness + 0.05)).velocity = Vec3(0.0, 0.0, -speed);
  return scene;
}

void addDepths(Cases& cases) {
  const std::vector<ContactQuantity> quantities = {{"deepest", "cells", 0.0, "at most 0.1"}};
  cases.push_back(ofScene("rod on a slab, edge first", onCells(0.42, 2.0), rodOnSlab(),
                          deepestUntil(0.5, 500), quantities));
  cases.push_back(ofScene("sheet on a block, edge first", onCells(0.5, 1.0), sheetOnBlock(),
                          deepestUntil(0.5, 500), quantities));
  constexpr double kSpeed = 500.0;  // cm/s
  for (const double cell : {0.6, 0.3}) {
    cases.push_back(ofScene("block at 5 m/s on a rubber sheet of 3 mm", text("%g", cell),
                            blockOnSheet(kSpeed, cell), deepestUntil(6.0 / kSpeed, 100), quantities));
  }
}

void addTower(Cases& cases) {
  modeling::Scene scene = emptyScene();
  addGravity(scene);
  addFloor(scene);
  scene.solver.contact.friction = 0.5;
  for (int i = 0; i < 10; ++i)
    addSlab(scene, kBlock, 1.0, Vec3(0.07 * (i % 3), 0.05 * (i % 2), 2.0 * i + 0.001 + 0.021 * i));
  cases.push_back(
      ofScene("tower of 10 blocks", "1", scene, restUntil(10.0),
              {{"furthest moved in 10 s", "cm", 0.0}, {"asleep after", "s", std::nullopt, "by 2 s"}}));
  cases.back().slow = true;
}

void addRebounds(Cases& cases) {
  const std::vector<ContactQuantity> quantities = {{"speed after over before", "", std::nullopt}};
  for (const double cell : {1.0, 0.5, 0.25}) {
    const Vec3 velocity(0.0, 0.0, -100.0);
    modeling::Scene slab = emptyScene();
    holdAll(addSlab(slab, Vec3(6.0, 6.0, 1.0), 1.0, Vec3::Zero()));
    addSlab(slab, kBlock, cell, aside(1.2)).velocity = velocity;
    cases.push_back(
        ofScene("block at 1 m/s on a held slab", onCells(cell, 1.0), slab, reboundUntil(0.03), quantities));
    modeling::Scene floor = emptyScene();
    addFloor(floor);
    addSlab(floor, kBlock, cell, aside(0.2)).velocity = velocity;
    cases.push_back(
        ofScene("block at 1 m/s on a floor", text("%g", cell), floor, reboundUntil(0.03), quantities));
  }
}

/// A scene of the one material that breaks.
modeling::Scene porcelainScene(const modeling::Material& porcelain) {
  modeling::Scene scene = emptyScene();
  scene.materials.front() = {porcelain.name, porcelain.name, porcelain};
  return scene;
}

void addStartsInside(Cases& cases, const modeling::Material& porcelain) {
  for (const double millimetres : {0.1, 5.0}) {
    modeling::Scene scene = porcelainScene(porcelain);
    addGravity(scene);
    addFloor(scene);
    addSlab(scene, kBlock, 1.0, aside(-0.1 * millimetres));
    cases.push_back(
        ofScene(text("porcelain begins %g mm inside the floor", millimetres), "1", scene, violenceUntil(0.3),
                {{"fastest node", "cm/s", std::nullopt, "under 10"}, {"bonds broken", "", 0.0, "0"}}));
  }
}

/// A bar on two cylinders, and a third that comes down on its middle.
struct Bending {
  int layers = 1;
  double speed = 1.0;  ///< cm/s

  static constexpr double kCell = 0.5;   ///< cm
  static constexpr double kGap = 0.003;  ///< cm: from roller to bar at the beginning
  static constexpr double kWay = 0.05;   ///< cm from where it touches, further than any bar bends

  double duration() const { return (kGap + kWay) / speed; }
  modeling::Scene scene(const modeling::Material& porcelain) const;
};

modeling::Scene Bending::scene(const modeling::Material& porcelain) const {
  constexpr double kRadius = 0.5, kBottom = 2.002;  // cm
  modeling::Scene scene = porcelainScene(porcelain);
  addGravity(scene);
  const double thickness = kCell * layers;
  addSlab(scene, Vec3(12.0, 2.0, thickness), kCell, Vec3(0.0, 0.0, kBottom));
  const auto addCylinder = [&](const char* name, double x, double z) {
    modeling::SceneCollider cylinder;
    cylinder.name = name;
    cylinder.form = modeling::CylinderShape{kRadius, 3.0};
    cylinder.position = Vec3(x, 0.0, z);
    cylinder.rotation.value = Vec3(90.0, 0.0, 0.0);
    scene.environment.colliders.push_back(cylinder);
  };
  const double top = kBottom + thickness + kGap + kRadius;
  addCylinder("left", -5.0, 1.5);
  addCylinder("right", 5.0, 1.5);
  addCylinder("roller", 0.0, top);
  modeling::SceneTrack down;
  down.target = {sim::TrackTarget::colliderPosition, "roller"};
  down.keys = {{0.0, Vec3(0.0, 0.0, top)}, {duration(), Vec3(0.0, 0.0, top - kGap - kWay)}};
  scene.tracks.push_back(down);
  return scene;
}

/// The roller's way to the first break with rigid motion over that without.
sim::Result<ContactOutcome> waysToBreak(const Bending& bending, const modeling::Material& porcelain,
                                        sim::ContactKind kind) {
  modeling::Scene scene = bending.scene(porcelain);
  ContactOutcome both;
  std::vector<double> ways;
  for (const bool rigid : {true, false}) {
    scene.solver.skip.rigid = rigid;
    const auto one = measured(scene, kind, breakBy(bending.duration()));
    if (!one) return one.problem();
    both.cpuSeconds += one->cpuSeconds;
    both.maxRise = std::max(both.maxRise, one->maxRise);
    if (one->values.front()) ways.push_back(*one->values.front() * bending.speed - Bending::kGap);
  }
  both.values = {ways.size() == 2 ? std::optional(ways.front() / ways.back()) : std::nullopt};
  return both;
}

void addBending(Cases& cases, const modeling::Material& porcelain) {
  for (const int layers : {1, 2}) {
    for (const double speed : {5.0, 1.0}) {
      ContactCase bent;
      bent.what = text("porcelain bar of %g ", layers) + (layers == 1 ? "layer" : "layers") +
                  text(" bent at %g cm/s", speed);
      bent.cells = text("%g", Bending::kCell);
      bent.quantities = {{"way to the first break, rigid on over off", "", 1.0, "within 0.025"}};
      bent.run = [=](sim::ContactKind kind) { return waysToBreak({layers, speed}, porcelain, kind); };
      bent.byNodes = false;
      cases.push_back(bent);
    }
  }
}

}  // namespace

sim::Result<std::vector<ContactCase>> contactCases() {
  const auto porcelain = modeling::presetMaterial("porcelain");
  if (!porcelain) return porcelain.problem();
  const auto teapot = modeling::loadScene(modeling::resourcesFolder() / "scenes" / "teapot-drop.scene.json");
  if (!teapot) return teapot.problem();
  Cases cases;
  addGaps(cases);
  addSlides(cases);
  addRests(cases);
  addDepths(cases);
  addTower(cases);
  addRebounds(cases);
  addStartsInside(cases, *porcelain);
  addBending(cases, *porcelain);
  cases.push_back(ofScene("teapot-drop, breaking", "its own", teapot->scene, costUntil(0.1),
                          {{"CPU time, over that by nodes", "", 1.0, "at most 1", true}}));
  cases.back().slow = true;
  return cases;
}

}  // namespace app
