#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "ui/session/background_thread.h"

namespace ui {

/// Answers requests in a thread of its own, which starts with the first. Of requests that come faster than
/// they can be answered the newest counts. Every function may be called from any thread and returns at once;
/// the destructor waits a moment at most (BackgroundThread).
template <class Request, class Value>
class BackgroundWorker {
 public:
  /// What is known of the answer to one request; immutable.
  struct Answer {
    std::uint64_t request = 0;  ///< counted from 1; 0: none was begun yet
    Value value{};              ///< complete where it has ended without a Problem
    bool ended = false;
    bool cancelled = false;                 ///< it ended early, because nobody wanted it any more
    std::optional<sim::Problem> problem{};  ///< why it ended early, if it was not cancelled
  };
  class Job;
  /// Fills job.value. What it returns as a Problem or throws is the answer's problem; what was filled stands.
  /// It may outlive the worker, and owns what it touches.
  using Work = std::function<sim::Status(const Request& request, Job& job)>;

  explicit BackgroundWorker(Work work) : state_(std::make_shared<State>()), work_(std::move(work)) {}
  BackgroundWorker(const BackgroundWorker&) = delete;
  BackgroundWorker& operator=(const BackgroundWorker&) = delete;
  ~BackgroundWorker() = default;

  /// Gives the request's number.
  std::uint64_t request(Request request);
  /// All requests so far are not wanted any more.
  void cancel();
  /// See BackgroundThread::requestStop(). No request is answered afterwards.
  void requestStop();
  /// The newest there is; never null. It may be of an older request than the last one while isBusy().
  std::shared_ptr<const Answer> newest() const;
  /// A request waits or is being answered.
  bool isBusy() const;

 private:
  struct State;

  std::shared_ptr<State> state_;  ///< shared with the thread, which may outlive this
  Work work_;                     ///< until the thread has it
  std::optional<BackgroundThread> thread_;
};

/// One request being answered, as its work sees it; the thread's own.
template <class Request, class Value>
class BackgroundWorker<Request, Value>::Job {
 public:
  Job(State& state, std::uint64_t number, std::stop_token stop)
      : state_(state), number_(number), stop_(std::move(stop)) {}

  Value value{};

  /// Nobody waits for the answer any more: a newer request is there, it was cancelled, or all is to end.
  bool cancelled() const {
    return stop_.stop_requested() || state_.requests.load() != number_ || state_.unwanted.load() >= number_;
  }
  /// Shows a copy of the value as it is by now.
  void publish() {
    auto shown = std::make_shared<const Answer>(Answer{.request = number_, .value = value});
    const std::lock_guard lock(state_.mutex);
    state_.newest.swap(shown);
  }

 private:
  State& state_;
  std::uint64_t number_;
  std::stop_token stop_;
};

template <class Request, class Value>
struct BackgroundWorker<Request, Value>::State {
  mutable std::mutex mutex;  ///< of all below but the atomic ones, which are written under it
  std::condition_variable_any changed;
  std::optional<Request> wanted;
  std::shared_ptr<const Answer> newest = std::make_shared<const Answer>();
  bool working = false;
  std::atomic<std::uint64_t> requests{0};
  std::atomic<std::uint64_t> unwanted{0};  ///< all requests up to this one

  void main(const Work& work, const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    while (changed.wait(lock, stop, [this] { return wanted.has_value(); }) && !stop.stop_requested()) {
      const Request request = std::move(*wanted);
      const std::uint64_t number = requests;
      wanted.reset();
      working = true;
      lock.unlock();
      auto answered = std::make_shared<const Answer>(answerTo(request, number, work, stop));
      lock.lock();
      newest.swap(answered);
      working = false;
      lock.unlock();
      // What it replaces may be large, and nobody is to wait for that.
      answered.reset();
      lock.lock();
    }
  }

  Answer answerTo(const Request& request, std::uint64_t number, const Work& work,
                  const std::stop_token& stop) {
    Job job(*this, number, stop);
    const sim::Status status = guarded([&] { return work(request, job); });
    Answer answer{.request = number, .value = std::move(job.value), .ended = true};
    answer.cancelled = job.cancelled();
    if (!status && !answer.cancelled) answer.problem = status.problem();
    return answer;
  }
};

template <class Request, class Value>
std::uint64_t BackgroundWorker<Request, Value>::request(Request request) {
  const std::lock_guard lock(state_->mutex);
  state_->wanted = std::move(request);
  const std::uint64_t number = ++state_->requests;
  if (!thread_) {
    thread_.emplace(
        [state = state_, work = std::move(work_)](const std::stop_token& stop) { state->main(work, stop); });
  }
  state_->changed.notify_all();
  return number;
}

template <class Request, class Value>
void BackgroundWorker<Request, Value>::cancel() {
  const std::lock_guard lock(state_->mutex);
  state_->unwanted = state_->requests.load();
  if (!state_->wanted) return;
  // It ends here, as it will not even begin.
  state_->wanted.reset();
  state_->newest =
      std::make_shared<const Answer>(Answer{.request = state_->requests, .ended = true, .cancelled = true});
}

template <class Request, class Value>
void BackgroundWorker<Request, Value>::requestStop() {
  const std::lock_guard lock(state_->mutex);
  if (thread_) thread_->requestStop();
}

template <class Request, class Value>
std::shared_ptr<const typename BackgroundWorker<Request, Value>::Answer>
BackgroundWorker<Request, Value>::newest() const {
  const std::lock_guard lock(state_->mutex);
  return state_->newest;
}

template <class Request, class Value>
bool BackgroundWorker<Request, Value>::isBusy() const {
  const std::lock_guard lock(state_->mutex);
  return state_->working || state_->wanted;
}

}  // namespace ui
