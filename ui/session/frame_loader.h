#pragma once

#include <memory>
#include <optional>

#include "ui/session/background_worker.h"
#include "ui/session/footage.h"

namespace ui {

/// Fetches frames which are not in memory, and what the timeline shows of takes that were opened from files,
/// in threads of its own (BackgroundWorker).
class FrameLoader {
 public:
  struct Loaded {
    std::shared_ptr<Footage> footage;
    std::size_t frame = 0;
    sim::SnapshotPointer moment;          ///< null where it could not be read
    std::optional<sim::Problem> problem;  ///< then
  };

  FrameLoader();

  void request(std::shared_ptr<Footage> footage, std::size_t frame);
  /// The newest that came, once.
  std::optional<Loaded> take();
  /// Reads the notes of an opened take, one after the other; leaves off those of the take before.
  void gatherNotes(std::shared_ptr<Footage> footage);
  void requestStop();

 private:
  struct Request {
    std::shared_ptr<Footage> footage;
    std::size_t frame = 0;
  };
  struct Nothing {};

  BackgroundWorker<Request, Loaded> frames_;
  BackgroundWorker<std::shared_ptr<Footage>, Nothing> notes_;
  std::uint64_t taken_ = 0;  ///< number of the request whose answer was taken last
};

}  // namespace ui
