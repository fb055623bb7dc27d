#include "ui/session/background_thread.h"

#include <cassert>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>

#ifdef __linux__
#include <algorithm>

#include <sys/resource.h>
#endif

namespace ui {
namespace {

/// How long the window waits for a thread to end. A few of them, one after the other, are not felt when a
/// window closes.
constexpr std::chrono::milliseconds kPatience{300};

/// The calling thread, and every thread it starts from now on, gives way to the threads that answer the
/// person and draw. Does nothing where the system has no priority of single threads for programs without
/// rights.
void giveWayToTheWindow() {
#ifdef __linux__
  // A third of the share of a thread that draws, when they compete; all of what is left otherwise.
  constexpr int kNiceness = 5;
  // Of the thread alone: Linux takes a thread for a process here. A refusal changes no result.
  static_cast<void>(setpriority(PRIO_PROCESS, 0, std::max(kNiceness, getpriority(PRIO_PROCESS, 0))));
#endif
}

}  // namespace

struct BackgroundThread::End {
  std::mutex mutex;  ///< of all below
  std::condition_variable changed;
  bool reached = false;

  void reach() {
    const std::lock_guard lock(mutex);
    reached = true;
    changed.notify_all();
  }
  bool await() {
    std::unique_lock lock(mutex);
    return changed.wait_for(lock, kPatience, [this] { return reached; });
  }
};

BackgroundThread::BackgroundThread(Main main)
    : end_(std::make_shared<End>()),
      runner_([end = end_, main = std::move(main)](const std::stop_token& stop) {
        giveWayToTheWindow();
        try {
          main(stop);
        } catch (...) {
          assert(false);
        }
        end->reach();
      }) {}

BackgroundThread::~BackgroundThread() {
  runner_.request_stop();
  if (!end_->await()) runner_.detach();
}

sim::Problem problemOfException() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return {"", "there is not enough memory for this", "use larger cells, or fewer of them"};
  } catch (const std::exception& exception) {
    return {"", std::string("this failed: ") + exception.what(), ""};
  } catch (...) {
    return {"", "this failed, and nothing is known of why", ""};
  }
}

}  // namespace ui
