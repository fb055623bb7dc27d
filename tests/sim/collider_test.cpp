#include "sim/collider/collider.h"

#include <cmath>
#include <memory>
#include <vector>

#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/collider/triangle_mesh.h"
#include "tests/support/meshes.h"
#include "tests/support/spring_network.h"

namespace {

using sim::Collider;
using sim::Intrusion;
using sim::Vec3;

Vec3 randomPoint(std::uint64_t seed, std::uint64_t counter) {
  return 8.0 * (Vec3(sim::uniformAt(seed, 3 * counter), sim::uniformAt(seed, 3 * counter + 1),
                     sim::uniformAt(seed, 3 * counter + 2)) -
                Vec3::Constant(0.5));
}

const Vec3 kHalfSize(1.0, 2.0, 1.5);

/// One of each kind. The mesh is the box's.
std::vector<sim::ColliderShape> oneOfEach() {
  return {sim::FloorShape{}, sim::BoxShape{kHalfSize}, sim::SphereShape{1.7}, sim::CylinderShape{1.7, 1.2},
          sim::SurfaceShape{std::make_shared<const sim::TriangleMesh>(tests::boxMesh(kHalfSize)), 0.0}};
}

/// Turned and shifted, so that nothing rests on axes.
Collider turned(const sim::ColliderShape& shape) {
  Collider collider;
  collider.shape = shape;
  collider.position = Vec3(0.3, -0.2, 0.4);
  collider.rotation = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -1.0).normalized());
  return collider;
}

/// Inside or not, and how far up the middle it is, from the shape's definition alone.
struct Definition {
  Vec3 local;

  bool holds(const sim::FloorShape&) const { return local.z() < 0.0; }
  bool holds(const sim::BoxShape& box) const {
    return (local.cwiseAbs().array() < box.halfSize.array()).all();
  }
  bool holds(const sim::SphereShape& sphere) const { return local.norm() < sphere.radius; }
  bool holds(const sim::CylinderShape& cylinder) const {
    return std::hypot(local.x(), local.y()) < cylinder.radius && std::abs(local.z()) < cylinder.halfHeight;
  }
  bool holds(const sim::SurfaceShape&) const { return holds(sim::BoxShape{kHalfSize}); }

  static double top(const sim::FloorShape&) { return 0.0; }
  static double top(const sim::BoxShape& box) { return box.halfSize.z(); }
  static double top(const sim::SphereShape& sphere) { return sphere.radius; }
  static double top(const sim::CylinderShape& cylinder) { return cylinder.halfHeight; }
  static double top(const sim::SurfaceShape&) { return kHalfSize.z(); }
};

bool holds(const Collider& collider, const Vec3& point) {
  const Definition definition{collider.rotation.conjugate() * (point - collider.position)};
  return std::visit([&](const auto& shape) { return definition.holds(shape); }, collider.shape);
}

TEST_CASE("an intrusion leads out of the collider by the nearest way") {
  for (const sim::ColliderShape& shape : oneOfEach()) {
    const Collider collider = turned(shape);
    int inside = 0;
    for (std::uint64_t p = 0; p < 2000; ++p) {
      const Vec3 point = randomPoint(11, p);
      const Intrusion into = sim::intrusion(collider, point);
      REQUIRE((into.depth > 0.0) == holds(collider, point));
      REQUIRE(into.normal.norm() == Approx(1.0));
      if (into.depth <= 0.0) continue;
      ++inside;
      // Just short of its depth it is still inside, just past it outside.
      REQUIRE(holds(collider, point + 0.999 * into.depth * into.normal));
      REQUIRE_FALSE(holds(collider, point + 1.001 * into.depth * into.normal));
      // No other way is shorter.
      const Vec3 way = randomPoint(12, p).normalized();
      REQUIRE(holds(collider, point + 0.999 * into.depth * way));
    }
    CHECK(inside > 50);
  }
}

TEST_CASE("outside, no point is nearer to the collider than its negative depth") {
  for (const sim::ColliderShape& shape : oneOfEach()) {
    const Collider collider = turned(shape);
    for (std::uint64_t p = 0; p < 2000; ++p) {
      const Vec3 point = randomPoint(13, p);
      const double depth = sim::intrusion(collider, point).depth;
      if (depth > 0.0) continue;
      REQUIRE_FALSE(holds(collider, point - 0.999 * depth * randomPoint(14, p).normalized()));
    }
  }
}

TEST_CASE("what is drawn of a collider is its surface") {
  for (const sim::ColliderShape& shape : oneOfEach()) {
    const Collider collider = turned(shape);
    if (collider.isFloor()) continue;
    const sim::ColliderSurface surface = sim::surfaceOf(collider);
    REQUIRE(surface.points.size() == surface.normals.size());
    REQUIRE_FALSE(surface.quads.empty());
    const auto inWorld = [&](const Vec3& point) -> Vec3 {
      return collider.position + collider.rotation * point;
    };
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
      REQUIRE(surface.normals[i].norm() == Approx(1.0));
      REQUIRE(sim::intrusion(collider, inWorld(surface.points[i])).depth == Approx(0.0).margin(1e-9));
    }
    for (const auto& quad : surface.quads) {
      // Seen from outside, corners go round counter-clockwise, and normals point out.
      const Vec3& a = surface.points[quad[0]];
      const Vec3 first = surface.points[quad[2]] - a;
      const Vec3 area = (surface.points[quad[1]] - a).cross(first) + first.cross(surface.points[quad[3]] - a);
      for (const std::uint32_t corner : quad) {
        if (area.norm() > 1e-12) REQUIRE(area.dot(surface.normals[corner]) > 0.0);
      }
    }
    const Eigen::AlignedBox3d box = sim::boxOf(collider);
    for (const auto& line : sim::outlineOf(collider)) {
      for (const Vec3& point : line) {
        REQUIRE(sim::intrusion(collider, point).depth == Approx(0.0).margin(1e-9));
        REQUIRE(box.contains(point));
      }
    }
  }
}

/// A node of mass 1 by itself.
sim::Blueprint stone(const Vec3& position, const Vec3& velocity) {
  sim::Blueprint blueprint;
  blueprint.materials = {{.name = "stone"}};
  blueprint.partNames = {"stone"};
  blueprint.nodes.push_back({.position = position, .velocity = velocity, .mass = 1.0});
  return blueprint;
}

sim::Environment only(const Collider& collider) {
  sim::Environment environment = tests::weightless();
  environment.colliders.push_back(collider);
  return environment;
}

sim::Settings fixedStep(double step) {
  sim::Settings settings = tests::losslessSettings();
  settings.step = step;
  return settings;
}

TEST_CASE("a node that flies into a collider is thrown back along the normal") {
  for (const sim::ColliderShape& shape : oneOfEach()) {
    Collider collider = turned(shape);
    collider.stiffness = 1e5;
    collider.dampingRatio = 0.0;
    collider.friction = 0.0;
    // From above the top of each, straight down its axis.
    const Vec3 axis = collider.rotation * Vec3::UnitZ();
    const Vec3 start = collider.position + 3.0 * axis;
    const auto flight = tests::simulation(stone(start, -40.0 * axis), fixedStep(1e-4), only(collider));
    tests::run(*flight, 0.2);
    // The same speed away, but for the steps at which contact begins and ends: (omega h)^2 = 1e-3.
    CHECK((flight->snapshot().velocities[0] - 40.0 * axis).norm() < 40.0 * 2e-3);
    // Let in by v sqrt(m / k) = 0.13 at most, it was never lost.
    CHECK(flight->maxRise() < 0.005);
  }
}

TEST_CASE("a collider never pulls, however strong its damping") {
  for (const sim::ColliderShape& shape : oneOfEach()) {
    Collider collider = turned(shape);
    collider.stiffness = 1e4;
    collider.dampingRatio = 3.0;
    collider.friction = 0.0;
    // A node inside that leaves faster than the spring alone would throw it.
    const Vec3 axis = collider.rotation * Vec3::UnitZ();
    const double top = std::visit([](const auto& one) { return Definition::top(one); }, shape);
    const auto flight = tests::simulation(stone(collider.position + (top - 0.1) * axis, 50.0 * axis),
                                          fixedStep(1e-5), only(collider));
    double slowest = 50.0;
    for (int n = 0; n < 400; ++n) {
      REQUIRE(flight->stepOnce().ok());
      slowest = std::min(slowest, flight->snapshot().velocities[0].dot(axis));
    }
    CHECK(slowest >= 50.0 * (1.0 - 1e-12));
    CHECK(holds(collider, flight->snapshot().positions[0]) == false);
  }
}

TEST_CASE("damping takes what the coefficient of restitution says") {
  Collider floor;
  floor.stiffness = 1e5;
  floor.dampingRatio = 0.2;
  floor.friction = 0.0;
  const auto bounce =
      tests::simulation(stone(Vec3(0.0, 0.0, 0.1), Vec3(0.0, 0.0, -40.0)), fixedStep(1e-6), only(floor));
  tests::run(*bounce, 0.05);
  // A damped spring that only pushes lets go where its force is zero: e = exp(-zeta / sqrt(1 - zeta^2) phi)
  // with phi = atan2(2 zeta sqrt(1 - zeta^2), 2 zeta^2 - 1).
  const double zeta = floor.dampingRatio;
  const double root = std::sqrt(1.0 - zeta * zeta);
  const double phase = std::atan2(2.0 * zeta * root, 2.0 * zeta * zeta - 1.0);
  CHECK(bounce->snapshot().velocities[0].z() == Approx(40.0 * std::exp(-zeta / root * phase)).epsilon(2e-3));
}

TEST_CASE("an invisible collider pushes like a visible one") {
  Collider sphere = turned(sim::SphereShape{1.7});
  sphere.stiffness = 1e4;
  std::array<std::uint64_t, 2> hashes{};
  for (const bool visible : {false, true}) {
    sphere.visible = visible;
    const auto flight =
        tests::simulation(stone(Vec3(0.0, 0.0, 3.0), Vec3(0.0, 0.0, -40.0)), fixedStep(1e-4), only(sphere));
    tests::run(*flight, 0.1);
    CHECK(flight->snapshot().velocities[0].z() > 0.0);
    hashes[visible ? 1 : 0] = flight->stateHash();
  }
  CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("without a stiffness of its own a collider is as stiff as the node's weakest bond") {
  Collider floor;
  floor.friction = 0.0;
  floor.dampingRatio = 0.0;
  tests::Pair pair{.stiffness = 2e3};
  sim::Blueprint lying = tests::twoNodes(pair);
  for (sim::Blueprint::Node& node : lying.nodes) node.velocity.z() = -1.0;
  const auto bounce = tests::simulation(lying, fixedStep(1e-4), only(floor));
  // Half a swing takes pi sqrt(m / k).
  double out = 0.0;
  while (out == 0.0 && bounce->time() < 1.0) {
    REQUIRE(bounce->stepOnce().ok());
    if (bounce->snapshot().positions[0].z() > 0.0) out = bounce->time();
  }
  CHECK(out == Approx(M_PI * std::sqrt(1.0 / 2e3)).margin(2e-4));
}

sim::Track moving(sim::TrackTarget target, sim::Interpolation interpolation,
                  std::vector<sim::Track::Key> keys) {
  sim::Track track;
  track.target = target;
  track.object = 0;
  track.interpolation = interpolation;
  track.keys = std::move(keys);
  return track;
}

TEST_CASE("the work of a moving collider is what the node gains") {
  Collider floor;
  floor.stiffness = 1e5;
  floor.friction = 0.0;
  floor.dampingRatio = GENERATE(0.0, 0.3);
  const auto interpolation = GENERATE(sim::Interpolation::linear, sim::Interpolation::smooth);
  const auto lift = moving(sim::TrackTarget::colliderPosition, interpolation,
                           {{0.0, Vec3(0.0, 0.0, -1.0)}, {0.1, Vec3(0.0, 0.0, 1.0)}});
  const auto kicked =
      tests::simulation(stone(Vec3::Zero(), Vec3::Zero()), fixedStep(1e-5), only(floor), {lift});
  tests::run(*kicked, 0.2);
  const sim::Energy energy = kicked->snapshot().ledger.energy;
  const double speed = kicked->snapshot().velocities[0].z();
  CHECK(speed > 20.0);
  if (floor.dampingRatio == 0.0 && interpolation == sim::Interpolation::linear)
    CHECK(speed == Approx(40.0).epsilon(1e-3));  // a hammer of 20 cm/s and no loss: twice that
  CHECK(energy.kinetic == Approx(0.5 * speed * speed));
  // O((omega h)^2) and the steps at which contact begins and ends; omega h = 3e-3.
  CHECK(energy.outsideWork - energy.dissipated == Approx(energy.kinetic).epsilon(1e-3));
  CHECK(std::abs(energy.residual) < 1e-3 * energy.kinetic);
}

TEST_CASE("a collider that turns carries along what lies on it") {
  Collider disc;
  disc.shape = sim::CylinderShape{5.0, 1.0};
  disc.stiffness = 1e5;
  disc.friction = 0.5;
  sim::Environment environment = only(disc);
  environment.gravity = Vec3(0.0, 0.0, -981.0);
  const auto turn = moving(sim::TrackTarget::colliderRotation, sim::Interpolation::linear,
                           {{0.0, Vec3::Zero()}, {1.0, Vec3(0.0, 0.0, 6.0)}});
  const auto ride = tests::simulation(stone(Vec3(1.0, 0.0, 1.0 - 981.0 / 1e5), Vec3::Zero()), fixedStep(1e-4),
                                      environment, {turn});
  tests::run(*ride, 0.5);
  // After it was brought up to speed (6 cm/s at mu g within 0.012 s, 0.04 cm late) it circles: omega^2 r is
  // 36 cm/s^2, a fourteenth of what friction can hold. It creeps outward as friction is a step late.
  const Vec3 place = ride->snapshot().positions[0];
  CHECK(std::atan2(place.y(), place.x()) == Approx(3.0).margin(0.05));
  CHECK(std::hypot(place.x(), place.y()) == Approx(1.0).margin(0.02));
  const sim::Energy energy = ride->snapshot().ledger.energy;
  CHECK(std::abs(energy.residual) < 0.01 * energy.outsideWork);
}

TEST_CASE("a collider that leaps into a body lets it out slowly, and does the work that it leaves there") {
  Collider sphere;
  sphere.shape = sim::SphereShape{};
  sphere.stiffness = 1e4;
  sphere.dampingRatio = 0.0;
  sphere.friction = 0.0;
  const auto leap = moving(sim::TrackTarget::colliderPosition, sim::Interpolation::step,
                           {{0.0, Vec3(0.0, 0.0, -100.0)}, {0.05, Vec3(0.0, 0.0, -0.5)}});
  const auto thrown =
      tests::simulation(stone(Vec3::Zero(), Vec3::Zero()), fixedStep(1e-4), only(sphere), {leap});
  tests::run(*thrown, 0.5);
  const sim::Energy energy = thrown->snapshot().ledger.energy;
  // Half a centimetre into a spring of 1e4, whose surface comes out at 3 cm/s: what has no dampers springs
  // off it at up to twice that.
  CHECK(energy.kinetic > 0.5 * 3.0 * 3.0 * 0.99);
  CHECK(energy.kinetic < 0.5 * 6.0 * 6.0 * 1.01);
  CHECK(energy.outsideWork == Approx(energy.kinetic).epsilon(0.01));
  CHECK(thrown->maxRise() < 0.01);
}

TEST_CASE("nothing slips through a collider that moves further than the skin of its rows in a step") {
  Collider floor;
  floor.stiffness = 1e6;
  floor.dampingRatio = 0.0;
  floor.friction = 0.0;
  const auto rise = moving(sim::TrackTarget::colliderPosition, sim::Interpolation::linear,
                           {{0.0, Vec3(0.0, 0.0, -20.0)}, {0.2, Vec3(0.0, 0.0, 0.0)}});
  // A lone node has no radius, hence no skin: every step counts. The first step inside pushes already.
  const auto lifted =
      tests::simulation(stone(Vec3(0.0, 0.0, -19.95), Vec3::Zero()), fixedStep(1e-3), only(floor), {rise});
  REQUIRE(lifted->stepOnce().ok());
  REQUIRE(lifted->stepOnce().ok());
  CHECK(lifted->snapshot().velocities[0].z() > 0.0);
}

}  // namespace
