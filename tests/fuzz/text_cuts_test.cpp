#include "tests/fuzz/text_cuts.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include <catch2/catch.hpp>

#include "modeling/import/lammps_data.h"
#include "modeling/scene/scene_file.h"
#include "tests/modeling/scene_examples.h"
#include "tests/support/run_program.h"

namespace {

constexpr std::size_t kCuts = 100;

/// The line of the problem, or "" when the text is sound.
using Reader = std::function<std::string(const std::string&)>;

std::string sceneProblem(const std::string& text) {
  const auto file = modeling::parseScene(text, "cut");
  return file.ok() ? "" : file.problem().line();
}

std::string networkProblem(const std::string& text) {
  const auto data = modeling::parseLammpsData(text, "cut");
  return data.ok() ? "" : data.problem().line();
}

std::string barText() {
  std::ifstream stream(SMITHEREENS_SOURCE_DIR "/tests/data/lammps-bar/caseA.data");
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Damages that matter: some only change a digit, which no reader can know.
std::vector<std::string> unsoundTexts(const std::string& text, const Reader& reader) {
  std::vector<std::string> found;
  for (std::uint64_t seed = 1; found.size() < kCuts && seed < 10 * kCuts; ++seed) {
    std::string cut = tests::damaged(text, seed);
    if (!reader(cut).empty()) found.push_back(std::move(cut));
  }
  return found;
}

void checkLine(const std::string& line) {
  INFO(line);
  CHECK(line.find("cut:") != std::string::npos);
  CHECK(line.size() < 500);
  CHECK(std::none_of(line.begin(), line.end(), [](char letter) { return letter >= 0 && letter < ' '; }));
}

void checkCuts(const std::string& text, const Reader& reader) {
  REQUIRE(reader(text).empty());
  const std::vector<std::string> cuts = unsoundTexts(text, reader);
  REQUIRE(cuts.size() == kCuts);
  for (const std::string& cut : cuts) checkLine(reader(cut));
}

/// The program says the same: one line, status 2, and no more than 1 GB (runCli's limit).
void checkProgram(const std::string& text, const Reader& reader, const std::string& extension) {
  const std::string folder = tests::freshFolder("smithereens-cuts");
  const std::string file = folder + "/cut" + extension;
  for (const std::string& cut : unsoundTexts(text, reader)) {
    std::ofstream(file, std::ios::binary) << cut;
    const tests::Answer answer = tests::runCli("info " + file);
    INFO(answer.errors);
    CHECK(answer.status == 2);
    CHECK(answer.output.empty());
    CHECK(std::count(answer.errors.begin(), answer.errors.end(), '\n') == 1);
    CHECK(answer.errors.starts_with(file + ":"));
  }
  std::filesystem::remove_all(folder);
}

TEST_CASE("a damaged scene is a problem with a place, never a crash") {
  checkCuts(tests::kFullScene, sceneProblem);
}

TEST_CASE("a damaged network file is a problem with a place, never a crash") {
  checkCuts(barText(), networkProblem);
}

TEST_CASE("the program ends with status 2 and one line on a damaged scene") {
  checkProgram(tests::kFullScene, sceneProblem, ".scene.json");
}

TEST_CASE("the program ends with status 2 and one line on a damaged network file") {
  checkProgram(barText(), networkProblem, ".data");
}

}  // namespace
