#include "app/bench/accuracy_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "sim/methods/method_names.h"
#include "sim/state/settings.h"

namespace app {
namespace {

constexpr double kAsked = 0.01;  // strain error

Json optional(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

std::string text(const char* format, double value) {
  char digits[48];
  std::snprintf(digits, sizeof digits, format, value);
  return digits;
}
std::string percent(const std::optional<double>& value) {
  return value ? text("%.2g %%", 100.0 * *value) : "-";
}
std::string seconds(const TimeForError& time) {
  const char* const before = time.kind == TimeForError::Kind::between  ? ""
                             : time.kind == TimeForError::Kind::atMost ? "under "
                                                                       : "about ";
  return before + text("%.2g", time.seconds);
}

bool measured(const AccuracyRow& row) {
  return row.status == "done" && row.strain && row.position && row.method != "reference";
}

using Chosen = bool (*)(const AccuracyRow& row);
bool isWhole(const AccuracyRow& row) {
  return !row.brief;
}
bool isDamped(const AccuracyRow& row) {
  return row.automatic && row.dampingRatio > 0.0;
}

std::vector<std::string> scenesOf(const std::vector<AccuracyRow>& rows, Chosen chosen) {
  std::vector<std::string> names;
  for (const AccuracyRow& row : rows)
    if (chosen(row) && std::count(names.begin(), names.end(), row.scene) == 0) names.push_back(row.scene);
  return names;
}

/// Done ones, from the longest step on.
std::vector<AccuracyRow> courseOf(const std::vector<AccuracyRow>& rows, const std::string& scene,
                                  const std::string& method) {
  std::vector<AccuracyRow> course;
  for (const AccuracyRow& row : rows)
    if (row.scene == scene && row.method == method && !row.automatic && measured(row)) course.push_back(row);
  std::sort(course.begin(), course.end(), [](const auto& a, const auto& b) { return a.step > b.step; });
  return course;
}

const AccuracyRow* rowOf(const std::vector<AccuracyRow>& rows, const std::string& scene, bool automatic) {
  for (const AccuracyRow& row : rows)
    if (row.scene == scene && (automatic ? row.automatic : row.method == "reference")) return &row;
  return nullptr;
}

std::string goalLine(const std::vector<AccuracyRow>& rows, const std::string& scene) {
  const AccuracyRow* const ours = rowOf(rows, scene, true);
  const AccuracyRow* const reference = rowOf(rows, scene, false);
  if (ours == nullptr || reference == nullptr) return "";
  const auto euler = timeForStrainError(rows, scene, "forward-euler", kAsked);
  const auto mine = timeForStrainError(rows, scene, ours->method, kAsked);
  std::string gain = "-";
  if (euler && mine) {
    gain = text("%.3g", euler->seconds / mine->seconds);
    if (ours->leastGain > 0.0) gain += text(" (goal %.0f)", ours->leastGain);
  }
  return "| " + ours->title + " | " + percent(reference->position) + " | " + percent(reference->strain) +
         " | " + percent(ours->position) + " | " + percent(ours->strain) + " | " + percent(ours->energy) +
         " | " + text("%.2g", ours->cpuSeconds) + " | " + gain + " |\n";
}

/// Those of one title together, the most damped first.
std::vector<std::string> byDamping(const std::vector<AccuracyRow>& rows) {
  std::vector<std::string> names = scenesOf(rows, isDamped);
  std::sort(names.begin(), names.end(), [&](const std::string& left, const std::string& right) {
    const AccuracyRow& a = *rowOf(rows, left, true);
    const AccuracyRow& b = *rowOf(rows, right, true);
    return std::pair(a.title, -a.dampingRatio) < std::pair(b.title, -b.dampingRatio);
  });
  return names;
}

/// What damping decides: a method's step, and so its time.
std::string dampingLine(const std::vector<AccuracyRow>& rows, const std::string& scene) {
  const AccuracyRow* const ours = rowOf(rows, scene, true);
  if (ours == nullptr) return "";
  const auto euler = timeForStrainError(rows, scene, "forward-euler", kAsked);
  const auto mine = timeForStrainError(rows, scene, ours->method, kAsked);
  if (!euler || !mine) return "";
  return "| " + ours->title + " | " + text("%g", ours->dampingRatio) + " | " + percent(ours->strain) + " | " +
         seconds(*mine) + " | " + seconds(*euler) + " | " + text("%.3g", euler->seconds / mine->seconds) +
         " |\n";
}

std::string methodLines(const std::vector<AccuracyRow>& rows, const std::string& scene) {
  std::string lines;
  for (const std::string& method : sim::methodNames()) {
    const auto course = courseOf(rows, scene, method);
    if (course.empty()) continue;
    const AccuracyRow& longest = course.front();
    const auto best = std::min_element(course.begin(), course.end(),
                                       [](const auto& a, const auto& b) { return *a.strain < *b.strain; });
    const auto time = timeForStrainError(rows, scene, method, kAsked);
    lines += "| " + longest.title + " | " + method + " | " + text("%.3g", longest.stepOverLimit) + " | " +
             percent(longest.strain) + " | " + text("%.2g", longest.cpuSeconds) + " | " +
             (time ? seconds(*time) : "-") + " | " + percent(best->strain) + " | " + percent(best->energy) +
             " | " + text("%.2g", best->cpuSeconds) + " |\n";
  }
  return lines;
}

std::string breakLines(const std::vector<AccuracyRow>& rows) {
  std::string lines;
  for (const AccuracyRow& row : rows) {
    if (!measured(row) || !row.breakTime) continue;
    lines += "| " + row.method + (row.automatic ? " (automatic)" : "") + " | " +
             text("%.3g", row.stepOverLimit) + " | " + text("%.2g", row.cpuSeconds) + " | " +
             percent(row.breakTime) + " | " + text("%.2g", row.breakPlace.value_or(0.0)) + " |\n";
  }
  return lines;
}

/// The same for a method everywhere; apart for the colour-blind (after Okabe and Ito).
std::string colourOf(const std::string& method) {
  static const std::map<std::string, std::string> colours = {
      {"forward-euler", "#d55e00"}, {"symplectic-euler", "#56b4e9"}, {"velocity-verlet", "#0072b2"},
      {"rk4", "#009e73"},           {"implicit-euler", "#cc79a7"},   {"implicit-midpoint", "#e69f00"},
  };
  const auto found = colours.find(method);
  return found == colours.end() ? "#4d4d4d" : found->second;
}

using Value = std::optional<double> AccuracyRow::*;

ui::LogLogPlot plotOf(const std::vector<AccuracyRow>& rows, const std::string& scene,
                      const std::string& title, Value value) {
  ui::LogLogPlot plot;
  plot.title = title;
  plot.xTitle = "CPU time, s";
  plot.yTitle = "Relative error";
  plot.goal = kAsked;
  plot.goalName = "1 %";
  // More than this is no result, less than that is rounding.
  constexpr double kMost = 3.0, kLeast = 1e-12;
  for (const std::string& method : sim::methodNames()) {
    ui::PlotSeries series{
        method, colourOf(method), {}, sim::Settings{}.method == sim::methodFromName(method)};
    for (const AccuracyRow& row : courseOf(rows, scene, method)) {
      const auto& y = row.*value;
      if (y && *y > kLeast && *y < kMost) series.points.push_back({row.cpuSeconds, *y});
    }
    if (!series.points.empty()) plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

Json toJson(const AccuracyRow& row) {
  return {{"scene", row.scene},
          {"title", row.title},
          {"method", row.method},
          {"automatic", row.automatic},
          {"step_s", row.step},
          {"step_over_limit", row.stepOverLimit},
          {"cpu_s", row.cpuSeconds},
          {"position_error", optional(row.position)},
          {"strain_error", optional(row.strain)},
          {"energy_error", optional(row.energy)},
          {"break_time_error", optional(row.breakTime)},
          {"break_place_error_cm", optional(row.breakPlace)},
          {"damping_ratio", row.dampingRatio},
          {"brief", row.brief},
          {"least_gain", row.leastGain},
          {"status", row.status}};
}

AccuracyRow accuracyRow(const Json& json) {
  AccuracyRow row;
  row.scene = json.textAt("scene");
  row.title = json.textAt("title");
  row.method = json.textAt("method");
  row.automatic = json.flagAt("automatic");
  row.step = json.numberAt("step_s").value_or(0.0);
  row.stepOverLimit = json.numberAt("step_over_limit").value_or(0.0);
  row.cpuSeconds = json.numberAt("cpu_s").value_or(0.0);
  row.position = json.numberAt("position_error");
  row.strain = json.numberAt("strain_error");
  row.energy = json.numberAt("energy_error");
  row.breakTime = json.numberAt("break_time_error");
  row.breakPlace = json.numberAt("break_place_error_cm");
  row.dampingRatio = json.numberAt("damping_ratio").value_or(0.0);
  row.brief = json.flagAt("brief");
  row.leastGain = json.numberAt("least_gain").value_or(0.0);
  row.status = json.textAt("status");
  return row;
}

std::optional<TimeForError> timeForStrainError(const std::vector<AccuracyRow>& rows, const std::string& scene,
                                               const std::string& method, double error) {
  const auto course = courseOf(rows, scene, method);
  if (course.empty()) return std::nullopt;
  // From the shortest step back to where the error is too large for the first time.
  std::size_t good = course.size();
  while (good > 0 && *course[good - 1].strain <= error) --good;
  if (good == 0) return TimeForError{TimeForError::Kind::atMost, course.front().cpuSeconds};
  const AccuracyRow& bad = course[good - 1];
  if (good == course.size()) {
    double order = 1.0;
    if (course.size() > 1) {
      const AccuracyRow& before = course[course.size() - 2];
      order = std::max(1.0, std::log(*before.strain / *bad.strain) / std::log(before.step / bad.step));
    }
    return TimeForError{TimeForError::Kind::extrapolated,
                        bad.cpuSeconds * std::pow(*bad.strain / error, 1.0 / order)};
  }
  const AccuracyRow& fine = course[good];
  const double share = std::log(*bad.strain / error) / std::log(*bad.strain / *fine.strain);
  return TimeForError{TimeForError::Kind::between,
                      bad.cpuSeconds * std::pow(fine.cpuSeconds / bad.cpuSeconds, share)};
}

std::string accuracyTables(const std::vector<AccuracyRow>& rows) {
  std::string tables =
      "| scene | reference: position | strain | default settings: position | strain | energy | CPU s | "
      "forward "
      "Euler's time for 1 % strain error over the default method's |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const std::string& scene : scenesOf(rows, isWhole)) tables += goalLine(rows, scene);
  tables +=
      "\n| scene | method | longest stable step | strain error | CPU s | CPU s for 1 % strain error | least "
      "strain error | energy error | CPU s |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const std::string& scene : scenesOf(rows, isWhole)) tables += methodLines(rows, scene);
  std::string dampings;
  for (const std::string& scene : byDamping(rows)) dampings += dampingLine(rows, scene);
  if (!dampings.empty()) {
    tables +=
        "\n| scene | damping of the stiffest swing over critical | strain error of default settings | "
        "default "
        "method: CPU s for 1 % strain error | forward Euler's | ratio |\n"
        "| --- | --- | --- | --- | --- | --- |\n" +
        dampings;
  }
  if (const std::string lines = breakLines(rows); !lines.empty()) {
    tables +=
        "\n| first break of the bar torn apart, by | step | CPU s | error of its time | of its place, cm |\n"
        "| --- | --- | --- | --- | --- |\n" +
        lines;
  }
  return tables;
}

std::vector<std::pair<std::string, ui::PlotSheet>> accuracyPlots(const std::vector<AccuracyRow>& rows) {
  std::vector<std::pair<std::string, ui::PlotSheet>> sheets;
  for (const std::string& scene : scenesOf(rows, isWhole)) {
    const AccuracyRow* const any = rowOf(rows, scene, true);
    if (any == nullptr) continue;
    ui::PlotSheet sheet;
    sheet.title = any->title;
    sheet.plots.push_back(plotOf(rows, scene, "Error of strain", &AccuracyRow::strain));
    sheet.plots.push_back(plotOf(rows, scene, "Error of position", &AccuracyRow::position));
    if (any->breakTime)
      sheet.plots.push_back(plotOf(rows, scene, "Error of the first break's time", &AccuracyRow::breakTime));
    sheets.emplace_back(scene, std::move(sheet));
  }
  return sheets;
}

}  // namespace app
