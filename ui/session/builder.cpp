#include "ui/session/builder.h"

#include <chrono>
#include <exception>

#include "sim/surface/surface_mesh.h"
#include "ui/session/background.h"

namespace ui {
namespace {

struct Request {
  std::uint64_t revision = 0;
  modeling::Scene scene;
  std::filesystem::path folder;
};

/// A problem that is the program's or the machine's fault becomes words here, as no exception may leave a
/// thread.
std::optional<sim::Problem> buildInto(const Request& request, Preview& preview) {
  try {
    sim::Result<modeling::BuiltScene> built = modeling::build(request.scene, request.folder);
    if (!built) return built.problem();
    preview.built = std::make_shared<const modeling::BuiltScene>(std::move(built).value());
    preview.scene = preview.built->scene;  // obstacles can be drawn now
    preview.rest = std::make_shared<const sim::Snapshot>(sim::momentAtRest(preview.built->network));
    return std::nullopt;
  } catch (const std::bad_alloc&) {
    return sim::Problem{"", "there is not enough memory for this scene", "use larger cells"};
  } catch (const std::exception& exception) {
    return sim::Problem{"", std::string("the scene could not be built: ") + exception.what(),
                        "undo the edit"};
  }
}

}  // namespace

class Builder::Thread {
 public:
  std::uint64_t request(const modeling::Scene& scene, const std::filesystem::path& folder) {
    const std::lock_guard lock(mutex_);
    wanted_ = Request{++revisions_, scene, folder};
    changed_.notify_all();
    return revisions_;
  }

  std::shared_ptr<const Preview> newest() const {
    const std::lock_guard lock(mutex_);
    return newest_;
  }

  bool isBusy() const {
    const std::lock_guard lock(mutex_);
    return newest_->revision != revisions_;
  }

  void end() {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    changed_.notify_all();
  }

  bool awaitEnd(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, patience, [&] { return ended_; });
  }

  void main() {
    giveWayToTheWindow();
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [&] { return ending_ || wanted_; });
      if (ending_) break;
      const Request request = std::move(*wanted_);
      wanted_.reset();
      lock.unlock();
      auto preview = std::make_shared<Preview>();
      preview->revision = request.revision;
      preview->scene = request.scene;
      if (!request.scene.parts.empty()) preview->problem = buildInto(request, *preview);
      lock.lock();
      newest_ = std::move(preview);
    }
    ended_ = true;
    changed_.notify_all();
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Request> wanted_;
  std::shared_ptr<const Preview> newest_ = std::make_shared<Preview>();
  std::uint64_t revisions_ = 0;
  bool ending_ = false;
  bool ended_ = false;
};

Builder::Builder() : thread_(std::make_shared<Thread>()), runner_([thread = thread_] { thread->main(); }) {}

Builder::~Builder() {
  constexpr std::chrono::milliseconds kPatience{300};
  thread_->end();
  if (!thread_->awaitEnd(kPatience)) runner_.detach();
}

std::uint64_t Builder::request(const modeling::Scene& scene, const std::filesystem::path& folder) {
  return thread_->request(scene, folder);
}

std::shared_ptr<const Preview> Builder::newest() const {
  return thread_->newest();
}

bool Builder::isBusy() const {
  return thread_->isBusy();
}

}  // namespace ui
