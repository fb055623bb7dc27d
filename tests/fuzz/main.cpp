// Damages inputs of all kinds and lets the program's own functions read them: docs/architecture.md, "Fuzz".
#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "tests/fuzz/bounded.h"
#include "tests/fuzz/samples.h"
#include "tests/fuzz/trials.h"

namespace {

namespace fs = std::filesystem;
using tests::Sample;

/// s: for one file as a part and as an obstacle, each read within a minute.
constexpr double kReadersPatience = 130.0;

struct Options {
  std::uint64_t seed = 1;
  std::uint64_t inputs = 0;
  double seconds = 0.0;
  double patience = 20.0;
  std::string kind;
  std::string log;
  std::string replay;
  std::string keep;
};

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

/// A folder that goes with the program.
class Scratch {
 public:
  Scratch() : path_(fs::temp_directory_path() / ("smithereens-fuzz-" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  ~Scratch() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// One input: what was damaged, and by which seed. So it stands in the log, and is found again.
struct Input {
  std::size_t sample = 0;
  std::uint64_t seed = 0;

  std::string name() const {
    const Sample& of = tests::samples()[sample];
    return std::string(of.kind) + "/" + std::string(of.file) + " " + std::to_string(seed);
  }
};

class Fuzzer {
 public:
  explicit Fuzzer(const Options& options) : options_(options), whole_(scratch_.path() / "whole") {
    if (!options.log.empty()) log_.open(options.log);
  }

  /// Sound inputs must be read, or the damaged ones say nothing.
  bool begin() {
    const auto written =
        tests::runBounded([&] { return std::string(tests::writeSamples(whole_) ? "written" : ""); },
                          {60.0, std::size_t{4} << 30U});
    if (!written.sound) return false;
    bool allRead = true;
    for (std::size_t sample = 0; sample < tests::samples().size(); ++sample) {
      if (!isWanted(sample)) continue;
      const Sample& of = tests::samples()[sample];
      const tests::Ending ending = tried(sample, bytesOf(whole_ / of.kind / of.file));
      const bool isRead = ending.sound && !ending.words.starts_with("refused");
      // This one has all keys, and not all of what they name.
      if (isRead || of.file == "full.scene.json") continue;
      std::cerr << "sound " << of.kind << "/" << of.file << ": " << ending.words << '\n';
      allRead = false;
    }
    return allRead;
  }

  /// False: something is wrong with what was found.
  bool run(const Input& input, const std::string& before = "") {
    const Sample& of = tests::samples()[input.sample];
    const std::string bytes =
        tests::damagedInput(bytesOf(whole_ / of.kind / of.file),
                            bytesOf(whole_ / of.kind / otherOf(input).file), of.nature, input.seed);
    const tests::Ending ending = tried(input.sample, bytes);
    ++counts_[std::string(of.kind)]
             [ending.sound ? ending.words.substr(0, ending.words.find_first_of(":,")) : "FAULT"];
    const std::string line = input.name() + " " + ending.words;
    if (log_.is_open()) log_ << line << std::endl;
    if (!before.empty() && before != line) std::cout << "was " << before << "\nnow " << line << '\n';
    if (ending.sound) return true;
    std::cout << "FAULT " << line << std::endl;
    if (!options_.keep.empty()) keep(input, bytes);
    return false;
  }

  bool isWanted(std::size_t sample) const {
    return options_.kind.empty() || tests::samples()[sample].kind == options_.kind;
  }

  void tell() const {
    for (const auto& [kind, endings] : counts_) {
      std::cout << kind << ":";
      for (const auto& [words, count] : endings) std::cout << " " << words << " " << count << ";";
      std::cout << '\n';
    }
  }

 private:
  tests::Ending tried(std::size_t sample, const std::string& bytes) {
    const Sample& of = tests::samples()[sample];
    const fs::path folder = scratch_.path() / "tried";
    std::error_code error;
    fs::remove_all(folder, error);
    fs::copy(whole_ / of.kind, folder, fs::copy_options::recursive);
    std::ofstream(folder / of.file, std::ios::binary) << bytes;
    // Readers of other people's formats have a limit of their own, which is to be seen at work.
    const bool isForeign = of.kind == "mesh" || of.kind == "environment";
    const double patience = isForeign ? std::max(options_.patience, kReadersPatience) : options_.patience;
    return tests::runBounded([&] { return tests::tryInput(of.kind, folder / of.file); }, {patience});
  }

  /// Another input of the same kind and nature, or the same.
  static const Sample& otherOf(const Input& input) {
    const std::vector<Sample>& all = tests::samples();
    std::vector<std::size_t> alike;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].kind == all[input.sample].kind && all[i].nature == all[input.sample].nature)
        alike.push_back(i);
    }
    return all[alike[input.seed % alike.size()]];
  }

  void keep(const Input& input, const std::string& bytes) const {
    fs::create_directories(options_.keep);
    const Sample& of = tests::samples()[input.sample];
    std::ofstream(fs::path(options_.keep) / (std::to_string(input.seed) + "-" + std::string(of.file)),
                  std::ios::binary)
        << bytes;
  }

  const Options& options_;
  Scratch scratch_;
  fs::path whole_;
  std::ofstream log_;
  std::map<std::string, std::map<std::string, std::size_t>>
      counts_;  ///< by kind and beginning of what was found
};

/// All samples in turn, each with the next seed.
bool fuzz(Fuzzer& fuzzer, const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  bool allSound = true;
  std::uint64_t done = 0;
  const auto goesOn = [&] {
    const bool inTime = options.seconds <= 0.0 || seconds() < options.seconds;
    return inTime && (options.inputs == 0 || done < options.inputs);
  };
  for (std::uint64_t turn = 0; goesOn(); ++turn) {
    for (std::size_t sample = 0; sample < tests::samples().size() && goesOn(); ++sample) {
      if (!fuzzer.isWanted(sample)) continue;
      ++done;
      allSound = fuzzer.run({sample, options.seed * 1'000'000 + turn}) && allSound;
    }
  }
  std::cout << done << " inputs in " << static_cast<int>(seconds()) << " s\n";
  return allSound;
}

std::optional<Input> inputIn(const std::string& line) {
  std::istringstream words(line);
  std::string name;
  Input input;
  if (!(words >> name >> input.seed)) return std::nullopt;
  for (; input.sample < tests::samples().size(); ++input.sample) {
    const Sample& of = tests::samples()[input.sample];
    if (name == std::string(of.kind) + "/" + std::string(of.file)) return input;
  }
  return std::nullopt;
}

/// The inputs of a log, or of lines cut out of one; tells where another thing comes of them now.
bool replay(Fuzzer& fuzzer, const Options& options) {
  std::ifstream lines(options.replay);
  if (!lines) {
    std::cerr << options.replay << " cannot be read\n";
    return false;
  }
  bool allSound = true;
  std::string line;
  while (std::getline(lines, line)) {
    if (line.starts_with("FAULT ")) line = line.substr(6);
    const std::optional<Input> input = inputIn(line);
    if (input && fuzzer.isWanted(input->sample)) allSound = fuzzer.run(*input, line) && allSound;
  }
  return allSound;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App application{"Damages inputs of all kinds, and sees that the program stays sound"};
  application.add_option("--seed", options.seed, "Which inputs: others for each number");
  application.add_option("--inputs", options.inputs, "How many; 0: no end");
  application.add_option("--seconds", options.seconds, "How long; 0: no end");
  application.add_option("--patience", options.patience, "How long one input may take, s");
  application.add_option(
      "--kind", options.kind,
      "Only these: scene, tracks, take, network, dump, mesh, environment, kept, recovery, report");
  application.add_option("--log", options.log,
                         "A file that gets a line for each input: what, seed, what came of it");
  application.add_option("--replay", options.replay, "A log, or lines of one: those inputs once more");
  application.add_option("--keep", options.keep, "A folder that gets the inputs which show a fault");
  CLI11_PARSE(application, argc, argv);
  if (options.inputs == 0 && options.seconds <= 0.0) options.inputs = 1000;
  Fuzzer fuzzer(options);
  if (!fuzzer.begin()) return 1;
  const bool sound = options.replay.empty() ? fuzz(fuzzer, options) : replay(fuzzer, options);
  fuzzer.tell();
  return sound ? 0 : 1;
}
