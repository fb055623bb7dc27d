#include "app/bench/accuracy.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/bench/accuracy_measure.h"
#include "app/bench/accuracy_rows.h"
#include "app/bench/plotting.h"
#include "app/bench/throughput.h"
#include "sim/methods/method_names.h"

namespace app {
namespace {

/// A step may cost so much that no smaller one is worth waiting for, CPU s.
constexpr double kMostSeconds = 8.0;
constexpr double kMostSecondsQuick = 0.2;
/// But where there is little to measure.
constexpr double kMostSecondsBrief = 60.0;
/// Short runs are repeated, and the quickest counts.
constexpr double kShort = 0.3;
constexpr int kRepeats = 3;

/// The reference is a run of this step over the longest stable one; its own error shows against one of twice
/// that.
constexpr double kReferenceStep = 1.0 / 16.0;
constexpr sim::Method kReferenceMethod = sim::Method::rungeKutta;

bool isOfBrief(sim::Method method) {
  return method == sim::Method::forwardEuler || method == sim::Settings{}.method;
}

/// Steps over the longest stable one of velocity Verlet (forward Euler: over its own), longest first.
std::vector<double> stepsOf(sim::Method method, bool quick, bool brief) {
  const std::string name(sim::nameOf(method));
  if (brief && method == sim::Method::forwardEuler) return {0.9};
  if (brief) return {0.9, 0.7, 0.5, 0.35};
  if (name.starts_with("implicit"))
    return quick ? std::vector<double>{4.0, 1.0} : std::vector<double>{16, 8, 4, 2, 1, 0.5, 0.25, 0.125};
  if (method == sim::Method::forwardEuler)
    return quick ? std::vector<double>{0.9, 0.3}
                 : std::vector<double>{0.9, 0.5, 0.25, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002};
  return quick ? std::vector<double>{0.9, 0.5}
               : std::vector<double>{1.25, 0.9, 0.7, 0.5, 0.35, 0.25, 0.125, 0.0625};
}

class SceneBench {
 public:
  SceneBench(const AccuracyScene& scene, bool quick) : scene_(scene), quick_(quick) {}

  std::vector<AccuracyRow> run() {
    measureReference();
    add(repeated({sim::Settings{}.method, std::nullopt}), std::string(sim::nameOf(sim::Settings{}.method)),
        true);
    for (const std::string& name : sim::methodNames()) {
      const sim::Method method = *sim::methodFromName(name);
      if (!scene_.brief || isOfBrief(method)) measureMethod(method);
    }
    return std::move(rows_);
  }

 private:
  void measureReference() {
    const double step = scene_.limit * kReferenceStep * (quick_ ? 8.0 : scene_.brief ? 2.0 : 1.0);
    const Stepping fine{kReferenceMethod, step};
    const Stepping coarse{kReferenceMethod, 2.0 * step};
    constexpr double kForEver = 1e9;
    const Course finer = follow(scene_, fine, kForEver);
    better_ = finer;
    add(follow(scene_, coarse, kForEver), "reference", false);
    rows_.back().step = finer.step;
    rows_.back().cpuSeconds = finer.cpuSeconds;
    if (!scene_.exact) return;
    better_ = exactCourse(scene_);
  }
  void measureMethod(sim::Method method) {
    // Undamped, forward Euler has no stable step; with a short one its errors grow slowly.
    const bool forward = method == sim::Method::forwardEuler;
    const double limit = forward && scene_.forwardLimit > 0.0 ? scene_.forwardLimit : scene_.limit;
    double before = 0.0, stepBefore = 0.0;
    for (const double share : stepsOf(method, quick_, scene_.brief)) {
      const double step = share * limit;
      if (before > 0.0 && before * stepBefore / step > 1.5 * most()) break;
      const Course course = repeated({method, step});
      // No step is longer than from one moment to the next.
      if (course.done() && course.step == stepBefore) continue;
      add(course, std::string(sim::nameOf(method)), false);
      if (course.status == "too slow") break;
      if (!course.done()) continue;
      before = course.cpuSeconds;
      stepBefore = course.step;
    }
  }
  Course repeated(const Stepping& stepping) const {
    Course best = follow(scene_, stepping, most());
    for (int repeat = 1; repeat < kRepeats && best.done() && best.cpuSeconds < kShort; ++repeat)
      best.cpuSeconds = std::min(best.cpuSeconds, follow(scene_, stepping, most()).cpuSeconds);
    return best;
  }
  double most() const { return quick_ ? kMostSecondsQuick : scene_.brief ? kMostSecondsBrief : kMostSeconds; }

  void add(const Course& course, const std::string& method, bool automatic) {
    AccuracyRow row;
    row.scene = scene_.name;
    row.title = scene_.title;
    row.method = method;
    row.automatic = automatic;
    row.step = course.step;
    row.stepOverLimit = course.step / scene_.limit;
    row.cpuSeconds = course.cpuSeconds;
    row.leastGain = scene_.leastGain;
    row.dampingRatio = scene_.dampingRatio;
    row.brief = scene_.brief;
    row.status = course.status;
    if (course.done()) {
      const Errors errors = errorsOf(scene_, course, better_);
      if (!std::isfinite(errors.position) || !std::isfinite(errors.strain)) row.status = "blown up";
      row.position = errors.position;
      row.strain = errors.strain;
      row.energy = course.energyError;
      row.breakTime = errors.breakTime;
      row.breakPlace = errors.breakPlace;
    }
    std::fprintf(stderr, "%-14s %-18s %9.3e s %6.3f cpu %9.4f s  position %.2e strain %.2e energy %.2e %s\n",
                 row.scene.c_str(), row.method.c_str(), row.step, row.stepOverLimit, row.cpuSeconds,
                 row.position.value_or(0), row.strain.value_or(0), row.energy.value_or(0),
                 row.status.c_str());
    rows_.push_back(std::move(row));
  }

  const AccuracyScene& scene_;
  bool quick_;
  Course better_;
  std::vector<AccuracyRow> rows_;
};

}  // namespace

sim::Status benchAccuracy(const AccuracyOptions& options) {
  const auto scenes = accuracyScenes(options.quick);
  if (!scenes) return scenes.problem();
  std::vector<AccuracyRow> rows;
  Json::Array json;
  for (const AccuracyScene& scene : *scenes) {
    if (!options.scenes.empty() && std::count(options.scenes.begin(), options.scenes.end(), scene.name) == 0)
      continue;
    for (AccuracyRow& row : SceneBench(scene, options.quick).run()) {
      json.push_back(toJson(row));
      rows.push_back(std::move(row));
    }
  }
  std::fputs(accuracyTables(rows).c_str(), stdout);
  if (auto written = writeRows(options.folder, "accuracy.json", json); !written) return written;
  if (!options.plots) return sim::Done{};
  for (const auto& [name, sheet] : accuracyPlots(rows)) {
    if (const auto saved = drawPlots(sheet, *options.plots / ("accuracy-" + name)); !saved) return saved;
  }
  return sim::Done{};
}

}  // namespace app
