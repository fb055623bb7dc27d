#include "ui/session/frame_loader.h"

namespace ui {

FrameLoader::FrameLoader()
    : frames_([](const Request& request, auto& job) -> sim::Status {
        job.value.footage = request.footage;
        job.value.frame = request.frame;
        sim::Result<sim::SnapshotPointer> moment = request.footage->frame(request.frame);
        if (!moment) return moment.problem();
        job.value.moment = std::move(moment).value();
        return sim::Done{};
      }),
      notes_([](const std::shared_ptr<Footage>& footage, auto& job) -> sim::Status {
        while (!job.cancelled() && footage->readNextNote()) continue;
        return sim::Done{};
      }) {}

void FrameLoader::request(std::shared_ptr<Footage> footage, std::size_t frame) {
  frames_.request({std::move(footage), frame});
}

std::optional<FrameLoader::Loaded> FrameLoader::take() {
  const auto answer = frames_.newest();
  if (!answer->ended || answer->request == taken_) return std::nullopt;
  taken_ = answer->request;
  if (!answer->value.moment && !answer->problem) return std::nullopt;  // a newer one is under way
  Loaded loaded = answer->value;
  loaded.problem = answer->problem;
  return loaded;
}

void FrameLoader::gatherNotes(std::shared_ptr<Footage> footage) {
  notes_.request(std::move(footage));
}

void FrameLoader::requestStop() {
  frames_.requestStop();
  notes_.requestStop();
}

}  // namespace ui
