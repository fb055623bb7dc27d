#include "app/cli/child_processes.h"

#include <cerrno>
#include <filesystem>
#include <map>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace app {

namespace {

pid_t start(const ChildProcess& process) {
  std::vector<char*> words;
  for (const std::string& word : process.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const pid_t child = ::fork();
  if (child != 0) return child;
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

}  // namespace

void runChildProcesses(const std::vector<ChildProcess>& processes, std::size_t atATime,
                       const std::function<void(std::size_t index, int status)>& done) {
  std::map<pid_t, std::size_t> running;
  std::size_t next = 0;
  while (next < processes.size() || !running.empty()) {
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
    const pid_t ended = ::waitpid(-1, &raw, 0);
    if (ended < 0 && errno == EINTR) continue;
    const auto found = running.find(ended);
    if (found == running.end()) continue;
    done(found->second, statusOf(raw));
    running.erase(found);
  }
}

std::string ownProgram() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

}  // namespace app
