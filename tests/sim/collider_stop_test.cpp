#include <cmath>

#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/collider/collider.h"
#include "tests/support/meshes.h"
#include "tests/support/spring_network.h"

namespace {

using sim::Collider;
using sim::TriangleMesh;
using sim::Vec3;

Vec3 random(std::uint64_t seed, std::uint64_t counter) {
  return 2.0 * Vec3(sim::uniformAt(seed, 3 * counter), sim::uniformAt(seed, 3 * counter + 1),
                    sim::uniformAt(seed, 3 * counter + 2)) -
         Vec3::Ones();
}

/// A square of 2 x 2 fields about the origin, bent so that no two of its eight triangles are in one plane.
TriangleMesh bentSheet() {
  std::vector<Vec3> points;
  for (int row = -1; row <= 1; ++row) {
    for (int column = -1; column <= 1; ++column)
      points.emplace_back(2.0 * column, 2.0 * row, 0.4 * column * row + 0.3 * row * row);
  }
  std::vector<TriangleMesh::Triangle> triangles;
  for (std::uint32_t corner : {0U, 1U, 3U, 4U}) {
    triangles.push_back({corner, corner + 1, corner + 4});
    triangles.push_back({corner, corner + 4, corner + 3});
  }
  return {points, triangles};
}

Collider meshed(TriangleMesh mesh, double thickness) {
  Collider collider;
  collider.shape = sim::SurfaceShape{std::make_shared<const TriangleMesh>(std::move(mesh)), 0.5 * thickness};
  return collider;
}

const TriangleMesh& meshOf(const Collider& collider) {
  return *std::get<sim::SurfaceShape>(collider.shape).mesh;
}

bool passesThrough(const TriangleMesh& mesh, const Vec3& from, const Vec3& to) {
  const auto volume = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (b - a).cross(c - a).dot(d - a);
  };
  for (const TriangleMesh::Triangle& triangle : mesh.triangles()) {
    const Vec3& a = mesh.points()[triangle[0]];
    const Vec3& b = mesh.points()[triangle[1]];
    const Vec3& c = mesh.points()[triangle[2]];
    if (volume(a, b, c, from) * volume(a, b, c, to) >= 0.0) continue;
    const double first = volume(from, to, a, b);
    const double second = volume(from, to, b, c);
    const double third = volume(from, to, c, a);
    if ((first >= 0.0) == (second >= 0.0) && (second >= 0.0) == (third >= 0.0)) return true;
  }
  return false;
}

/// Inside a solid so deep that the nearest way out may be another side, or on the other side of a sheet.
bool crosses(const Collider& collider, const Vec3& from, const Vec3& to) {
  const auto* surface = std::get_if<sim::SurfaceShape>(&collider.shape);
  if (surface != nullptr && !surface->mesh->closed()) return passesThrough(*surface->mesh, from, to);
  return sim::intrusion(collider, to).depth > 0.95 * sim::deepest(collider) / 0.8;
}

/// Stones from all sides, aimed at the corners of the mesh, at points of its edges and anywhere on it: none
/// has a bond, a size, or weighs the same as another.
sim::Blueprint stonesAt(const TriangleMesh& mesh, double speed, unsigned count) {
  sim::Blueprint blueprint;
  blueprint.materials = {{.name = "stone"}};
  blueprint.partNames = {"stones"};
  for (std::uint64_t s = 0; s < count; ++s) {
    const TriangleMesh::Triangle& triangle = mesh.triangles()[s % mesh.triangles().size()];
    Vec3 shares = (random(1, s) + 1.001 * Vec3::Ones()).normalized();
    if (s % 3 < 2) shares[0] = 0.0;
    if (s % 3 < 1) shares[1] = 0.0;
    shares /= shares.sum();
    Vec3 aim = Vec3::Zero();
    for (unsigned c = 0; c < 3; ++c) aim += shares[c] * mesh.points()[triangle[c]];
    const Vec3 way = random(2, s).normalized();
    blueprint.nodes.push_back({.position = aim - 4.0 * way,
                               .velocity = speed * way,
                               .mass = std::pow(10.0, 2.0 * random(3, s).x())});
  }
  return blueprint;
}

sim::Environment only(const Collider& collider) {
  sim::Environment environment = tests::weightless();
  environment.colliders.push_back(collider);
  return environment;
}

/// How many passed; steps until all must have met it.
int countCrossings(sim::Simulation& simulation, const Collider& collider, double until) {
  int crossings = 0;
  std::vector<Vec3> before = simulation.snapshot().positions;
  while (simulation.time() < until) {
    REQUIRE(simulation.stepOnce().ok());
    const std::vector<Vec3> now = simulation.snapshot().positions;
    for (std::size_t n = 0; n < now.size(); ++n) crossings += crosses(collider, before[n], now[n]) ? 1 : 0;
    before = now;
  }
  return crossings;
}

TEST_CASE("no stone gets through a thin sheet or plate, however fast, wherever and from where it hits") {
  const double speed = GENERATE(100.0, 1000.0, 10000.0);
  const double thickness = GENERATE(0.1, 0.6);
  const TriangleMesh sheet = bentSheet();
  const TriangleMesh plate = tests::boxMesh(Vec3(2.0, 2.0, 0.5 * thickness));
  Collider box;
  box.shape = sim::BoxShape{Vec3(2.0, 2.0, 0.5 * thickness)};
  for (auto [collider, mesh] : {std::pair(meshed(sheet, thickness), &sheet),
                                std::pair(meshed(plate, 0.0), &plate), std::pair(box, &plate)}) {
    collider.stiffness = 1e5;
    for (const double step : {1e-5, 1e-4}) {
      sim::Settings settings = tests::losslessSettings();
      settings.step = step;
      const auto flight = tests::simulation(stonesAt(*mesh, speed, 96), settings, only(collider));
      const double kinetic = flight->snapshot().ledger.energy.kinetic;
      CHECK(countCrossings(*flight, collider, std::min(400.0 * step, 8.0 / speed)) == 0);
      CHECK(flight->maxRise() < 1e-3);
      // Springs of 1e5, of the push and of friction, begin and end within steps of up to a seventh of a swing
      // of the lightest.
      CHECK(std::abs(flight->snapshot().ledger.energy.residual) < 1.5e-4 * kinetic);
    }
  }
}

TEST_CASE("no method and no automatic step lets a stone through a sheet") {
  const auto method =
      GENERATE(sim::Method::symplecticEuler, sim::Method::velocityVerlet, sim::Method::rungeKutta,
               sim::Method::implicitEuler, sim::Method::implicitMidpoint);
  Collider sheet = meshed(bentSheet(), 0.2);
  sheet.stiffness = 1e5;
  sim::Settings settings = tests::losslessSettings();
  settings.method = method;
  const auto flight = tests::simulation(stonesAt(meshOf(sheet), 2000.0, 48), settings, only(sheet));
  const double kinetic = flight->snapshot().ledger.energy.kinetic;
  CHECK(countCrossings(*flight, sheet, 4e-3) == 0);
  CHECK(flight->snapshot().ledger.energy.kinetic < kinetic);
}

TEST_CASE("a sheet that is swung takes stones along and lets none through") {
  Collider sheet = meshed(bentSheet(), 0.1);
  sheet.stiffness = 1e5;
  sim::Blueprint stones = stonesAt(meshOf(sheet), 0.0, 60);
  for (sim::Blueprint::Node& stone : stones.nodes)
    stone.position = Vec3(0.45 * stone.position.x(), 0.45 * stone.position.y(), 3.0);
  sim::Track swing;
  swing.target = sim::TrackTarget::colliderPosition;
  swing.object = 0;
  swing.interpolation = sim::Interpolation::linear;
  swing.keys = {{0.0, Vec3::Zero()}, {0.01, Vec3(0.0, 0.0, 20.0)}};
  sim::Settings settings = tests::losslessSettings();
  settings.step = 2e-5;
  const auto swung = tests::simulation(stones, settings, only(sheet), {swing});
  tests::run(*swung, 0.009);
  const sim::Snapshot end = swung->snapshot();
  int carried = 0;
  for (std::size_t n = 0; n < end.positions.size(); ++n) {
    const Vec3 place = end.positions[n] - Vec3(0.0, 0.0, 18.0);
    if (std::max(std::abs(place.x()), std::abs(place.y())) > 1.9) continue;
    ++carried;
    CHECK_FALSE(passesThrough(meshOf(sheet), place, place + Vec3(0.0, 0.0, 100.0)));
    CHECK(end.velocities[n].z() > 1999.0);
  }
  CHECK(carried > 20);
  CHECK(std::abs(end.ledger.energy.residual) < 1e-3 * end.ledger.energy.outsideWork);
}

/// A block much softer than the blow, which falls on the middle of a thin plate.
tests::Block fallingBlock(double speed) {
  tests::Block block{.nx = 5, .ny = 4, .nz = 3, .spacing = 0.5, .youngsModulus = 1e6, .dampingTime = 2e-5};
  block.corner = Vec3(-1.2, -1.1, 0.6);
  block.velocity = Vec3(0.0, 0.0, -speed);
  return block;
}

TEST_CASE("a soft block at 100 m/s does not get through a thin plate, and all it loses is accounted for") {
  const bool breaks = GENERATE(false, true);
  tests::Block block = fallingBlock(10000.0);
  if (breaks) block.material.thresholdMean = 0.2;
  const Vec3 halfSize(4.0, 4.0, 0.25);
  Collider box;
  box.shape = sim::BoxShape{halfSize};
  for (const Collider& plate :
       {box, meshed(tests::boxMesh(halfSize), 0.0), meshed(tests::sheetMesh(4.0), 0.5)}) {
    std::array<std::uint64_t, 2> hashes{};
    for (const int threads : {1, 2}) {
      sim::Settings settings = tests::losslessSettings();
      settings.threads = threads;
      const auto fall = tests::simulation(tests::block(block), settings, only(plate));
      const double kinetic = fall->snapshot().ledger.energy.kinetic;
      int under = 0;
      while (fall->time() < 1e-3) {
        REQUIRE(fall->stepOnce().ok());
        for (const Vec3& place : fall->snapshot().positions) under += place.z() < 0.0 ? 1 : 0;
      }
      CHECK(under == 0);
      CHECK(fall->maxRise() < 1e-3);
      // Cells are turned inside out in a tenth of a step, which no step resolves.
      CHECK(std::abs(fall->snapshot().ledger.energy.residual) < 5e-3 * kinetic);
      hashes[static_cast<std::size_t>(threads - 1)] = fall->stateHash();
    }
    CHECK(hashes[0] == hashes[1]);
  }
}

TEST_CASE("a heavy block does not press a crumb through the thin plate that both lie on") {
  tests::Block heavy{
      .nx = 3, .ny = 3, .nz = 3, .spacing = 0.5, .youngsModulus = 1e7, .density = 20.0, .dampingTime = 1e-5};
  heavy.corner = Vec3(-0.75, -0.75, 0.8);
  heavy.velocity = Vec3(0.0, 0.0, -500.0);
  tests::Block small{.nx = 1, .ny = 1, .nz = 1, .spacing = 0.3, .youngsModulus = 1e7, .dampingTime = 1e-5};
  small.corner = Vec3(-0.1, -0.15, 0.1);
  sim::Blueprint blueprint = tests::block(heavy);
  tests::append(blueprint, tests::block(small));
  sim::Environment environment = only(meshed(tests::sheetMesh(4.0), 0.1));
  environment.gravity = Vec3(0.0, 0.0, -5000.0);
  const auto press = tests::simulation(std::move(blueprint), sim::Settings{}, environment);
  double lowest = 1.0;
  for (double time = 1e-4; time < 0.05; time += 1e-4) {
    tests::run(*press, time);
    for (const Vec3& place : press->snapshot().positions) lowest = std::min(lowest, place.z());
  }
  CHECK(lowest > 0.0);
}

TEST_CASE("rigid pieces and single nodes are held up like all others") {
  // A stiff block comes to rest on a sheet too weak for its springs to carry it.
  tests::Block block{.nx = 3, .ny = 3, .nz = 3, .spacing = 0.5, .youngsModulus = 1e7, .dampingTime = 1e-5};
  block.corner = Vec3(-0.75, -0.75, 0.3);
  Collider sheet = meshed(tests::sheetMesh(4.0), 0.2);
  sheet.stiffness = 10.0;
  sim::Environment environment = only(sheet);
  environment.gravity = Vec3(0.0, 0.0, -981.0);
  const auto rest = tests::simulation(tests::block(block), sim::Settings{}, environment);
  double lowest = 1.0;
  for (double time = 1e-3; time < 0.3; time += 1e-3) {
    tests::run(*rest, time);
    for (const Vec3& place : rest->snapshot().positions) lowest = std::min(lowest, place.z());
  }
  CHECK(lowest > 0.0);
  CHECK(lowest < 0.1);
}

TEST_CASE("a mesh knows how thick it is where it is thinnest") {
  CHECK(tests::boxMesh(Vec3(2.0, 1.0, 0.05)).leastThickness() == Approx(0.1));
  CHECK(tests::sheetMesh(1.0).leastThickness() == 0.0);
  // From face to face of the ball's polyhedron.
  CHECK(tests::ballMesh(2.0, 20).leastThickness() == Approx(4.0).epsilon(0.02));
}

}  // namespace
