#include "app/bench/stability_cases.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "modeling/assembly/assembly.h"
#include "modeling/shapes/slab.h"
#include "sim/base/random.h"
#include "sim/methods/method_names.h"

namespace app {
namespace {

using sim::Vec3;

/// A bar of 3 x 3 x 8 cells and what may be unusual about it.
struct Bar {
  Vec3 cell = Vec3::Constant(0.5);  ///< cm
  std::array<int, 3> counts{3, 3, 8};
  double distortion = 0.0;  ///< of each node, relative to the cell
  double massRatio = 1.0;   ///< of the upper half's nodes to the lower's
  modeling::Material material;
  double stretching = 0.01;  ///< speed at which the ends fly apart, over the speed of sound
  double falling = 0.0;      ///< cm/s
  double height = 0.0;       ///< cm above z = 0
  int copies = 1;            ///< side by side in a cube of copies^3
};

struct World {
  Bar bar;
  sim::Settings settings;
  sim::Environment environment;
  std::vector<sim::Track> tracks;
};

World weightless() {
  World world;
  world.bar.material.name = "ceramic";
  world.bar.material.youngsModulus = 1e9;
  world.environment.gravity = Vec3::Zero();
  world.settings.threads = 1;
  return world;
}

World onFloor() {
  World world = weightless();
  world.environment = sim::Environment{};
  world.environment.colliders.emplace_back().name = "floor";
  world.bar.stretching = 0.0;
  world.bar.height = 0.01;
  world.bar.falling = 200.0;
  return world;
}

sim::Result<modeling::Lattice> latticeOf(const Bar& bar) {
  modeling::SlabShape shape;
  for (int axis = 0; axis < 3; ++axis) {
    shape.size[axis] = bar.cell[axis] * bar.counts[static_cast<std::size_t>(axis)];
    shape.resolution.counts[static_cast<std::size_t>(axis)] = bar.counts[static_cast<std::size_t>(axis)];
  }
  auto lattice = modeling::build(shape);
  if (!lattice) return lattice;
  for (std::size_t node = 0; node < lattice->nodes.size(); ++node) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      // A corner moves by up to half of the distortion each way, so that two neighbours near by all of it.
      lattice->nodes[node][a] += bar.distortion * bar.cell[a] * (sim::uniformAt(7, 3 * node + axis) - 0.5);
    }
  }
  return lattice;
}

sim::Result<sim::Network> networkOf(const Bar& bar, std::uint64_t seed) {
  auto lattice = latticeOf(bar);
  if (!lattice) return lattice.problem();
  const Vec3 size = bar.cell.cwiseProduct(Vec3(bar.counts[0], bar.counts[1], bar.counts[2]));
  std::vector<modeling::AssemblyPart> parts;
  modeling::GlueResult glue;
  for (int copy = 0; copy < bar.copies * bar.copies * bar.copies; ++copy) {
    const int row = copy / bar.copies;
    const int layer = row / bar.copies;
    const Vec3 place(copy % bar.copies, row % bar.copies, layer);
    modeling::AssemblyPart part;
    part.name = "bar " + std::to_string(copy);
    part.lattice = *lattice;
    for (Vec3& node : part.lattice.nodes)
      node += place.cwiseProduct(size + 1.05 * bar.cell) + Vec3(0.0, 0.0, bar.height);
    std::vector<sim::NodeIndex> global;
    for (std::size_t i = 0; i < part.lattice.nodes.size(); ++i)
      global.push_back(static_cast<sim::NodeIndex>(glue.nodeCount++));
    glue.globalNode.push_back(std::move(global));
    glue.gluedBy.emplace_back(part.lattice.nodes.size(), sim::kNone);
    glue.droppedCells.emplace_back();
    glue.misshapen.emplace_back();
    parts.push_back(std::move(part));
  }
  auto blueprint = modeling::assemble(parts, {bar.material}, glue);
  if (!blueprint) return blueprint.problem();
  const double sound = std::sqrt(bar.material.youngsModulus / bar.material.density);
  for (sim::Blueprint::Node& node : blueprint->nodes) {
    const double along = 2.0 * (node.position.z() - bar.height) / size.z() - 1.0;
    node.velocity = Vec3(0.0, 0.0, bar.stretching * sound * along - bar.falling);
    if (along > 0.0) node.mass *= bar.massRatio;
  }
  return sim::buildNetwork(std::move(*blueprint), seed);
}

class Cases {
 public:
  explicit Cases(bool small) : small_(small) {}

  void add(const char* group, const char* format, double value, const World& world, int steps = 2000) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    add(group, std::string(text), world, steps);
  }
  void add(const char* group, const std::string& value, const World& world, int steps = 2000) {
    StabilityCase made;
    made.group = group;
    made.value = value;
    made.method = std::string(sim::nameOf(world.settings.method));
    made.start = [world]() -> sim::Result<std::unique_ptr<sim::Simulation>> {
      auto network = networkOf(world.bar, world.settings.seed);
      if (!network) return network.problem();
      return sim::Simulation::create(std::move(*network), world.environment, world.tracks, world.settings);
    };
    made.free =
        world.environment.colliders.empty() && world.environment.gravity.isZero() && world.tracks.empty();
    made.floor = world.environment.colliders.empty() ? 0.0 : world.bar.cell.maxCoeff();
    made.steps = steps;
    cases.push_back(std::move(made));
  }
  /// All of them, or the two extreme ones.
  std::vector<double> values(std::vector<double> all) const {
    return small_ ? std::vector<double>{all.front(), all.back()} : all;
  }
  bool small() const { return small_; }

  std::vector<StabilityCase> cases;

 private:
  bool small_;
};

void addMaterials(Cases& cases) {
  for (const double k : cases.values({1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13})) {
    World world = weightless();
    world.bar.material.youngsModulus = k / (0.6 * world.bar.cell.x());
    cases.add("stiffness of an edge, dyn/cm", "%.0e", k, world);
  }
  for (const double zeta : cases.values({0.0, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0})) {
    World world = weightless();
    world.bar.material.lossFactor = 2.0 * zeta;
    cases.add("damping over critical", "%g", zeta, world);
  }
  for (const double ratio : cases.values({1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6})) {
    World world = weightless();
    world.bar.massRatio = ratio;
    cases.add("ratio of masses in one body", "%g", ratio, world);
  }
  for (const double threshold : cases.values({1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0})) {
    World world = onFloor();
    world.bar.material.threshold = {.mean = threshold, .spread = 0.2};
    cases.add("threshold, falling at 2 m/s", "%g", threshold, world);
  }
}

void addShapes(Cases& cases) {
  for (const double share : cases.values({0.1, 0.2, 0.3, 0.4})) {
    World world = weightless();
    world.bar.distortion = share;
    cases.add("cells distorted by, of an edge", "%g", share, world);
  }
  for (const double ratio : cases.values({2.0, 5.0, 10.0, 20.0})) {
    World world = weightless();
    world.bar.cell = Vec3(0.5, 0.5, 0.5 * ratio);
    cases.add("slivers, length over width", "%g", ratio, world);
    world.bar.cell = Vec3(0.5 * ratio, 0.5 * ratio, 0.5);
    cases.add("plates, width over thickness", "%g", ratio, world);
  }
}

void addBlows(Cases& cases) {
  for (const double speed : cases.values({100.0, 300.0, 1e3, 3e3, 1e4})) {
    World world = onFloor();
    world.bar.falling = speed;
    world.bar.material.youngsModulus = 6.5e11;
    cases.add("porcelain that never breaks into the floor, cm/s", "%g", speed, world);
    world.bar.material.threshold = {.mean = 1e-3, .spread = 0.2};
    cases.add("porcelain into the floor, cm/s", "%g", speed, world);
    world.bar.material = onFloor().bar.material;
    world.bar.material.threshold = {.mean = 0.1, .spread = 0.2};
    cases.add("soft ceramic into the floor, cm/s", "%g", speed, world);
  }
  World heap = onFloor();
  heap.bar.counts = {1, 1, 1};
  heap.bar.copies = cases.small() ? 4 : 10;
  cases.add("fragments piled", std::to_string(heap.bar.copies * heap.bar.copies * heap.bar.copies), heap,
            1500);
}

sim::Track jump(sim::TrackTarget target, double from, double to) {
  sim::Track track;
  track.target = target;
  track.interpolation = sim::Interpolation::step;
  track.keys = {{0.0, Vec3(from, 0.0, 0.0)}, {1e-3, Vec3(to, 0.0, 0.0)}};
  return track;
}

void addControls(Cases& cases) {
  for (const double factor : cases.values({10.0, 1000.0})) {
    World world = onFloor();
    world.bar.falling = 0.0;
    world.tracks = {jump(sim::TrackTarget::gravityScale, 1.0, factor)};
    cases.add("gravity jumps by", "%g", factor, world);
    world.tracks = {jump(sim::TrackTarget::stiffnessScale, 1.0, factor)};
    world.bar.stretching = 0.001;
    cases.add("stiffness jumps by", "%g", factor, world);
    world.tracks = {jump(sim::TrackTarget::stiffnessScale, 1.0, 1.0 / factor)};
    cases.add("stiffness jumps by one over", "%g", factor, world);
  }
  for (const std::string& method : sim::methodNames()) {
    for (const double safety : cases.values({0.1, 0.3, 0.5, 0.7, 0.9})) {
      World world = weightless();
      world.settings.method = *sim::methodFromName(method);
      world.settings.safety = safety;
      // A step of an implicit method costs as much as hundreds of others.
      const int steps = method.starts_with("implicit") || cases.small() ? 100 : 2000;
      cases.add("step safety", "%g", safety, world, steps);
    }
  }
}

double momentumScale(const sim::Network& network) {
  double sum = 0.0;
  for (std::size_t node = 0; node < network.nodeCount(); ++node)
    sum += network.masses[node] * network.velocities[node].norm();
  return sum;
}

double deepestOf(const sim::Snapshot& snapshot) {
  double deepest = 0.0;
  for (const Vec3& position : snapshot.positions) deepest = std::max(deepest, -position.z());
  return deepest;
}

bool isFinite(const sim::Snapshot& snapshot) {
  return std::all_of(snapshot.positions.begin(), snapshot.positions.end(),
                     [](const Vec3& position) { return position.allFinite(); });
}

}  // namespace

std::vector<StabilityCase> stabilityCases(bool small) {
  Cases cases(small);
  addMaterials(cases);
  addShapes(cases);
  addBlows(cases);
  addControls(cases);
  return std::move(cases.cases);
}

StabilityResult judge(const StabilityCase& stabilityCase) {
  StabilityResult result;
  auto simulation = stabilityCase.start();
  if (!simulation) {
    result.reason = "refused: " + simulation.problem().line();
    return result;
  }
  sim::Simulation& running = **simulation;
  const sim::LedgerRow before = running.snapshot().ledger;
  constexpr int kLooks = 20;
  for (int look = 0; look < kLooks && result.reason.empty(); ++look) {
    sim::Status status = sim::Done{};
    for (int step = 0; step < stabilityCase.steps / kLooks && status; ++step) status = running.stepOnce();
    if (!status) result.reason = "blown up: " + status.problem().line();
    const sim::Snapshot now = running.snapshot();
    if (!isFinite(now)) result.reason = "not finite";
    if (stabilityCase.floor > 0.0) result.deepest = std::max(result.deepest, deepestOf(now));
    if (stabilityCase.free)
      result.momentumError =
          std::max(result.momentumError, (now.ledger.linearMomentum - before.linearMomentum).norm() /
                                             momentumScale(running.network()));
  }
  result.maxRise = running.maxRise();
  if (!result.reason.empty()) return result;
  if (!(result.maxRise < kMostRise)) result.reason = "energy rose";
  if (!(result.momentumError < kMostMomentumError)) result.reason = "momentum changed";
  if (result.deepest > stabilityCase.floor) result.reason = "went through the floor";
  result.passed = result.reason.empty();
  return result;
}

}  // namespace app
