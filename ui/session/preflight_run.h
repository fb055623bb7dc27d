#pragma once

#include <memory>
#include <optional>

#include "modeling/preflight/preflight.h"
#include "ui/session/builder.h"

namespace ui {

/// Finds out what a run will cost on this machine, and what looks wrong before it begins, in a thread of its
/// own (BackgroundWorker).
class PreflightRun {
 public:
  PreflightRun();

  void start(const std::shared_ptr<const Preview>& preview);
  bool isDone() const;
  /// Nothing while it is not done, or where there is a problem.
  std::optional<modeling::Preflight> result() const;
  std::optional<sim::Problem> problem() const;

 private:
  using Worker = BackgroundWorker<std::shared_ptr<const Preview>, std::optional<modeling::Preflight>>;

  Worker worker_;
  std::uint64_t started_ = 0;  ///< number of the request; 0: none yet
};

}  // namespace ui
