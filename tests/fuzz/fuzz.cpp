// Reads damaged files until the time is over: fuzz --seconds 3600. Each input follows from the seed, its kind
// and its number, and stands in the log before it is read, so that whatever ends the reading can be done
// again by --replay NUMBER.
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <random>

#include <CLI/CLI.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/fuzz/fuzz_kinds.h"

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// s: beyond what a reader in a process of its own is given. No other input of a few kilobytes takes a
/// second.
constexpr unsigned kLongest = 150;

struct Options {
  std::uint64_t seed = 1;
  std::uint64_t inputs = ~std::uint64_t{0};
  double seconds = 60.0;
  std::string log = "fuzz.log";
  std::optional<std::uint64_t> replay;
};

enum class Outcome { read, refused, threw, crashed, hung };

std::uint64_t seedOf(const Options& options, std::uint64_t number) {
  std::seed_seq mix{options.seed, number, number >> 32U};
  std::uint32_t words[2];
  mix.generate(std::begin(words), std::end(words));
  return std::uint64_t{words[0]} << 32U | words[1];
}

/// In a process of its own, so that a crash is counted and not the end.
Outcome readOnce(const tests::FuzzKind& kind, const fs::path& file) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(kLongest);
    try {
      ::_exit(kind.read(file) ? 0 : 1);
    } catch (const std::exception& exception) {
      std::cerr << exception.what() << '\n';
    } catch (...) {
      std::cerr << "something was thrown that is no exception\n";
    }
    ::_exit(2);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) return WTERMSIG(status) == SIGALRM ? Outcome::hung : Outcome::crashed;
  switch (WEXITSTATUS(status)) {
    case 0:
      return Outcome::read;
    case 1:
      return Outcome::refused;
    case 2:
      return Outcome::threw;
    default:
      return Outcome::crashed;
  }
}

int fuzz(const Options& options, const fs::path& folder) {
  const std::vector<tests::FuzzKind> kinds = tests::fuzzKinds(folder);
  std::ofstream log(options.log, std::ios::app);
  std::map<std::string, std::map<Outcome, std::uint64_t>> counts;
  std::uint64_t faults = 0;
  const auto file = [&](const tests::FuzzKind& kind) { return folder / ("input" + kind.ending); };
  const auto write = [&](const tests::FuzzKind& kind, const std::string& bytes) {
    std::ofstream(file(kind), std::ios::binary) << bytes;
  };
  for (const tests::FuzzKind& kind : kinds) {
    for (const std::string& whole : kind.wholes) {
      write(kind, whole);
      if (readOnce(kind, file(kind)) == Outcome::read) continue;
      std::cerr << "a whole file of the kind " << kind.name << " is not read\n";
      ++faults;
    }
  }
  const auto start = Clock::now();
  const auto isOver = [&](std::uint64_t number) {
    return number >= options.inputs ||
           std::chrono::duration<double>(Clock::now() - start).count() > options.seconds;
  };
  for (std::uint64_t number = 0; !isOver(number); ++number) {
    const tests::FuzzKind& kind = kinds[number % kinds.size()];
    log << "seed " << options.seed << " input " << kind.name << ':' << number << std::endl;
    write(kind, tests::spoiled(kind, seedOf(options, number)));
    const Outcome outcome = readOnce(kind, file(kind));
    ++counts[kind.name][outcome];
    if (outcome == Outcome::read || outcome == Outcome::refused) continue;
    ++faults;
    const char* const what = outcome == Outcome::threw  ? "threw"
                             : outcome == Outcome::hung ? "hung"
                                                        : "crashed";
    log << "  it " << what << std::endl;
    std::cerr << kind.name << ':' << number << ' ' << what << "; again by --seed " << options.seed
              << " --replay " << number << '\n';
  }
  for (auto& [kind, of] : counts) {
    std::cout << kind << ": " << of[Outcome::read] << " read, " << of[Outcome::refused] << " refused, "
              << of[Outcome::threw] << " threw, " << of[Outcome::crashed] << " crashed, " << of[Outcome::hung]
              << " hung\n";
  }
  return faults == 0 ? 0 : 1;
}

/// In this process, for a debugger; leaves the input in the folder it names.
int replay(const Options& options, const fs::path& folder) {
  const std::vector<tests::FuzzKind> kinds = tests::fuzzKinds(folder);
  const tests::FuzzKind& kind = kinds[*options.replay % kinds.size()];
  const fs::path file = folder / ("input" + kind.ending);
  std::ofstream(file, std::ios::binary) << tests::spoiled(kind, seedOf(options, *options.replay));
  std::cout << file.string() << std::endl;
  std::cout << (kind.read(file) ? "read" : "refused") << '\n';
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App line("Reads damaged files, and says what crashes, hangs or throws.");
  line.add_option("--seed", options.seed, "Of all that is drawn");
  line.add_option("--inputs", options.inputs, "At most so many");
  line.add_option("--seconds", options.seconds, "At most so long");
  line.add_option("--log", options.log, "File that the inputs are appended to");
  line.add_option("--replay", options.replay, "Only the input of this number, in this process");
  CLI11_PARSE(line, argc, argv);
  const fs::path folder = fs::temp_directory_path() / ("smithereens-fuzz-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  try {
    if (options.replay) return replay(options, folder);
    const int status = fuzz(options, folder);
    fs::remove_all(folder);
    return status;
  } catch (const std::exception& exception) {
    std::cerr << exception.what() << '\n';
    return 2;
  }
}
