#include "app/bench/document.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>
#include <utility>
#include <vector>

#include "app/bench/accuracy.h"
#include "app/bench/accuracy_rows.h"
#include "app/bench/contact.h"
#include "app/bench/stability.h"
#include "app/bench/throughput.h"
#include "modeling/files/output_file.h"

namespace app {
namespace {

/// The processor's own name, as Linux tells it.
std::string processorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::string machine() {
  std::ostringstream text;
  text << processorName() << ", " << std::thread::hardware_concurrency()
#ifdef __clang__
       << " cores, Clang " << __clang_major__ << ".\n";
#else
       << " cores, g++ " << __GNUC__ << '.' << __GNUC_MINOR__ << ".\n";
#endif
  return text.str();
}

std::string cellText(const Json& value) {
  if (const auto* const words = value.get<std::string>()) return *words;
  if (value.get<Json::Null>() != nullptr) return "-";
  const auto* const number = value.get<double>();
  if (number == nullptr) return dumped(value);
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.4g", *number);
  return digits.data();
}

/// Rows of plain values with their keys as headings.
std::string plainTable(const Json::Array& rows) {
  const auto isRow = [](const Json& row) { return row.get<Json::Object>() != nullptr; };
  if (rows.empty() || !std::all_of(rows.begin(), rows.end(), isRow)) return "";
  std::string head = "|", rule = "|", body;
  for (const auto& [key, value] : *rows.front().get<Json::Object>()) {
    std::string heading = key;
    std::replace(heading.begin(), heading.end(), '_', ' ');
    head += ' ' + heading + " |";
    rule += " --- |";
  }
  for (const Json& row : rows) {
    body += '|';
    for (const auto& [key, value] : *row.get<Json::Object>()) body += ' ' + cellText(value) + " |";
    body += '\n';
  }
  return head + '\n' + rule + '\n' + body;
}

std::string accuracySection(const Json::Array& json) {
  std::vector<AccuracyRow> rows;
  for (const Json& row : json) rows.push_back(accuracyRow(row));
  std::string section = accuracyTables(rows);
  for (const auto& [name, sheet] : accuracyPlots(rows))
    section += "\n![" + sheet.title + ": CPU time against error](plots/accuracy-" + name + ".png)\n";
  return section;
}

struct Section {
  const char* name;
  std::string (*write)(const Json::Array& rows);
};
constexpr std::array<Section, 6> kSections = {{{"throughput", plainTable},
                                               {"scaling", plainTable},
                                               {"accuracy", accuracySection},
                                               {"stability", stabilityTable},
                                               {"contact", plainTable},
                                               {"skip", plainTable}}};

/// Measures one after the other; a part that fails costs only itself. Gives the names of those.
std::vector<std::string> measureAll(const DocumentOptions& options, const std::filesystem::path& folder) {
  const std::pair<const char*, std::function<sim::Status()>> parts[] = {
      {"throughput", [&] { return benchThroughput(options.threads, folder); }},
      {"scaling", [&] { return benchScaling(1, folder); }},
      {"accuracy",
       [&] {
         return benchAccuracy({.quick = options.quick, .scenes = {}, .folder = folder, .plots = folder});
       }},
      {"stability", [&] { return benchStability(options.quick, folder); }},
      {"contact", [&] { return benchContact(options.quick, folder); }},
      {"skip", [&] { return benchSkip(1, options.quick, folder); }}};
  std::vector<std::string> failed;
  for (const auto& [name, measure] : parts) {
    std::fprintf(stderr, "bench %s\n", name);
    // Old results must not pass for new ones.
    std::error_code ignored;
    std::filesystem::remove(folder / (std::string(name) + ".json"), ignored);
    std::string problem;
    try {
      if (const sim::Status done = measure(); !done) problem = done.problem().line();
    } catch (const std::exception& error) {  // memory may run out in the largest
      problem = error.what();
    }
    if (problem.empty()) continue;
    std::fprintf(stderr, "bench %s: %s\n", name, problem.c_str());
    failed.emplace_back(name);
  }
  return failed;
}

sim::Result<Json::Array> resultsOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  const std::optional<Json> json = parseJson(std::string(std::istreambuf_iterator<char>(in), {}));
  const auto* const rows = json ? json->get<Json::Array>() : nullptr;
  if (rows == nullptr)
    return sim::Problem{file.string(), "there are no results here", "run `bench all` without --reuse"};
  return *rows;
}

}  // namespace

std::string withSection(std::string text, const std::string& name, const std::string& section) {
  const std::string begin = "<!-- begin " + name + " -->\n";
  const auto first = text.find(begin);
  const auto last = text.find("<!-- end " + name + " -->");
  if (first == std::string::npos || last == std::string::npos || last < first) return text;
  const auto from = first + begin.size();
  return text.replace(from, last - from, section);
}

sim::Status benchAll(const DocumentOptions& options) {
  const auto folder = options.docs / "plots";
  const auto page = options.docs / "benchmarks.md";
  std::ifstream in(page);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  if (text.empty())
    return sim::Problem{page.string(), "there is no such page", "name the folder with --docs"};
  std::vector<std::string> failed;
  if (!options.reuse) {
    failed = measureAll(options, folder);
    text = withSection(std::move(text), "machine", machine());
  }
  for (const Section& section : kSections) {
    if (text.find(std::string("<!-- begin ") + section.name + " -->") == std::string::npos) continue;
    const auto file = folder / (std::string(section.name) + ".json");
    if (!std::filesystem::exists(file)) continue;
    const auto rows = resultsOf(file);
    if (!rows) return rows.problem();
    text = withSection(std::move(text), section.name, section.write(*rows));
  }
  if (const sim::Status written = modeling::replaceFile(page, text); !written) return written;
  if (failed.empty()) return sim::Done{};
  std::string names;
  for (const std::string& name : failed) names += (names.empty() ? "" : ", ") + name;
  return sim::Problem{page.string(), "it keeps its old figures of what failed: " + names,
                      "run these by themselves to see why"};
}

}  // namespace app
