#include "ui/viewport/draw_preparer.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>

#include "ui/session/background.h"
#include "ui/viewport/draw_maker.h"

namespace ui {

class DrawPreparer::Thread {
 public:
  void request(const Shown& shown, const ViewSettings& settings) {
    const std::lock_guard lock(mutex_);
    wanted_ = Request{shown, settings};
    outOfDate_ = true;
    changed_.notify_all();
  }

  std::shared_ptr<const DrawData> newest() const {
    const std::lock_guard lock(mutex_);
    return newest_;
  }

  bool isBusy() const {
    const std::lock_guard lock(mutex_);
    return working_ || wanted_;
  }

  void end() {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    outOfDate_ = true;
    changed_.notify_all();
  }

  bool awaitEnd(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, patience, [&] { return ended_; });
  }

  void main() {
    giveWayToTheWindow();
    DrawMaker maker;
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [&] { return ending_ || wanted_; });
      if (ending_) break;
      const Request request = std::move(*wanted_);
      wanted_.reset();
      outOfDate_ = false;
      working_ = true;
      lock.unlock();
      std::shared_ptr<const DrawData> made = make(maker, request);
      lock.lock();
      working_ = false;
      newest_ = std::move(made);
    }
    ended_ = true;
    changed_.notify_all();
  }

 private:
  struct Request {
    Shown shown;
    ViewSettings settings;
  };

  /// Where memory does not suffice nothing is drawn; the window has to live on, to save the work.
  std::shared_ptr<const DrawData> make(DrawMaker& maker, const Request& request) {
    try {
      return std::make_shared<const DrawData>(
          maker.make(request.shown, request.settings, [this] { return outOfDate_.load(); }));
    } catch (const std::bad_alloc&) {
      maker = DrawMaker();
      return std::make_shared<const DrawData>();
    }
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Request> wanted_;
  std::shared_ptr<const DrawData> newest_ = std::make_shared<DrawData>();
  std::atomic<bool> outOfDate_ = false;
  bool working_ = false;
  bool ending_ = false;
  bool ended_ = false;
};

DrawPreparer::DrawPreparer()
    : thread_(std::make_shared<Thread>()), runner_([thread = thread_] { thread->main(); }) {}

DrawPreparer::~DrawPreparer() {
  constexpr std::chrono::milliseconds kPatience{300};
  thread_->end();
  if (!thread_->awaitEnd(kPatience)) runner_.detach();
}

void DrawPreparer::request(const Shown& shown, const ViewSettings& settings) {
  thread_->request(shown, settings);
}

std::shared_ptr<const DrawData> DrawPreparer::newest() const {
  return thread_->newest();
}

bool DrawPreparer::isBusy() const {
  return thread_->isBusy();
}

}  // namespace ui
