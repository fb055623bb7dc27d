#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace ui {

/// A thread that answers requests. Of those that come faster than they can be answered the newest counts.
/// Every function may be called from any thread and returns at once; `work` runs in the thread of its own and
/// may not throw. Its end waits a moment for what is under way, and then leaves it to itself.
template <class Request, class Answer>
class LatestWorker {
 public:
  using Work = std::function<Answer(const Request&)>;

  explicit LatestWorker(Work work)
      : state_(std::make_shared<State>()),
        runner_([state = state_, work = std::move(work)] { state->main(work); }) {}
  ~LatestWorker() {
    constexpr std::chrono::milliseconds kPatience{200};
    std::unique_lock lock(state_->mutex);
    state_->ending = true;
    state_->changed.notify_all();
    const bool ended = state_->changed.wait_for(lock, kPatience, [&] { return state_->ended; });
    lock.unlock();
    if (ended) {
      runner_.join();
    } else {
      runner_.detach();
    }
  }
  LatestWorker(const LatestWorker&) = delete;
  LatestWorker& operator=(const LatestWorker&) = delete;

  void request(Request request) {
    const std::lock_guard lock(state_->mutex);
    state_->wanted = std::move(request);
    state_->changed.notify_all();
  }
  /// The newest answer; null before there is one. Older than the last request while isBusy().
  std::shared_ptr<const Answer> newest() const {
    const std::lock_guard lock(state_->mutex);
    return state_->newest;
  }
  bool isBusy() const {
    const std::lock_guard lock(state_->mutex);
    return state_->working || state_->wanted;
  }

 private:
  struct State {
    mutable std::mutex mutex;  ///< of all below
    std::condition_variable changed;
    std::optional<Request> wanted;
    std::shared_ptr<const Answer> newest;
    bool working = false;
    bool ending = false;
    bool ended = false;

    void main(const Work& work) {
      std::unique_lock lock(mutex);
      while (true) {
        changed.wait(lock, [&] { return ending || wanted; });
        if (ending) break;
        const Request request = std::move(*wanted);
        wanted.reset();
        working = true;
        lock.unlock();
        auto answer = std::make_shared<const Answer>(work(request));
        lock.lock();
        newest = std::move(answer);
        working = false;
      }
      ended = true;
      changed.notify_all();
    }
  };

  std::shared_ptr<State> state_;  ///< shared with the thread, which may outlive this
  std::thread runner_;
};

}  // namespace ui
