#pragma once

#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "ui/session/builder.h"

namespace ui {

/// What a run will cost on this machine, and what looks wrong before it begins.
struct Preflight {
  std::size_t nodes = 0;
  std::size_t bonds = 0;
  std::size_t cells = 0;
  double stableStep = 0.0;              ///< s
  double step = 0.0;                    ///< s: the one that will be used at first
  double steps = 0.0;                   ///< of the whole run
  double clockForSecond = 0.0;          ///< seconds of the clock for a simulated one
  double clockForRun = 0.0;             ///< seconds of the clock
  std::size_t bondsBreakingAtRest = 0;  ///< stretched past their threshold before anything moves
  std::size_t memoryBytes = 0;
  double takeBytes = 0.0;
};

/// Finds it out on a thread of its own, by making steps and timing them. Every function returns at once.
class PreflightRun {
 public:
  PreflightRun() = default;
  ~PreflightRun();
  PreflightRun(const PreflightRun&) = delete;
  PreflightRun& operator=(const PreflightRun&) = delete;

  void start(const std::shared_ptr<const Preview>& preview);
  bool isDone() const;
  /// Nothing while it is not done, or where there is a problem.
  std::optional<Preflight> result() const;
  std::optional<sim::Problem> problem() const;

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  std::jthread runner_;
};

}  // namespace ui
