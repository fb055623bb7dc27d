#include <cstdio>

#include "app/bench/bodies.h"
#include "app/bench/throughput.h"
#include "app/bench/timing.h"
#include "modeling/scene/resources.h"
#include "modeling/scene/scene_file.h"

namespace app {
namespace {

using Flag = bool sim::SkipSettings::*;

/// One thing that may be left out, with its name in the scene, or several.
struct Switch {
  const char* name;
  std::vector<Flag> flags;
};

const std::vector<Switch>& switches() {
  static const std::vector<Switch> all = {
      {"sleep", {&sim::SkipSettings::sleep}},
      {"rigid", {&sim::SkipSettings::rigid}},
      {"sleep, rigid", {&sim::SkipSettings::sleep, &sim::SkipSettings::rigid}}};
  return all;
}

sim::SkipSettings without(const Switch& off) {
  sim::SkipSettings skip;
  for (const Flag flag : off.flags) skip.*flag = false;
  return skip;
}

/// A scene, from when to when it is timed, and what is switched off to compare.
struct Case {
  std::string name;
  modeling::Scene scene;
  double from = 0.0;   ///< s: run with everything skipped up to here, and not timed
  double until = 0.0;  ///< s
  std::vector<const Switch*> switches;
  bool moving = false;  ///< compare with as much time at the scene's beginning, too
};

std::vector<const Switch*> switchesNamed(std::initializer_list<const char*> names) {
  std::vector<const Switch*> found;
  for (const char* name : names) {
    for (const Switch& one : switches()) {
      if (std::string_view(one.name) == name) found.push_back(&one);
    }
  }
  return found;
}

sim::Result<modeling::Scene> sceneNamed(const char* name) {
  auto loaded =
      modeling::loadScene(modeling::resourcesFolder() / "scenes" / (std::string(name) + ".scene.json"));
  if (!loaded) return loaded.problem();
  return loaded->scene;
}

/// s: by then all of the teapot lies still.
constexpr double kSettled = 2.4;

sim::Result<std::vector<Case>> skipCases(bool quick) {
  const auto drop = sceneNamed("teapot-drop");
  if (!drop) return drop.problem();
  modeling::Scene cup = tubeScene(40, 16);
  cup.parts.front().worldFromPart.position.z() = 100.0;

  std::vector<Case> cases;
  cases.push_back({"tube in flight", cup, 0.0, 0.2, switchesNamed({"rigid"})});
  cases.push_back({"teapot-drop, breaking", *drop, 0.0, quick ? 0.03 : 0.1, switchesNamed({"sleep, rigid"})});
  if (quick) return cases;
  cases.push_back(
      {"teapot-drop, to rest", *drop, 0.0, 2.0, switchesNamed({"sleep", "rigid", "sleep, rigid"})});
  cases.push_back(
      {"teapot-drop, at rest", *drop, kSettled, kSettled + 0.1, switchesNamed({"sleep, rigid"}), true});
  return cases;
}

/// How a run went from `from` to `until`.
struct Outcome {
  double seconds = 0.0;  ///< of the processor: what else the machine does is not counted
  std::uint64_t hash = 0;
  sim::Snapshot end;
  sim::Work work;
};

/// The scene at `one.from`; `settled` is its state there with everything skipped, empty at its beginning.
sim::Result<std::unique_ptr<sim::Simulation>> startAt(const Case& one, const sim::SkipSettings& skip,
                                                      int threads, const std::vector<std::byte>& settled) {
  modeling::Scene scene = one.scene;
  scene.solver.skip = skip;
  auto simulation = start(scene, threads);
  if (!simulation || settled.empty()) return simulation;
  if (skip == one.scene.solver.skip) {
    if (const sim::Status restored = (*simulation)->restore(settled); !restored) return restored.problem();
    return simulation;
  }
  // What sleeps must wake where nothing may sleep.
  auto resting = startAt(one, one.scene.solver.skip, threads, settled);
  if (!resting) return resting;
  if (const sim::Status taken = (*simulation)->takeOver(**resting); !taken) return taken.problem();
  return simulation;
}

sim::Result<Outcome> timed(const Case& one, const sim::SkipSettings& skip, int threads,
                           const std::vector<std::byte>& settled) {
  auto simulation = startAt(one, skip, threads, settled);
  if (!simulation) return simulation.problem();
  sim::Simulation& running = **simulation;
  const double before = secondsNow().cpu;
  if (const sim::Status ran = running.advanceTo(one.until); !ran) return ran.problem();
  Outcome outcome;
  outcome.seconds = secondsNow().cpu - before;
  outcome.hash = running.stateHash();
  outcome.end = running.snapshot();
  outcome.work = running.work();
  return outcome;
}

/// State at the beginning of what is timed; empty where that is the scene's beginning.
sim::Result<std::vector<std::byte>> settledState(const Case& one, int threads) {
  if (!(one.from > 0.0)) return std::vector<std::byte>{};
  auto simulation = start(one.scene, threads);
  if (!simulation) return simulation.problem();
  if (const sim::Status ran = (*simulation)->advanceTo(one.from); !ran) return ran.problem();
  return (*simulation)->checkpoint();
}

double furthestApart(const sim::Snapshot& a, const sim::Snapshot& b) {
  double most = 0.0;
  for (std::size_t n = 0; n < a.positions.size(); ++n)
    most = std::max(most, (a.positions[n] - b.positions[n]).norm());
  return most;
}

Json compared(const Case& one, const char* name, const Outcome& with, const Outcome& without) {
  const double apart = furthestApart(with.end, without.end);
  const bool identical = with.hash == without.hash;
  std::printf("%-28s %-14s %9.3f %9.3f %8.3f  ", one.name.c_str(), name, with.seconds, without.seconds,
              with.seconds / without.seconds);
  if (identical) {
    std::printf("identical\n");
  } else {
    std::printf("nodes up to %.2g cm apart, %zu and %zu fragments\n", apart, with.end.fragments.size(),
                without.end.fragments.size());
  }
  std::fflush(stdout);
  return {{"scene", one.name},
          {"skip", name},
          {"simulated_s", one.until - one.from},
          {"with_s", with.seconds},
          {"without_s", without.seconds},
          {"ratio", with.seconds / without.seconds},
          {"identical", identical},
          {"largest_difference_cm", apart},
          {"fragments_with", with.end.fragments.size()},
          {"fragments_without", without.end.fragments.size()}};
}

sim::Status compareCase(const Case& one, int threads, Json::Array& rows) {
  const auto settled = settledState(one, threads);
  if (!settled) return settled.problem();
  const auto with = timed(one, {}, threads, *settled);
  if (!with) return with.problem();
  for (const Switch* off : one.switches) {
    const auto full = timed(one, without(*off), threads, *settled);
    if (!full) return full.problem();
    rows.push_back(compared(one, off->name, *with, *full));
  }
  if (!one.moving) return sim::Done{};
  Case beginning = one;
  beginning.until = one.until - one.from;
  beginning.from = 0.0;
  const auto moving = timed(beginning, {}, threads, {});
  if (!moving) return moving.problem();
  rows.push_back(compared(one, "its beginning", *with, *moving));
  return sim::Done{};
}

}  // namespace

sim::Status benchSkip(int threads, bool quick, const std::optional<std::filesystem::path>& folder) {
  const auto cases = skipCases(quick);
  if (!cases) return cases.problem();
  Json::Array rows;
  std::printf("%-28s %-14s %9s %9s %8s  %s\n", "scene", "skip", "with, s", "without", "ratio", "difference");
  for (const Case& one : *cases) {
    if (const sim::Status done = compareCase(one, threads, rows); !done) return done;
  }
  return writeRows(folder, "skip.json", rows);
}

}  // namespace app
