#include "ui/session/builder.h"

#include "sim/surface/surface_mesh.h"

namespace ui {
namespace {

sim::Status buildInto(const std::filesystem::path& folder, Preview& preview) {
  sim::Result<modeling::BuiltScene> built = modeling::build(preview.scene, folder);
  if (!built) return built.problem();
  preview.rest = std::make_shared<const sim::Snapshot>(sim::momentAtRest(built->network));
  preview.scene = built->scene;  // obstacles can be drawn now
  preview.built = std::make_shared<const modeling::BuiltScene>(std::move(built).value());
  return sim::Done{};
}

}  // namespace

Builder::Builder()
    : worker_([](const Request& request, auto& job) -> sim::Status {
        Preview& preview = job.value;
        preview.scene = request.scene;
        if (request.scene.parts.empty()) return sim::Done{};
        const sim::Status built = guarded([&] { return buildInto(request.folder, preview); });
        if (!built) preview.problem = built.problem();
        return built;
      }) {}

void Builder::request(const modeling::Scene& scene, const std::filesystem::path& folder) {
  worker_.request({scene, folder});
}

std::shared_ptr<const Preview> Builder::newest() const {
  const auto answer = worker_.newest();
  return {answer, &answer->value};
}

}  // namespace ui
