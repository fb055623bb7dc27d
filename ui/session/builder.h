#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
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
  bool isAbandoned = false;             ///< it ended before it was ready, as a newer was asked for
};

/// Turns the scene into a lattice while it is edited, in a thread of its own (BackgroundWorker).
class Builder {
 public:
  Builder();

  void request(const modeling::Scene& scene, const std::filesystem::path& folder);
  /// The newest that is ready; never null. Never one that ended early because a newer was asked for.
  std::shared_ptr<const Preview> newest() const;
  /// Something is being built or waits to be.
  bool isBusy() const { return worker_.isBusy(); }
  /// What takes long, in words ("reading cup.fbx, 3 s"); empty: nothing does.
  std::string waitingFor() const;
  /// No file is read any longer: the build ends with a Problem that says so.
  void giveUp();
  void requestStop() { worker_.requestStop(); }

 private:
  struct Request {
    modeling::Scene scene;
    std::filesystem::path folder;
  };
  /// What the builder's thread and the window's tell each other.
  struct Talk {
    std::mutex mutex;
    std::string waitingFor;  ///< under the mutex
    std::atomic<bool> givenUp{false};
  };

  std::shared_ptr<Talk> talk_ = std::make_shared<Talk>();
  mutable std::shared_ptr<const Preview> kept_ = std::make_shared<const Preview>();
  BackgroundWorker<Request, Preview> worker_;
};

}  // namespace ui
