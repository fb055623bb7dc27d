#pragma once

#include <memory>
#include <optional>
#include <thread>

#include "modeling/preflight/preflight.h"
#include "ui/session/builder.h"

namespace ui {

/// Finds out what a run will cost on this machine, and what looks wrong before it begins, on a thread of its
/// own. Every function returns at once.
class PreflightRun {
 public:
  PreflightRun() = default;
  ~PreflightRun();
  PreflightRun(const PreflightRun&) = delete;
  PreflightRun& operator=(const PreflightRun&) = delete;

  void start(const std::shared_ptr<const Preview>& preview);
  bool isDone() const;
  /// Nothing while it is not done, or where there is a problem.
  std::optional<modeling::Preflight> result() const;
  std::optional<sim::Problem> problem() const;

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  std::jthread runner_;
};

}  // namespace ui
