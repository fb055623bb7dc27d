#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "modeling/material/material.h"
#include "sim/base/result.h"
#include "sim/surface/surface_mesh.h"
#include "ui/session/background_worker.h"

namespace ui {

/// A small bar of a material that is thrown flat across a rod, in a thread of its own (BackgroundWorker):
/// what a material does, to look at while its numbers are changed.
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

  SampleRun();

  /// Drops what runs and begins anew.
  void start(const modeling::Material& material);
  void stop();
  bool isStarted() const { return started_ > 0; }
  View view() const;

 private:
  BackgroundWorker<modeling::Material, View> worker_;
  std::uint64_t started_ = 0;  ///< number of the request; 0: none, or it was stopped
};

}  // namespace ui
