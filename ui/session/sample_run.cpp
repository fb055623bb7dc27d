#include "ui/session/sample_run.h"

#include "modeling/scene/build.h"
#include "sim/dynamics/simulation.h"

namespace ui {

namespace {

using modeling::Vec3;

constexpr double kSpeed = 500.0;  // cm/s: a fall from the height of a person
const Vec3 kSize(9.0, 2.0, 0.8);
constexpr double kCell = 0.5;

modeling::Scene sampleScene(const modeling::Material& material) {
  modeling::Scene scene;
  scene.materials.push_back({material.name, "", material});
  modeling::Part bar;
  bar.name = "bar";
  bar.material = material.name;
  bar.shape = modeling::SlabShape{kSize, {kCell, {}}};
  bar.worldFromPart.position = Vec3(0.0, 0.0, SampleRun::kRodRadius + 0.3);
  bar.velocity = Vec3(0.0, 0.0, -kSpeed);
  scene.parts.push_back(std::move(bar));
  modeling::SceneCollider rod;
  rod.name = "rod";
  rod.form = modeling::CylinderShape{SampleRun::kRodRadius, 10.0};
  rod.rotation.value = Vec3(90.0, 0.0, 0.0);
  scene.environment.colliders.push_back(std::move(rod));
  return scene;
}

/// Bit by bit, so that a stop is heeded soon however small the step is.
template <class Job>
sim::Status advance(sim::Simulation& simulation, double until, const Job& job) {
  constexpr int kBits = 20;
  const double from = simulation.time();
  for (int bit = 1; bit <= kBits && !job.cancelled(); ++bit) {
    if (sim::Status status = simulation.advanceTo(from + (until - from) * bit / kBits); !status)
      return status;
  }
  return sim::Done{};
}

template <class Job>
sim::Status run(const modeling::Material& material, Job& job) {
  sim::Result<modeling::BuiltScene> built = modeling::build(sampleScene(material), {});
  if (!built) return built.problem();
  sim::Settings settings = built->conditions.settings;
  settings.threads = 1;  // it must not slow what the person waits for
  sim::Result<std::unique_ptr<sim::Simulation>> simulation =
      sim::Simulation::create(std::move(built->network), built->conditions.environment, {}, settings);
  if (!simulation) return simulation.problem();
  sim::Simulation& running = **simulation;
  sim::SurfaceBuilder surface(running.network());
  for (int frame = 0; frame < SampleRun::kFrames && !job.cancelled(); ++frame) {
    const double until = SampleRun::kDuration * frame / (SampleRun::kFrames - 1);
    if (frame > 0) {
      if (const sim::Status status = advance(running, until, job); !status) return status;
    }
    job.value.frames.push_back(std::make_shared<const sim::SurfaceMesh>(surface.build(running.snapshot())));
    job.value.broke = running.brokenBondCount() > 0;
    job.publish();
  }
  return sim::Done{};
}

}  // namespace

SampleRun::SampleRun()
    : worker_([](const modeling::Material& material, auto& job) { return run(material, job); }) {}

void SampleRun::start(const modeling::Material& material) {
  started_ = worker_.request(material);
}

void SampleRun::stop() {
  worker_.cancel();
  started_ = 0;
}

SampleRun::View SampleRun::view() const {
  const auto answer = worker_.newest();
  if (started_ == 0 || answer->request != started_) return {};
  View view = answer->value;
  view.done = answer->ended;
  view.problem = answer->problem;
  return view;
}

}  // namespace ui
