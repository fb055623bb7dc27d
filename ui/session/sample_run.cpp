#include "ui/session/sample_run.h"

#include <mutex>

#include "modeling/scene/build.h"
#include "sim/dynamics/simulation.h"
#include "ui/session/background.h"

namespace ui {

struct SampleRun::Shared {
  mutable std::mutex mutex;
  View view;

  void add(std::shared_ptr<const sim::SurfaceMesh> mesh, bool broke) {
    const std::lock_guard lock(mutex);
    view.frames.push_back(std::move(mesh));
    view.broke = broke;
  }
  void finish(std::optional<sim::Problem> problem) {
    const std::lock_guard lock(mutex);
    view.problem = std::move(problem);
    view.done = true;
  }
};

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
sim::Status advance(sim::Simulation& simulation, double until, const std::stop_token& stop) {
  constexpr int kBits = 20;
  const double from = simulation.time();
  for (int bit = 1; bit <= kBits && !stop.stop_requested(); ++bit) {
    if (sim::Status status = simulation.advanceTo(from + (until - from) * bit / kBits); !status)
      return status;
  }
  return sim::Done{};
}

template <class Report>
std::optional<sim::Problem> run(const modeling::Material& material, const std::stop_token& stop,
                                const Report& report) {
  sim::Result<modeling::BuiltScene> built = modeling::build(sampleScene(material), {});
  if (!built) return built.problem();
  sim::Settings settings = built->conditions.settings;
  settings.threads = 1;  // it must not slow what the person waits for
  sim::Result<std::unique_ptr<sim::Simulation>> simulation =
      sim::Simulation::create(std::move(built->network), built->conditions.environment, {}, settings);
  if (!simulation) return simulation.problem();
  sim::Simulation& running = **simulation;
  sim::SurfaceBuilder surface(running.network());
  for (int frame = 0; frame < SampleRun::kFrames && !stop.stop_requested(); ++frame) {
    const double until = SampleRun::kDuration * frame / (SampleRun::kFrames - 1);
    if (frame > 0) {
      if (const sim::Status status = advance(running, until, stop); !status) return status.problem();
    }
    report(std::make_shared<const sim::SurfaceMesh>(surface.build(running.snapshot())),
           running.brokenBondCount() > 0);
  }
  return std::nullopt;
}

}  // namespace

SampleRun::~SampleRun() {
  stop();
}

void SampleRun::start(const modeling::Material& material) {
  stop();
  std::erase_if(runs_, [](const Run& run) {
    const std::lock_guard lock(run.shared->mutex);
    return run.shared->view.done;
  });
  shared_ = std::make_shared<Shared>();
  runs_.push_back({shared_, std::jthread([shared = shared_, material](const std::stop_token& stop) {
                     giveWayToTheWindow();
                     std::optional<sim::Problem> problem;
                     try {
                       problem = run(material, stop,
                                     [&](auto mesh, bool broke) { shared->add(std::move(mesh), broke); });
                     } catch (const std::exception& exception) {
                       problem = sim::Problem{"", std::string("the sample failed: ") + exception.what(), ""};
                     }
                     shared->finish(std::move(problem));
                   })});
}

void SampleRun::stop() {
  // Nobody waits here: a thread that was told to end does so by itself, and is joined when it has.
  for (Run& run : runs_) run.thread.request_stop();
  shared_.reset();
}

SampleRun::View SampleRun::view() const {
  if (!shared_) return {};
  const std::lock_guard lock(shared_->mutex);
  return shared_->view;
}

}  // namespace ui
