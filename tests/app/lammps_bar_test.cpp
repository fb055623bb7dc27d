#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/kernels.h"
#include "tests/support/run_program.h"

namespace {

const std::string kBar = SMITHEREENS_SOURCE_DIR "/tests/data/lammps-bar/";

using Positions = std::vector<std::array<double, 3>>;

/// Nodes of a LAMMPS text dump, sorted by id.
Positions dumped(int step) {
  std::ifstream stream(kBar + "caseA." + std::to_string(step) + ".txt");
  std::string line;
  for (int i = 0; i < 9; ++i) std::getline(stream, line);
  Positions positions;
  int id = 0;
  std::array<double, 3> x{};
  while (stream >> id >> x[0] >> x[1] >> x[2] && std::getline(stream, line)) positions.push_back(x);
  return positions;
}

/// Frames of an extended XYZ file by the step that their comment line states.
std::map<int, Positions> exported(const std::string& file) {
  std::ifstream stream(file);
  std::map<int, Positions> frames;
  std::string line;
  while (std::getline(stream, line)) {
    const int nodes = std::stoi(line);
    std::getline(stream, line);
    Positions& frame = frames[std::stoi(line.substr(line.find("Step=") + 5))];
    for (int node = 0; node < nodes && std::getline(stream, line); ++node) {
      std::istringstream words(line);
      std::string species;
      std::array<double, 3> x{};
      words >> species >> x[0] >> x[1] >> x[2];
      frame.push_back(x);
    }
  }
  return frames;
}

double largestDifference(const Positions& a, const Positions& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t node = 0; node < a.size(); ++node) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      largest = std::max(largest, std::abs(a[node][axis] - b[node][axis]));
    }
  }
  return largest;
}

/// Frames of the bar, simulated with these options, by the number of their step.
std::map<int, Positions> moved(const std::string& options) {
  const std::string folder = tests::freshFolder("smithereens-bar");
  const std::string take = folder + "/bar.take";
  const auto run = tests::runCli("simulate \"" + kBar + "bar.scene.json\" --take " + take + " " + options);
  INFO(run.errors);
  REQUIRE(run.status == 0);
  REQUIRE(tests::runCli("export " + take + " --format xyz --out " + folder + "/bar.xyz").status == 0);
  auto frames = exported(folder + "/bar.xyz");
  std::filesystem::remove_all(folder);
  return frames;
}

/// Two independent implementations of the same arithmetic differ by rounding alone, which grows slowly in a
/// bar that doesn't break: 6e-14 after 10,000 steps.
TEST_CASE("the bar moves as LAMMPS moves it, with every kernel") {
  const std::string kernel = GENERATE(from_range(tests::kernelsHere()));
  INFO(kernel);
  const tests::ChosenKernel chosen(kernel);
  // Every thousandth step is a frame; the first one is not needed: its force is that of the file.
  auto frames = moved("--until 5 --fps 2");
  CHECK(frames.size() == 11);
  CHECK(dumped(1000).size() == 225);
  CHECK(largestDifference(frames[1000], dumped(1000)) < 1e-12);
  CHECK(largestDifference(frames[10000], dumped(10000)) < 1e-10);
}

TEST_CASE("the other methods come near the same motion with their own order") {
  struct Case {
    const char* method;
    double order;
  };
  const Case one = GENERATE(Case{"velocity-verlet", 2.0}, Case{"symplectic-euler", 1.0}, Case{"rk4", 4.0},
                            Case{"implicit-midpoint", 2.0}, Case{"implicit-euler", 1.0});
  INFO(one.method);
  const auto after = [](const std::string& method, int steps) {
    constexpr double kUntil = 0.04;
    std::ostringstream options;
    options << std::setprecision(17) << "--until " << kUntil << " --fps " << 1.0 / kUntil << " --method "
            << method << " --step " << kUntil / steps;
    return moved(options.str())[steps];
  };
  const Positions right = after("rk4", 800);
  const double coarse = largestDifference(after(one.method, 50), right);
  const double fine = largestDifference(after(one.method, 100), right);
  // The next term of the error changes the order read at these steps by a few per cent.
  CHECK(std::log2(coarse / fine) == Approx(one.order).margin(0.25));
}

TEST_CASE("forward Euler is refused the bar, which has no damping") {
  const auto run =
      tests::runCli("simulate \"" + kBar + "bar.scene.json\" --until 0.1 --method forward-euler");
  CHECK(run.status == 2);
  CHECK(run.errors.find("no step is stable") != std::string::npos);
}

TEST_CASE("a step that is too long for the bar is refused, and the longest named") {
  const auto run = tests::runCli("simulate \"" + kBar + "bar.scene.json\" --until 0.1 --step 0.1");
  CHECK(run.status == 2);
  CHECK(run.errors.find("longer than 0.02") != std::string::npos);
  CHECK(std::count(run.errors.begin(), run.errors.end(), '\n') == 1);
}

TEST_CASE("with enough frames a second every step is one, and states its time") {
  const std::string folder = tests::freshFolder("smithereens-steps");
  const std::string take = folder + "/bar.take";
  REQUIRE(tests::runCli("simulate \"" + kBar + "bar.scene.json\" --until 0.005 --fps 1e6 --take " + take)
              .status == 0);
  REQUIRE(tests::runCli("export " + take + " --format xyz --out " + folder + "/bar.xyz").status == 0);
  auto frames = exported(folder + "/bar.xyz");
  CHECK(frames.size() == 11);
  CHECK(largestDifference(frames[1], dumped(1)) < 1e-15);
  std::filesystem::remove_all(folder);
}

}  // namespace
