#include "modeling/import/reading_apart.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <span>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace modeling {
namespace {

constexpr int kMillisecondsBetweenLooks = 100;

/// What the process may take beyond what it has of us.
void limitMyself(const ReadingLimits& limits) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  std::ifstream sizes("/proc/self/statm");
  rlim_t pages = 0;
  if (sizes >> pages) {
    const rlim_t bytes = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + limits.memory;
    const rlimit memory{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &memory);
  }
#endif
  const rlimit seconds{limits.seconds, limits.seconds};
  ::setrlimit(RLIMIT_CPU, &seconds);
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  ::alarm(2 * limits.seconds);
}

bool send(int pipe, std::span<const std::byte> rest) {
  while (!rest.empty()) {
    const ssize_t written = ::write(pipe, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    rest = rest.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

[[noreturn]] void answerAndEnd(int pipe, const std::function<sim::ByteWriter()>& read,
                               const ReadingLimits& limits) {
  limitMyself(limits);
  // Whoever is told of our crashes has nothing to do with a crash in here.
  for (const int signal :
       {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM, SIGXCPU, SIGTERM, SIGINT, SIGHUP})
    std::signal(signal, SIG_DFL);
  // What readers say to the terminal is not for the person.
  if (std::freopen("/dev/null", "w", stderr) == nullptr) ::_exit(1);
  try {
    const sim::ByteWriter answer = read();
    if (send(pipe, answer.bytes())) ::_exit(0);
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(1);
}

/// Everything until the other end is closed; nothing where that is not worth waiting for.
std::optional<ReadingEnd> receive(int pipe, const ReadingLimits& limits,
                                  const std::function<bool()>& keepGoing, std::vector<std::byte>& bytes) {
  using Clock = std::chrono::steady_clock;
  const auto last = Clock::now() + std::chrono::seconds(2 * limits.seconds + 1);
  std::array<std::byte, 65536> piece;
  for (;;) {
    if (keepGoing && !keepGoing()) return ReadingEnd::givenUp;
    if (Clock::now() > last || bytes.size() > limits.longestAnswer) return ReadingEnd::tooLong;
    pollfd waiting{pipe, POLLIN, 0};
    if (::poll(&waiting, 1, kMillisecondsBetweenLooks) <= 0) continue;
    const ssize_t count = ::read(pipe, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + count);
  }
}

ReadingEnd endOf(int status) {
  if (WIFEXITED(status)) return WEXITSTATUS(status) == 0 ? ReadingEnd::answered : ReadingEnd::failed;
  const bool late = WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGALRM);
  return late ? ReadingEnd::tooLong : ReadingEnd::failed;
}

}  // namespace

ReadingAnswer readApart(const std::function<sim::ByteWriter()>& read, const ReadingLimits& limits,
                        const std::function<bool()>& keepGoing) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return {ReadingEnd::notNow, {}};
  // A program that is started meanwhile must not keep the pipe open.
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  std::fflush(nullptr);
  const pid_t reader = ::fork();
  if (reader == 0) {
    ::close(ends[0]);
    answerAndEnd(ends[1], read, limits);
  }
  ::close(ends[1]);
  ReadingAnswer answer;
  std::optional<ReadingEnd> early = ReadingEnd::notNow;
  if (reader > 0) early = receive(ends[0], limits, keepGoing, answer.bytes);
  ::close(ends[0]);
  if (early && reader > 0) ::kill(reader, SIGKILL);
  int status = 0;
  while (reader > 0 && ::waitpid(reader, &status, 0) < 0 && errno == EINTR) {
  }
  answer.end = early.value_or(endOf(status));
  if (answer.end != ReadingEnd::answered) answer.bytes.clear();
  return answer;
}

}  // namespace modeling
