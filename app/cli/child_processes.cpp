#include "app/cli/child_processes.h"

#include <array>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <map>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace app {

namespace {

constexpr std::array<int, 3> kEndings{SIGTERM, SIGINT, SIGHUP};
constexpr timespec kBetweenLooks{0, 20'000'000};
/// s: what does not end by then is killed.
constexpr std::time_t kPatience = 5;

volatile std::sig_atomic_t endingAsked = 0;

void noteEnding(int signal) {
  endingAsked = signal;
}

/// As long as it lives, signals that would end the program are noted instead.
class EndingsNoted {
 public:
  EndingsNoted() {
    endingAsked = 0;
    for (std::size_t i = 0; i < kEndings.size(); ++i) {
      struct sigaction noted {};
      noted.sa_handler = noteEnding;
      ::sigaction(kEndings[i], nullptr, &before_[i]);
      // Who started this with a signal ignored, as nohup does, wants it so.
      if (before_[i].sa_handler != SIG_IGN) ::sigaction(kEndings[i], &noted, nullptr);
    }
  }
  ~EndingsNoted() {
    for (std::size_t i = 0; i < kEndings.size(); ++i) ::sigaction(kEndings[i], &before_[i], nullptr);
  }
  EndingsNoted(const EndingsNoted&) = delete;
  EndingsNoted& operator=(const EndingsNoted&) = delete;

 private:
  std::array<struct sigaction, kEndings.size()> before_{};
};

/// In the child: what is noted here ends it, and so does the end of its parent.
void endWith([[maybe_unused]] pid_t parent) {
  for (const int signal : kEndings) ::signal(signal, SIG_DFL);
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);
#endif
}

pid_t start(const ChildProcess& process) {
  std::vector<char*> words;
  for (const std::string& word : process.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child != 0) return child;
  endWith(parent);
  const int log = ::open(process.log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  if (log >= 0) {
    ::dup2(log, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
  }
  ::execv(words[0], words.data());
  ::_exit(127);
}

int statusOf(int raw) {
  return WIFEXITED(raw) ? WEXITSTATUS(raw) : -1;
}

using Running = std::map<pid_t, std::size_t>;

/// Asks all to end, and kills what does not in time.
void endAll(Running& running) {
  for (const auto& [child, index] : running) ::kill(child, SIGTERM);
  const std::time_t last = std::time(nullptr) + kPatience;
  while (!running.empty()) {
    const pid_t ended = ::waitpid(-1, nullptr, WNOHANG);
    if (ended > 0) {
      running.erase(ended);
    } else if (std::time(nullptr) > last) {
      for (const auto& [child, index] : running) ::kill(child, SIGKILL);
      for (const auto& [child, index] : running) ::waitpid(child, nullptr, 0);
      return;
    } else {
      ::nanosleep(&kBetweenLooks, nullptr);
    }
  }
}

}  // namespace

int runChildProcesses(const std::vector<ChildProcess>& processes, std::size_t atATime,
                      const std::function<void(std::size_t index, int status)>& done) {
  const EndingsNoted noted;
  Running running;
  std::size_t next = 0;
  while (next < processes.size() || !running.empty()) {
    if (endingAsked != 0) {
      endAll(running);
      return endingAsked;
    }
    if (next < processes.size() && running.size() < atATime) {
      const pid_t child = start(processes[next]);
      if (child > 0) {
        running[child] = next++;
        continue;
      }
      if (running.empty()) {
        done(next++, -1);
        continue;
      }
    }
    int raw = 0;
    const pid_t ended = ::waitpid(-1, &raw, WNOHANG);
    if (ended <= 0) {
      ::nanosleep(&kBetweenLooks, nullptr);
      continue;
    }
    const auto found = running.find(ended);
    if (found == running.end()) continue;
    done(found->second, statusOf(raw));
    running.erase(found);
  }
  return 0;
}

void endBySignal(int signal) {
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

std::string ownProgram() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

}  // namespace app
