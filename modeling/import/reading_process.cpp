#include "modeling/import/reading_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <new>
#include <optional>
#include <span>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace modeling {
namespace {

using sim::Problem;
using Clock = std::chrono::steady_clock;

/// How the reading process ends.
constexpr int kAnswered = 0;
constexpr int kFailed = 1;
constexpr int kOutOfMemory = 2;

/// How often, ms, those who wait are told and asked.
constexpr int kPatience = 100;
/// Nobody is told of what takes less, s.
constexpr double kNoticeable = 1.0;
/// How long, ms, a process that was ended is waited for. One that the system itself holds up (a network drive
/// that is gone) is left alone.
constexpr int kFarewell = 2000;

/// Answers are of this size at most, bytes: they are kept in memory here, too.
constexpr std::size_t kLargestAnswer = std::size_t{1} << 30U;

const char* const kAnew = "export it anew, as glTF, OBJ, PLY or STL";

/// What the reading process may take beyond what it has of us. It ends with the program.
void limitMyself(const ReadingLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  std::ifstream sizes("/proc/self/statm");
  rlim_t pages = 0;
  if (sizes >> pages) {
    const rlim_t bytes = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + limits.memory;
    const rlimit memory{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &memory);
  }
#endif
  const auto seconds = static_cast<rlim_t>(std::ceil(limits.seconds));
  const rlimit processor{seconds, seconds + 1};
  ::setrlimit(RLIMIT_CPU, &processor);
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  // Whoever is told of our crashes has nothing to do with a crash in here.
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM, SIGXCPU, SIGTERM, SIGINT})
    std::signal(signal, SIG_DFL);
}

bool send(int pipe, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(pipe, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

[[noreturn]] void answerAndEnd(int pipe, const std::function<sim::ByteWriter()>& read,
                               const ReadingLimits& limits) {
  limitMyself(limits);
  // What libraries say to the terminal is not for the person.
  for (std::FILE* stream : {stdout, stderr})
    if (std::freopen("/dev/null", "w", stream) == nullptr) ::_exit(kFailed);
  try {
    ::_exit(send(pipe, read().bytes()) ? kAnswered : kFailed);
  } catch (const std::bad_alloc&) {
    ::_exit(kOutOfMemory);
  } catch (...) {
    ::_exit(kFailed);
  }
}

std::string secondsText(double seconds) {
  return std::to_string(std::max(1L, std::lround(seconds))) + " s";
}

/// The reading process, as the one who waits has it.
class Reader {
 public:
  Reader(const std::string& name, const ReadingLimits& limits, const Attendance& attendance)
      : name_(name), limits_(limits), attendance_(attendance) {}
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() {
    if (pipe_ >= 0) ::close(pipe_);
    if (process_ > 0) end();
  }

  bool start(const std::function<sim::ByteWriter()>& read) {
    std::array<int, 2> ends{};
    // A program that is started meanwhile must not keep the pipe open.
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    std::fflush(nullptr);
    process_ = ::fork();
    if (process_ == 0) {
      ::close(ends[0]);
      answerAndEnd(ends[1], read, limits_);
    }
    ::close(ends[1]);
    pipe_ = ends[0];
    return process_ > 0;
  }

  /// All it answers; a Problem where that ended before its time.
  sim::Result<std::vector<std::byte>> answer() {
    std::vector<std::byte> bytes;
    while (true) {
      pollfd waiting{pipe_, POLLIN, 0};
      const int ready = ::poll(&waiting, 1, kPatience);
      if (ready < 0 && errno != EINTR) return failure();
      if (ready > 0 && !take(bytes)) break;
      if (bytes.size() > kLargestAnswer) return tooMuch();
      const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
      if (attendance_.gaveUp && attendance_.gaveUp())
        return Problem{"", "reading " + name_ + " was given up", ""};
      if (seconds > limits_.seconds) return tooSlow();
      if (attendance_.tell && seconds > kNoticeable && ready == 0)
        attendance_.tell("reading " + name_ + ", " + secondsText(seconds));
    }
    if (const auto problem = outcome()) return *problem;
    return bytes;
  }

 private:
  /// What has come; false: nothing more will.
  bool take(std::vector<std::byte>& bytes) const {
    std::array<std::byte, 65536> piece;
    const ssize_t count = ::read(pipe_, piece.data(), piece.size());
    if (count < 0) return errno == EINTR;
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + count);
    return count > 0;
  }

  std::optional<Problem> outcome() {
    const std::optional<int> status = waitFor();
    if (!status) return failure();
    if (WIFSIGNALED(*status) && (WTERMSIG(*status) == SIGXCPU || WTERMSIG(*status) == SIGKILL))
      return tooSlow();
    if (!WIFEXITED(*status)) return failure();
    if (WEXITSTATUS(*status) == kOutOfMemory) return tooMuch();
    if (WEXITSTATUS(*status) != kAnswered) return failure();
    return std::nullopt;
  }

  /// How the process ended, when it does so in a moment.
  std::optional<int> waitFor() {
    for (int waited = 0; waited <= kFarewell; ++waited) {
      int status = 0;
      const pid_t ended = ::waitpid(process_, &status, WNOHANG);
      if (ended == process_ || (ended < 0 && errno != EINTR)) {
        process_ = -1;
        return ended < 0 ? std::nullopt : std::optional(status);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return std::nullopt;
  }

  void end() {
    ::kill(process_, SIGKILL);
    waitFor();
  }

  static Problem failure() {
    return {"", "the reader of this format failed at this file, which may be sound or damaged", kAnew};
  }
  Problem tooSlow() const {
    return {"", "reading this file took longer than " + secondsText(limits_.seconds) + " and was given up",
            std::string("use a mesh of fewer faces, or ") + kAnew};
  }
  Problem tooMuch() const {
    return {"",
            "reading this file takes more than " + std::to_string(limits_.memory >> 20U) + " MB of memory",
            std::string("use a mesh of fewer faces, or ") + kAnew};
  }

  const std::string& name_;
  const ReadingLimits& limits_;
  const Attendance& attendance_;
  Clock::time_point began_ = Clock::now();
  pid_t process_ = -1;
  int pipe_ = -1;
};

}  // namespace

sim::Result<std::vector<std::byte>> readApart(const std::string& name,
                                              const std::function<sim::ByteWriter()>& read,
                                              const ReadingLimits& limits, const Attendance& attendance) {
  Reader reader(name, limits, attendance);
  if (!reader.start(read))
    return Problem{"", "the process that reads files could not be started", "try again"};
  return reader.answer();
}

}  // namespace modeling
