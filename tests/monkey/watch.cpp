#include "tests/monkey/watch.h"

#include <QApplication>
#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string_view>
#include <typeinfo>
#include <utility>

#include <dlfcn.h>
#include <execinfo.h>
#include <malloc.h>
#include <pthread.h>
#include <unistd.h>

namespace monkey {
namespace {

constexpr int kBeat = 20;  // ms
constexpr double kMegabyte = 1e6;
char present[512] = "";  ///< the action, for signal handlers
pthread_t windowThread;
std::array<void*, 64> stalledAt;
std::atomic<int> stalledDepth{0};

void write(const char* words) {
  static_cast<void>(::write(STDERR_FILENO, words, std::strlen(words)));
}

void writeCalls() {
  void* calls[64];
  const int count = backtrace(calls, 64);
  backtrace_symbols_fd(calls, count, STDERR_FILENO);
}

void tellStall(int) {
  write("monkey: the window does not answer, during: ");
  write(present);
  write("\n");
  stalledDepth = backtrace(stalledAt.data(), static_cast<int>(stalledAt.size()));
  backtrace_symbols_fd(stalledAt.data(), stalledDepth, STDERR_FILENO);
}

/// Whether the calls that were found when the window did not answer lead through the driver of OpenGL.
bool stalledInDriver() {
  for (int call = 0; call < stalledDepth; ++call) {
    Dl_info info;
    // What is of no file, the driver has made: nothing else here makes code.
    if (dladdr(stalledAt[static_cast<std::size_t>(call)], &info) == 0 || info.dli_fname == nullptr)
      return true;
    const std::string_view file = info.dli_fname;
    for (const char* driver : {"_dri", "libLLVM", "libgallium", "libGLX"})
      if (file.find(driver) != std::string_view::npos) return true;
  }
  return false;
}

void tellCrash(int signal) {
  write("monkey: crashed, during: ");
  write(present);
  write("\n");
  writeCalls();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// s: how long the calling thread was ready and had no processor, ever.
double secondsWaited() {
  std::ifstream file("/proc/thread-self/schedstat");
  double ran = 0.0;
  double waited = 0.0;
  file >> ran >> waited;
  return waited * 1e-9;
}

std::array<void*, 64> thrownAt;
int thrownDepth = 0;

}  // namespace

#ifndef __SANITIZE_ADDRESS__
/// In place of the library's, to know where an exception came from that was caught far away.
// NOLINTNEXTLINE(bugprone-reserved-identifier): it is the library's name.
extern "C" [[noreturn]] void __cxa_throw(void* thrown, std::type_info* type, void (*destroy)(void*)) {
  using Throw = void (*)(void*, std::type_info*, void (*)(void*));
  static const auto real = reinterpret_cast<Throw>(dlsym(RTLD_NEXT, "__cxa_throw"));
  if (pthread_equal(pthread_self(), windowThread) != 0)
    thrownDepth = backtrace(thrownAt.data(), static_cast<int>(thrownAt.size()));
  real(thrown, type, destroy);
  std::abort();
}
#endif

void Watch::tellThrow(const std::string& what) {
  write("monkey: caught: ");
  write(what.c_str());
  write(", during: ");
  write(present);
  write("\n");
  backtrace_symbols_fd(thrownAt.data(), thrownDepth, STDERR_FILENO);
}

Memory memoryNow() {
  Memory memory;
  std::ifstream file("/proc/self/statm");
  double size = 0.0;
  double resident = 0.0;
  file >> size >> resident;
  memory.resident = resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / kMegabyte;
  const struct mallinfo2 asked = mallinfo2();
  memory.asked = static_cast<double>(asked.uordblks + asked.hblkhd) / kMegabyte;
  return memory;
}

Watch::Watch() {
  windowThread = pthread_self();
  void* once[1];
  backtrace(once, 1);  // it loads a library the first time, which a handler must not
  std::signal(SIGUSR2, tellStall);
#ifndef __SANITIZE_ADDRESS__
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE}) std::signal(signal, tellCrash);
#endif
  clock_.start();
  QObject::connect(&timer_, &QTimer::timeout, [this] { beat(); });
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.start(kBeat);
  waitedBefore_ = secondsWaited();
  thread_ = std::thread([this] { main(); });
}

Watch::~Watch() {
  ends_ = true;
  thread_.join();
}

void Watch::begin(const std::string& action) {
  action_ = action;
  std::snprintf(present, sizeof present, "%s", action.c_str());
}

void Watch::beat() {
  const qint64 now = clock_.elapsed();
  const double waited = secondsWaited();
  Stall stall{static_cast<double>(now - beatAt_) * 1e-3, 0.0, action_, stalledInDriver()};
  stalledDepth = 0;
  stall.own = stall.seconds - (waited - waitedBefore_);
  if (!stall.drawing) longest_ = std::max(longest_, stall.own);
  if (stall.own > kLongest) stalls_.push_back(stall);
  beatAt_ = now;
  waitedBefore_ = waited;
}

void Watch::main() {
  bool told = false;
  while (!ends_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const double silent = static_cast<double>(clock_.elapsed() - beatAt_) * 1e-3;
    if (silent < kLongest) told = false;
    if (silent > kLongest && !std::exchange(told, true)) pthread_kill(windowThread, SIGUSR2);
    if (silent < kDead) continue;
    write("monkey: the window does not answer any more\n");
    pthread_kill(windowThread, SIGABRT);
    return;
  }
}

std::size_t Watch::ownStalls() const {
  return static_cast<std::size_t>(std::ranges::count(stalls_, false, &Stall::drawing));
}

void Watch::lookAtMemory() {
  malloc_trim(0);
  memory_.push_back(memoryNow());
  memory_.back().widgets = static_cast<long>(QApplication::allWidgets().size());
  memory_.back().seconds = static_cast<double>(clock_.elapsed()) * 1e-3;
}

double Watch::growth() const {
  const std::size_t sixth = memory_.size() / 6;
  if (sixth == 0) return 0.0;
  const auto median = [&](std::size_t from) {
    std::vector<double> some;
    for (std::size_t i = from; i < from + sixth; ++i) some.push_back(memory_[i].asked);
    std::nth_element(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(sixth / 2), some.end());
    return some[sixth / 2];
  };
  return median(memory_.size() - sixth) / median(sixth) - 1.0;
}

}  // namespace monkey
