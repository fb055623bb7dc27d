#include "ui/session/builder.h"

#include <charconv>
#include <numeric>
#include <string_view>

#include "sim/surface/surface_mesh.h"

namespace ui {
namespace {

using Built = sim::Result<modeling::BuiltScene>;

void take(modeling::BuiltScene built, Preview& preview) {
  // Obstacles can be drawn now.
  std::vector<modeling::Gluing> glue = std::move(preview.scene.glue);
  preview.scene = built.scene;
  preview.scene.glue = std::move(glue);
  preview.rest = std::make_shared<const sim::Snapshot>(sim::momentAtRest(built.network));
  auto shared = std::make_shared<const modeling::BuiltScene>(std::move(built));
  (preview.failedGluings.empty() ? preview.built : preview.unglued) = std::move(shared);
}

/// Which gluing of the scene a problem is about.
std::optional<std::size_t> gluingOf(const sim::Problem& problem, const modeling::Scene& scene) {
  constexpr std::string_view kGlue = "glue[";
  if (!problem.place.starts_with(kGlue)) return std::nullopt;
  std::size_t index = scene.glue.size();
  std::from_chars(problem.place.data() + kGlue.size(), problem.place.data() + problem.place.size(), index);
  return index < scene.glue.size() ? std::optional(index) : std::nullopt;
}

/// Gluings that fail are left out, one after the other, so that what they were to join can be seen.
sim::Status buildInto(const std::filesystem::path& folder, const modeling::Attendance& attendance,
                      Preview& preview) {
  modeling::Scene scene = preview.scene;
  std::vector<std::size_t> places(scene.glue.size());  // in preview.scene, of those that are left
  std::iota(places.begin(), places.end(), std::size_t{0});
  Built built = modeling::build(scene, folder, attendance);
  while (!built && !attendance.gaveUp()) {
    const std::optional<std::size_t> failed = gluingOf(built.problem(), scene);
    if (!failed) break;
    const auto at = static_cast<std::ptrdiff_t>(*failed);
    preview.failedGluings.push_back({places[*failed], built.problem()});
    scene.glue.erase(scene.glue.begin() + at);
    places.erase(places.begin() + at);
    built = modeling::build(scene, folder, attendance);
  }
  if (!built && preview.failedGluings.empty()) return built.problem();
  if (built) take(std::move(built).value(), preview);
  return preview.failedGluings.empty() ? sim::Status(sim::Done{}) : preview.failedGluings.front().problem;
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
