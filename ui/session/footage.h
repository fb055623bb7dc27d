#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "modeling/scene/scene.h"
#include "sim/take/take.h"

namespace ui {

/// What is known of a recorded frame without fetching it; what timeline and plots are drawn from.
struct FrameNote {
  double time = 0.0;              ///< s
  std::uint32_t breaks = 0;       ///< bonds broken since the frame before
  std::uint32_t brokenBonds = 0;  ///< in all
  std::uint32_t fragments = 0;    ///< of more than one node
  double realTimeFactor = 0.0;    ///< simulated seconds a second of the clock, while it was made; 0: unknown
  std::uint64_t bondsEvaluated = 0;  ///< since the frame before; 0: unknown
  std::uint64_t bondsSkipped = 0;    ///< since the frame before; 0: unknown
  sim::LedgerRow ledger;
};

/// One take as the window sees it: frames that a run adds and anyone looks at. Shared by threads: every
/// function may be called from any of them, and none waits for a step or, but for frame() and events(), for
/// the disk.
///
/// New frames stay in memory while there is room and stand in the take's file as well; the oldest are dropped
/// from memory first and read from the file when asked for again. A take that nobody looks at keeps no more
/// in memory than its notes (letGo()).
class Footage {
 public:
  /// Frames in memory, all takes together, take at most about this much.
  static constexpr std::size_t kMemoryBudget = std::size_t{1} << 28;

  /// The take of a run that begins. Its frames are being written to `file`, which may not exist yet.
  Footage(std::shared_ptr<const sim::Network> network, modeling::Scene scene, std::filesystem::path file);
  ~Footage();
  Footage(const Footage&) = delete;
  Footage& operator=(const Footage&) = delete;

  /// The take in a file. Its notes have times only, until readNextNote() has gathered them. A Problem where
  /// the file is no take.
  static sim::Result<std::shared_ptr<Footage>> open(const std::filesystem::path& file);

  /// Read from the file where it was let go of, which may take long; null where it cannot be.
  std::shared_ptr<const sim::Network> network();
  const std::filesystem::path& file() const { return file_; }
  /// The scene as it was run, with what was performed while it ran; never null.
  std::shared_ptr<const modeling::Scene> scene() const;
  void setScene(std::shared_ptr<const modeling::Scene> scene);

  std::size_t frameCount() const;
  double duration() const;  ///< s: time of the last frame; 0 where there is none
  FrameNote note(std::size_t frame) const;
  std::vector<FrameNote> notes(std::size_t from = 0) const;
  /// How many frames have complete notes.
  std::size_t notedCount() const;
  /// The newest frame at or before a time; 0 where all are later.
  std::size_t frameAt(double time) const;
  /// s: when the first bond broke; nothing where none did, or it is not known yet.
  std::optional<double> firstBreak() const;

  /// The frame, where it is in memory; else null.
  sim::SnapshotPointer held(std::size_t frame) const;
  /// The frame, read from the file where it is not held, which may take long. A Problem where it cannot be
  /// read.
  sim::Result<sim::SnapshotPointer> frame(std::size_t frame);
  /// The breaks in all frames so far, in order.
  sim::Result<std::vector<sim::BreakEvent>> events();

  void append(sim::SnapshotPointer frame, const FrameNote& note, std::vector<sim::BreakEvent> events);
  /// Lets go of network, frames and events, which the file has as well. To be called when the recording has
  /// ended. Does nothing where there is no file.
  void letGo();
  /// Reads what notes lack from the file, a frame a call; false when there is no more to do.
  bool readNextNote();

 private:
  struct Entry {
    FrameNote note;
    bool noted = false;
    sim::SnapshotPointer held;
  };
  sim::Result<std::shared_ptr<const sim::TakeReader>> reader(std::size_t frame);
  void makeRoom();

  const std::filesystem::path file_;
  mutable std::mutex mutex_;                      ///< of all below; held for moments only
  std::shared_ptr<const sim::Network> network_;   ///< null: let go of
  std::shared_ptr<const modeling::Scene> scene_;  ///< never null
  std::vector<Entry> entries_;
  std::vector<sim::BreakEvent> events_;  ///< of frames that were appended here
  std::optional<double> firstBreak_;     ///< s: of those
  std::size_t nextHeld_ = 0;             ///< the oldest frame that may be held
  std::size_t frameBytes_ = 0;           ///< of one frame in memory, about
  std::size_t notesRead_ = 0;
  std::size_t notedCount_ = 0;
  bool fromFile_ = false;
  std::mutex readerMutex_;  ///< of reader_; held while a file is opened
  std::shared_ptr<const sim::TakeReader> reader_;
};

}  // namespace ui
