#include "ui/session/builder.h"

#include "sim/surface/surface_mesh.h"

namespace ui {
namespace {

sim::Status buildInto(const std::filesystem::path& folder, const modeling::Attendance& attendance,
                      Preview& preview) {
  sim::Result<modeling::BuiltScene> built = modeling::build(preview.scene, folder, attendance);
  if (!built) return built.problem();
  preview.rest = std::make_shared<const sim::Snapshot>(sim::momentAtRest(built->network));
  preview.scene = built->scene;  // obstacles can be drawn now
  preview.built = std::make_shared<const modeling::BuiltScene>(std::move(built).value());
  return sim::Done{};
}

}  // namespace

Builder::Builder()
    : worker_([talk = talk_](const Request& request, auto& job) -> sim::Status {
        Preview& preview = job.value;
        preview.scene = request.scene;
        if (request.scene.parts.empty()) return sim::Done{};
        const auto say = [&](const std::string& words) {
          const std::lock_guard lock(talk->mutex);
          talk->waitingFor = words;
        };
        talk->givenUp = false;
        const modeling::Attendance attendance{say, [&] { return job.cancelled() || talk->givenUp; }};
        const sim::Status built = guarded([&] { return buildInto(request.folder, attendance, preview); });
        say("");
        if (!built) preview.problem = built.problem();
        preview.isAbandoned = !built && job.cancelled();
        return built;
      }) {}

void Builder::request(const modeling::Scene& scene, const std::filesystem::path& folder) {
  worker_.request({scene, folder});
}

std::shared_ptr<const Preview> Builder::newest() const {
  const auto answer = worker_.newest();
  if (!answer->value.isAbandoned) kept_ = {answer, &answer->value};
  return kept_;
}

std::string Builder::waitingFor() const {
  const std::lock_guard lock(talk_->mutex);
  return talk_->waitingFor;
}

void Builder::giveUp() {
  talk_->givenUp = true;
}

}  // namespace ui
