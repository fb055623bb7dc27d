#include "ui/session/worker.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>

#include "ui/session/live_run.h"

namespace ui {

/// What both sides share: the queue of orders, and the newest view.
class Worker::Queue {
 public:
  using Order = std::function<void(Queue&)>;

  void postToRun(std::function<void(LiveRun&)> order) {
    post([order = std::move(order)](Queue& queue) {
      if (queue.run_) order(*queue.run_);
    });
  }

  void post(Order order) {
    {
      const std::lock_guard lock(mutex_);
      orders_.push_back(std::move(order));
      waiting_ = true;
    }
    changed_.notify_all();
  }

  std::shared_ptr<const RunView> view() const {
    const std::lock_guard lock(viewMutex_);
    return view_;
  }

  void main(const std::stop_token& stop) {
    stop_ = stop;
    while (!stop_.stop_requested()) {
      const sim::Status worked = guarded([this] { return work(); });
      if (!worked) static_cast<void>(guarded([&] { return failRun(worked.problem()); }));
    }
    static_cast<void>(guarded([this] { return stopRun(); }));
  }

  void begin(std::uint64_t number, RunPlan plan) {
    static_cast<void>(stopRun());
    run_ = std::make_unique<LiveRun>(number, std::move(plan), pace_);
    publish();
    run_->prepare([this] { return stop_.stop_requested(); });
  }
  void setPace(const Pace& wanted) {
    pace_ = wanted;
    if (run_) run_->setPace(wanted);
  }

  std::atomic<std::uint64_t> runs{0};

 private:
  sim::Status work() {
    obeyOrders();
    if (run_ && run_->isRunning() && !stop_.stop_requested())
      run_->advance([this] { return waiting_.load() || stop_.stop_requested(); });
    publish();
    return sim::Done{};
  }

  sim::Status failRun(const sim::Problem& problem) {
    if (run_) run_->fail(problem);
    publish();
    return sim::Done{};
  }

  sim::Status stopRun() {
    if (run_) run_->stop();
    return sim::Done{};
  }

  void obeyOrders() {
    std::unique_lock lock(mutex_);
    const auto called = [this] { return !orders_.empty(); };
    const auto due = run_ ? run_->due() : std::optional<Clock::time_point>();
    if (due) {
      changed_.wait_until(lock, stop_, *due, called);
    } else {
      changed_.wait(lock, stop_, called);
    }
    std::deque<Order> orders;
    orders.swap(orders_);
    waiting_ = false;
    lock.unlock();
    for (const Order& order : orders) {
      if (!stop_.stop_requested()) order(*this);
    }
  }

  void publish() {
    if (!run_) return;
    if (std::shared_ptr<const RunView> view = run_->newView()) {
      const std::lock_guard lock(viewMutex_);
      view_.swap(view);
    }
  }

  std::mutex mutex_;  ///< of orders_
  std::condition_variable_any changed_;
  std::deque<Order> orders_;
  std::atomic<bool> waiting_{false};  ///< an order is there: the next step can wait
  mutable std::mutex viewMutex_;      ///< of view_
  std::shared_ptr<const RunView> view_ = std::make_shared<RunView>();
  Pace pace_;                     ///< of the runs to come; the thread's own
  std::stop_token stop_;          ///< the thread's own
  std::unique_ptr<LiveRun> run_;  ///< the thread's own
};

Worker::Worker()
    : queue_(std::make_shared<Queue>()),
      thread_([queue = queue_](const std::stop_token& stop) { queue->main(stop); }) {}

std::uint64_t Worker::start(RunPlan plan) {
  const std::uint64_t number = ++queue_->runs;
  queue_->post([number, plan = std::move(plan)](Queue& queue) { queue.begin(number, plan); });
  return number;
}

void Worker::setPaused(bool paused) {
  queue_->postToRun([paused](LiveRun& run) { run.setPaused(paused); });
}

void Worker::stepOnce() {
  queue_->postToRun([](LiveRun& run) { run.stepOnce(); });
}

void Worker::stepFrame() {
  queue_->postToRun([](LiveRun& run) { run.setPausedAtFrame(); });
}

void Worker::stop() {
  queue_->postToRun([](LiveRun& run) { run.stop(); });
}

void Worker::setPace(const Pace& pace) {
  queue_->post([pace](Queue& queue) { queue.setPace(pace); });
}

void Worker::perform(const modeling::TargetName& target, std::vector<modeling::SceneTrackKey> keys) {
  queue_->postToRun([target, keys = std::move(keys)](LiveRun& run) { run.perform(target, keys); });
}

void Worker::performCollider(const modeling::SceneCollider& prototype,
                             std::vector<modeling::SceneTrackKey> path) {
  queue_->postToRun(
      [prototype, path = std::move(path)](LiveRun& run) { run.performCollider(prototype, path); });
}

std::shared_ptr<const RunView> Worker::view() const {
  return queue_->view();
}

}  // namespace ui
