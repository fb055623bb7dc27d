#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "ui/session/footage.h"

namespace ui {

/// The thread that fetches frames which are not in memory, and in idle moments what the timeline shows of
/// takes that were opened from files. Of frames asked for faster than they can be read the newest counts.
class FrameLoader {
 public:
  struct Loaded {
    std::shared_ptr<Footage> footage;
    std::size_t frame = 0;
    sim::SnapshotPointer moment;          ///< null where it could not be read
    std::optional<sim::Problem> problem;  ///< then
  };

  FrameLoader();
  ~FrameLoader();
  FrameLoader(const FrameLoader&) = delete;
  FrameLoader& operator=(const FrameLoader&) = delete;

  void request(std::shared_ptr<Footage> footage, std::size_t frame);
  /// The newest that came, once.
  std::optional<Loaded> take();
  /// Reads the notes of an opened take, one after the other, when nothing else is to be done.
  void gatherNotes(std::shared_ptr<Footage> footage);

 private:
  void main();

  std::mutex mutex_;  ///< of all below
  std::condition_variable changed_;
  std::optional<Loaded> wanted_;
  std::optional<Loaded> loaded_;
  std::shared_ptr<Footage> unnoted_;
  bool ending_ = false;
  std::jthread runner_;  ///< last: it uses the others
};

}  // namespace ui
