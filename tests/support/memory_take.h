#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/take/take.h"

namespace tests {

/// A take that was never on a disk, for tests of what reads takes.
class MemoryTake : public sim::TakeReader {
 public:
  MemoryTake(sim::Network network, std::vector<sim::Snapshot> frames, std::string scene = "")
      : network_(std::move(network)) {
    header_.scene = std::move(scene);
    for (sim::Snapshot& frame : frames) {
      frames_.push_back(std::make_shared<const sim::Snapshot>(std::move(frame)));
    }
  }

  const sim::TakeHeader& header() const override { return header_; }
  const sim::Network& network() const override { return network_; }
  std::size_t frameCount() const override { return frames_.size(); }
  sim::Result<std::string> sceneOf(std::size_t /*frame*/) const override { return header_.scene; }
  double frameTime(std::size_t frame) const override { return frames_[frame]->time; }
  sim::Result<sim::SnapshotPointer> frame(std::size_t index) const override { return frames_[index]; }
  sim::Result<std::vector<sim::BreakEvent>> eventsOf(std::size_t /*frame*/) const override {
    return Events{};
  }
  sim::Result<std::vector<sim::BreakEvent>> events() const override { return Events{}; }
  std::vector<std::size_t> checkpointFrames() const override { return {}; }
  sim::Result<std::vector<std::byte>> checkpoint(std::size_t /*frame*/) const override {
    return sim::Problem{"", "there is no checkpoint", ""};
  }
  std::optional<std::string> outcome() const override { return "done"; }
  std::uint64_t droppedBytes() const override { return 0; }

 private:
  using Events = std::vector<sim::BreakEvent>;
  sim::TakeHeader header_;
  sim::Network network_;
  std::vector<sim::SnapshotPointer> frames_;
};

}  // namespace tests
