#include "ui/session/frame_loader.h"

#include <exception>

namespace ui {
namespace {

void load(FrameLoader::Loaded& wanted) {
  try {
    sim::Result<sim::SnapshotPointer> moment = wanted.footage->frame(wanted.frame);
    if (moment) {
      wanted.moment = std::move(moment).value();
    } else {
      wanted.problem = moment.problem();
    }
  } catch (const std::exception& exception) {
    wanted.problem = sim::Problem{wanted.footage->file().string(),
                                  std::string("the frame could not be read: ") + exception.what(), ""};
  }
}

}  // namespace

FrameLoader::FrameLoader() : runner_([this] { main(); }) {}

FrameLoader::~FrameLoader() {
  const std::lock_guard lock(mutex_);
  ending_ = true;
  changed_.notify_all();
}

void FrameLoader::request(std::shared_ptr<Footage> footage, std::size_t frame) {
  const std::lock_guard lock(mutex_);
  wanted_ = Loaded{std::move(footage), frame, nullptr, std::nullopt};
  changed_.notify_all();
}

std::optional<FrameLoader::Loaded> FrameLoader::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(loaded_, std::nullopt);
}

void FrameLoader::gatherNotes(std::shared_ptr<Footage> footage) {
  const std::lock_guard lock(mutex_);
  unnoted_ = std::move(footage);
  changed_.notify_all();
}

void FrameLoader::main() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return ending_ || wanted_ || unnoted_; });
    if (ending_) return;
    if (wanted_) {
      Loaded next = std::move(*wanted_);
      wanted_.reset();
      lock.unlock();
      load(next);
      lock.lock();
      loaded_ = std::move(next);
      continue;
    }
    const std::shared_ptr<Footage> footage = unnoted_;
    lock.unlock();
    const bool more = footage->readNextNote();
    lock.lock();
    if (!more && unnoted_ == footage) unnoted_.reset();
  }
}

}  // namespace ui
