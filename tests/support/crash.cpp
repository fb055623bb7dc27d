#include "tests/support/crash.h"

#include "tests/support/meshes.h"

namespace tests {
namespace {

sim::Track track(sim::TrackTarget target, std::uint32_t object, sim::Interpolation interpolation,
                 std::vector<sim::Track::Key> keys) {
  sim::Track track;
  track.target = target;
  track.object = object;
  track.interpolation = interpolation;
  track.keys = std::move(keys);
  return track;
}

sim::Environment surroundings(const CrashOptions& options) {
  sim::Environment environment = earth();
  if (!options.onSheet) return environment;
  sim::Collider& sheet = environment.colliders.front();
  sheet.shape = sim::SurfaceShape{std::make_shared<const sim::TriangleMesh>(sheetMesh(30.0)), 0.1};
  return environment;
}

}  // namespace

std::unique_ptr<sim::Simulation> crash(const CrashOptions& options) {
  const unsigned size = options.large ? 20 : 4;
  Block plastic{.nx = size, .ny = size, .nz = 2, .youngsModulus = 1e7, .density = 1.0, .dampingTime = 2e-6};
  plastic.material = {.name = "clay", .yieldStrain = 0.01, .flowRate = 2e3};
  Block brittle{.nx = 3, .ny = 3, .nz = size, .youngsModulus = 1e7, .density = 1.0, .dampingTime = 1e-6};
  brittle.distortion = 0.2;
  brittle.material = {.name = "glass", .thresholdMean = 0.02, .thresholdSpread = 0.3};
  brittle.corner = sim::Vec3(0.3, 0.2, 2.05);
  brittle.velocity = sim::Vec3(60.0, 0.0, -600.0);
  sim::Blueprint blueprint = block(plastic);
  append(blueprint, block(brittle));

  sim::Settings settings;
  settings.threads = options.threads;
  settings.seed = options.seed;
  settings.method = options.method;
  settings.tolerance = options.tolerance;
  const std::vector<sim::Track> tracks = {
      track(sim::TrackTarget::gravityScale, sim::kNone, sim::Interpolation::smooth,
            {{0.0, sim::Vec3::UnitX()}, {0.002, 50.0 * sim::Vec3::UnitX()}}),
      track(sim::TrackTarget::stiffnessScale, 1, sim::Interpolation::linear,
            {{0.001, sim::Vec3::UnitX()}, {0.002, 0.7 * sim::Vec3::UnitX()}}),
      track(sim::TrackTarget::colliderPosition, 0, sim::Interpolation::linear,
            {{0.0005, sim::Vec3::Zero()}, {0.0025, sim::Vec3(0.0, 0.0, 0.3)}})};
  return simulation(std::move(blueprint), settings, surroundings(options), tracks);
}

}  // namespace tests
