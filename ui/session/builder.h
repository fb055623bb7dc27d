#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "modeling/scene/build.h"
#include "sim/state/snapshot.h"
#include "ui/session/background_worker.h"

namespace ui {

/// A scene built, or why it could not be. Immutable.
struct Preview {
  modeling::Scene scene;
  std::shared_ptr<const modeling::BuiltScene> built;  ///< null: see problem, or there are no parts
  /// Where a gluing fails: the scene without those that do, to be looked at; else null.
  std::shared_ptr<const modeling::BuiltScene> unglued;
  struct FailedGluing {
    std::size_t gluing = 0;  ///< index in the scene
    sim::Problem problem;
  };
  std::vector<FailedGluing> failedGluings;
  sim::SnapshotPointer rest;            ///< of `built` or `unglued`, before anything moves; null without both
  std::optional<sim::Problem> problem;  ///< of gluings, the first
};

/// Turns the scene into a lattice while it is edited, in a thread of its own (BackgroundWorker).
class Builder {
 public:
  Builder();

  void request(const modeling::Scene& scene, const std::filesystem::path& folder);
  /// The newest that is ready; never null.
  std::shared_ptr<const Preview> newest() const;
  /// Something is being built or waits to be.
  bool isBusy() const { return worker_.isBusy(); }
  void requestStop() { worker_.requestStop(); }

 private:
  struct Request {
    modeling::Scene scene;
    std::filesystem::path folder;
  };
  BackgroundWorker<Request, Preview> worker_;
};

}  // namespace ui
