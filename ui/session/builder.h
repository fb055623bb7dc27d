#pragma once

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "modeling/scene/build.h"
#include "sim/state/snapshot.h"

namespace ui {

/// A scene built, or why it could not be. Immutable.
struct Preview {
  std::uint64_t revision = 0;  ///< of the request
  modeling::Scene scene;
  std::shared_ptr<const modeling::BuiltScene> built;  ///< null: see problem, or there are no parts
  sim::SnapshotPointer rest;                          ///< before anything moves; null without `built`
  std::optional<sim::Problem> problem;
};

/// The thread that turns the scene into a lattice while it is edited. Of requests that come faster than they
/// can be built the newest counts. Every function may be called from any thread and returns at once.
class Builder {
 public:
  Builder();
  ~Builder();
  Builder(const Builder&) = delete;
  Builder& operator=(const Builder&) = delete;

  /// Answers the request's revision.
  std::uint64_t request(const modeling::Scene& scene, const std::filesystem::path& folder);
  /// The newest that is ready; never null.
  std::shared_ptr<const Preview> newest() const;
  /// Something is being built or waits to be.
  bool isBusy() const;

 private:
  class Thread;
  std::shared_ptr<Thread> thread_;  ///< shared with the thread itself, which may outlive this
  std::jthread runner_;
};

}  // namespace ui
