#include "tests/support/run_program.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tests {
namespace {

std::string textOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

Answer runCommand(const std::string& command) {
  const std::string base =
      std::filesystem::temp_directory_path() / ("smithereens-run-" + std::to_string(getpid()));
  const int raw = std::system(("(" + command + ") >" + base + ".out 2>" + base + ".err").c_str());
  Answer answer;
  if (WIFEXITED(raw) && WEXITSTATUS(raw) < 126) answer.status = WEXITSTATUS(raw);
  answer.output = textOf(base + ".out");
  answer.errors = textOf(base + ".err");
  std::filesystem::remove(base + ".out");
  std::filesystem::remove(base + ".err");
  return answer;
}

std::size_t peakMemoryOf(const std::vector<std::string>& words) {
  const pid_t child = ::fork();
  if (child == 0) {
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    std::vector<char*> raw;
    for (const std::string& word : words) raw.push_back(const_cast<char*>(word.c_str()));
    raw.push_back(nullptr);
    ::execv(raw[0], raw.data());
    ::_exit(127);
  }
  int status = 0;
  rusage used{};
  ::wait4(child, &status, 0, &used);
  return 1024 * static_cast<std::size_t>(used.ru_maxrss);
}

Answer runCli(const std::string& arguments) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  const std::string limit;  // a sanitizer's shadow alone is terabytes of address space
#else
  const std::string limit = "ulimit -v 1048576; ";
#endif
  return runCommand(limit + "\"" SMITHEREENS_CLI "\" " + arguments);
}

std::string freshFolder(const std::string& name) {
  const auto folder = std::filesystem::temp_directory_path() / (name + "-" + std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string();
}

}  // namespace tests
