#include "ui/session/worker.h"

#include <chrono>
#include <exception>

#include "ui/session/background.h"
#include "ui/session/live_run.h"

namespace ui {
namespace {

using Clock = std::chrono::steady_clock;

/// How long the window waits for the thread when it closes.
constexpr std::chrono::milliseconds kPatience{400};

}  // namespace

/// What both sides share: the queue of orders, and the newest view.
class Worker::Thread {
 public:
  using Order = std::function<void(Thread&)>;

  void post(Order order) {
    {
      const std::lock_guard lock(mutex_);
      orders_.push_back(std::move(order));
    }
    waiting_ = true;
    changed_.notify_all();
  }

  void end() {
    ending_ = true;
    waiting_ = true;
    changed_.notify_all();
  }

  bool awaitEnd(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, patience, [&] { return ended_; });
  }

  std::shared_ptr<const RunView> view() const {
    const std::lock_guard lock(viewMutex_);
    return view_;
  }

  void main() {
    giveWayToTheWindow();
    while (!ending_) {
      try {
        obeyOrders();
        if (run_ && run_->isRunning() && !ending_) run_->advance([&] { return waiting_.load(); });
      } catch (const std::bad_alloc&) {
        fail({"", "there is not enough memory for this", "use larger cells, or fewer of them"});
      } catch (const std::exception& exception) {
        fail({"", std::string("the simulation stopped: ") + exception.what(), "simulate again"});
      }
      publish();
    }
    if (run_) run_->stop();
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

  void begin(std::uint64_t number, RunPlan plan) {
    if (run_) run_->stop();
    run_ = std::make_unique<LiveRun>(number, std::move(plan), pace);
    publish();
    run_->prepare([&] { return ending_.load(); });
  }
  LiveRun* run() { return run_.get(); }

  std::atomic<std::uint64_t> runs{0};
  Pace pace;  ///< of the runs to come; the thread's own

 private:
  void obeyOrders() {
    std::unique_lock lock(mutex_);
    if (orders_.empty()) {
      const auto due = run_ ? run_->due() : std::optional<Clock::time_point>();
      const auto called = [&] { return !orders_.empty() || ending_; };
      if (due) {
        changed_.wait_until(lock, *due, called);
      } else {
        changed_.wait(lock, called);
      }
    }
    std::deque<Order> orders;
    orders.swap(orders_);
    if (!ending_) waiting_ = false;
    lock.unlock();
    for (const Order& order : orders) {
      if (!ending_) order(*this);
    }
  }

  void fail(const sim::Problem& problem) {
    if (run_) run_->fail(problem);
  }

  void publish() {
    if (!run_) return;
    if (std::shared_ptr<const RunView> view = run_->newView()) {
      const std::lock_guard lock(viewMutex_);
      view_.swap(view);
    }
  }

  std::mutex mutex_;  ///< of orders_ and ended_
  std::condition_variable changed_;
  std::deque<Order> orders_;
  bool ended_ = false;
  std::atomic<bool> waiting_{false};  ///< an order is there: the next step can wait
  std::atomic<bool> ending_{false};
  mutable std::mutex viewMutex_;
  std::shared_ptr<const RunView> view_ = std::make_shared<RunView>();
  std::unique_ptr<LiveRun> run_;  ///< the thread's own
};

Worker::Worker() : thread_(std::make_shared<Thread>()), runner_([thread = thread_] { thread->main(); }) {}

Worker::~Worker() {
  thread_->end();
  if (!thread_->awaitEnd(kPatience)) runner_.detach();
}

std::uint64_t Worker::start(RunPlan plan) {
  const std::uint64_t number = ++thread_->runs;
  thread_->post([number, plan = std::move(plan)](Thread& thread) { thread.begin(number, plan); });
  return number;
}

void Worker::setPaused(bool paused) {
  thread_->post([paused](Thread& thread) {
    if (thread.run() != nullptr) thread.run()->setPaused(paused);
  });
}

void Worker::stepOnce() {
  thread_->post([](Thread& thread) {
    if (thread.run() != nullptr) thread.run()->stepOnce();
  });
}

void Worker::stepFrame() {
  thread_->post([](Thread& thread) {
    if (thread.run() != nullptr) thread.run()->setPausedAtFrame();
  });
}

void Worker::stop() {
  thread_->post([](Thread& thread) {
    if (thread.run() != nullptr) thread.run()->stop();
  });
}

void Worker::setPace(const Pace& pace) {
  thread_->post([pace](Thread& thread) {
    thread.pace = pace;
    if (thread.run() != nullptr) thread.run()->setPace(pace);
  });
}

void Worker::perform(const modeling::TargetName& target, std::vector<modeling::SceneTrackKey> keys) {
  thread_->post([target, keys = std::move(keys)](Thread& thread) {
    if (thread.run() != nullptr) thread.run()->perform(target, keys);
  });
}

void Worker::performCollider(const modeling::SceneCollider& prototype,
                             std::vector<modeling::SceneTrackKey> path) {
  thread_->post([prototype, path = std::move(path)](Thread& thread) {
    if (thread.run() != nullptr) thread.run()->performCollider(prototype, path);
  });
}

std::shared_ptr<const RunView> Worker::view() const {
  return thread_->view();
}

}  // namespace ui
