#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <thread>

#include "sim/base/result.h"

namespace ui {

/// A thread that works while the window goes on. It gives way to the threads that answer the person and draw,
/// where all processors are busy.
///
/// All such threads end in the same way: the thread is asked to, by its stop token, and waited for a moment;
/// if it still works then, it is left alone. It ends by itself or with the program, so whatever `main`
/// touches must be its own or shared with it.
class BackgroundThread {
 public:
  using Main = std::function<void(const std::stop_token& stop)>;

  /// `main` returns soon after a stop is requested, and throws nothing.
  explicit BackgroundThread(Main main);
  ~BackgroundThread();
  BackgroundThread(const BackgroundThread&) = delete;
  BackgroundThread& operator=(const BackgroundThread&) = delete;

  /// Returns at once. Where several threads are to end, all are asked before any is waited for.
  void requestStop() { runner_.request_stop(); }

 private:
  struct End;
  std::shared_ptr<End> end_;
  std::jthread runner_;
};

/// The exception that is being handled, as a Problem: to be called in a catch block.
sim::Problem problemOfException();

/// What `work` answers, which is a Result; what it throws becomes the Problem.
template <class Work>
std::invoke_result_t<Work> guarded(const Work& work) {
  try {
    return work();
  } catch (...) {
    return problemOfException();
  }
}

}  // namespace ui
