#include "tests/fuzz/bounded.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <new>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tests {
namespace {

void limitMemory(std::size_t most) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  std::ifstream sizes("/proc/self/statm");
  rlim_t pages = 0;
  if (!(sizes >> pages)) return;
  const rlim_t bytes = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + most;
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_AS, &limit);
#else
  static_cast<void>(most);
#endif
}

[[noreturn]] void answer(int pipe, const std::function<std::string()>& trial, const Bounds& bounds) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  limitMemory(bounds.memory);
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  std::string words;
  try {
    words = trial();
  } catch (const std::bad_alloc&) {
    words = "WRONG: MEMORY";
  } catch (const std::exception& exception) {
    words = std::string("WRONG: THREW: ") + exception.what();
  }
  const bool sent = ::write(pipe, words.data(), words.size()) == static_cast<ssize_t>(words.size());
  // Not by exit(), which would wait for what is still at work.
  std::fflush(nullptr);
  ::_exit(sent ? 0 : 1);
}

/// All that comes; false where the time was over first.
bool takeAll(int pipe, double seconds, std::string& words) {
  const auto start = std::chrono::steady_clock::now();
  std::array<char, 4096> piece;
  while (true) {
    const double left =
        seconds - std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    pollfd waiting{pipe, POLLIN, 0};
    if (left <= 0.0 || ::poll(&waiting, 1, static_cast<int>(1000.0 * left) + 1) == 0) return false;
    const ssize_t count = ::read(pipe, piece.data(), piece.size());
    if (count <= 0) return true;
    words.append(piece.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

Ending runBounded(const std::function<std::string()>& trial, const Bounds& bounds) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return {false, "no pipe"};
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    answer(ends[1], trial, bounds);
  }
  ::close(ends[1]);
  Ending ending;
  const bool inTime = takeAll(ends[0], bounds.seconds, ending.words);
  ::close(ends[0]);
  // And what it has started itself.
  if (!inTime) ::kill(-child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!inTime) return {false, "HUNG for " + std::to_string(static_cast<int>(bounds.seconds)) + " s"};
  if (WIFSIGNALED(status)) return {false, "CRASHED by signal " + std::to_string(WTERMSIG(status))};
  if (WEXITSTATUS(status) != 0) return {false, "ENDED with status " + std::to_string(WEXITSTATUS(status))};
  ending.sound = !ending.words.starts_with("WRONG") && !ending.words.empty();
  return ending;
}

}  // namespace tests
