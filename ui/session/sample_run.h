#pragma once

#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "modeling/material/material.h"
#include "sim/base/result.h"
#include "sim/surface/surface_mesh.h"

namespace ui {

/// A small bar of a material that is thrown flat across a rod, on a thread of its own: what a material does,
/// to look at while its numbers are changed. start() and view() return at once.
class SampleRun {
 public:
  static constexpr double kDuration = 0.05;  ///< s, simulated
  static constexpr int kFrames = 60;
  static constexpr double kRodRadius = 0.8;  ///< cm, along y, its axis at the origin

  struct View {
    std::vector<std::shared_ptr<const sim::SurfaceMesh>> frames;  ///< so far, evenly spaced
    bool done = false;
    bool broke = false;
    std::optional<sim::Problem> problem;
  };

  SampleRun() = default;
  /// Waits for the steps that are under way, which take milliseconds.
  ~SampleRun();
  SampleRun(const SampleRun&) = delete;
  SampleRun& operator=(const SampleRun&) = delete;

  /// Drops what runs and begins anew.
  void start(const modeling::Material& material);
  void stop();
  bool isStarted() const { return shared_ != nullptr; }
  View view() const;

 private:
  struct Shared;
  struct Run {
    std::shared_ptr<Shared> shared;  ///< with its thread
    std::jthread thread;
  };
  std::shared_ptr<Shared> shared_;  ///< of the present run
  std::vector<Run> runs_;           ///< the present one, and those that are told to end
};

}  // namespace ui
