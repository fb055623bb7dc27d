#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/network/network.h"
#include "sim/state/snapshot.h"

namespace sim {

/// What stands at the head of a take. `scene` is opaque here: the text of the scene the run came from, the
/// newest there is.
struct TakeHeader {
  std::string scene;
  std::string sceneHash;          ///< hexadecimal, of `scene`
  double framesPerSecond = 24.0;  ///< finite, > 0
  std::uint64_t seed = 1;

  bool operator==(const TakeHeader&) const = default;
};

/// Appends to a take on disk. Every append is whole or, after a kill or on a full disk, absent: what an
/// append has returned from is there for every reader, whatever becomes of this process (after a power cut,
/// what finish() has returned from). A failed append leaves the writer as it was: it may be tried again. One
/// take has one writer at a time; readers may look on. File layout: docs/formats.md. Not thread-safe.
class TakeWriter {
 public:
  /// Creates (or replaces) the file, writes header and network. A Problem where the file can't be written,
  /// another writer has it, or the network doesn't validate().
  static Result<std::unique_ptr<TakeWriter>> create(const std::filesystem::path& path,
                                                    const TakeHeader& header, const Network& network);
  /// Opens an existing take to continue it after frame `lastFrame` (as TakeReader counts them): what stands
  /// behind that frame's checkpoint is cut off, but for the newest scene that the frame comes from. A
  /// Problem, and nothing cut, when that frame or its checkpoint is not there or damaged.
  static Result<std::unique_ptr<TakeWriter>> continueAfter(const std::filesystem::path& path,
                                                           std::size_t lastFrame);
  virtual ~TakeWriter() = default;

  /// The snapshot must be of the take's network, not before the last frame in time, and each node's fragment
  /// among its fragments; flags of broken bonds and cells other than 0 are read back as 1.
  virtual Status appendFrame(const Snapshot& frame, const std::vector<BreakEvent>& eventsSinceLastFrame) = 0;
  /// Nodes left out of the frames appended so far.
  virtual std::uint64_t nodesLeftOut() const = 0;
  /// A checkpoint belongs to the frame appended last; the last one given counts.
  virtual Status appendCheckpoint(const std::vector<std::byte>& checkpoint) = 0;
  /// The scene was added to while it ran, and says the same as before of all that was recorded. To be
  /// appended before the first frame that it makes different.
  virtual Status appendScene(const std::string& scene) = 0;
  /// What follows comes from this scene, which frames so far know nothing of.
  virtual Status beginScene(const std::string& scene) = 0;
  /// Notes that the run ended, and how ("done", or the line of the Problem that stopped it), and returns when
  /// the disk has everything. Nothing can be appended afterwards.
  virtual Status finish(const std::string& outcome) = 0;
};

/// Random access to a take, as it was when opened. Reading a frame reads and checks that frame's chunks only
/// (at most three). Where the file is damaged, frames are numbered as if what can't be found had never been
/// there; chunks that are found but damaged inside are Problems when they are read. Thread-safe.
class TakeReader {
 public:
  /// A Problem when head or network can't be read; frames may be few or none.
  static Result<std::unique_ptr<TakeReader>> open(const std::filesystem::path& path);
  virtual ~TakeReader() = default;

  virtual const TakeHeader& header() const = 0;
  virtual const Network& network() const = 0;
  virtual std::size_t frameCount() const = 0;
  /// The text of the scene a frame came from, the newest there is: header().scene, unless another one began
  /// behind the frame.
  virtual Result<std::string> sceneOf(std::size_t frame) const = 0;
  /// s; never less than the frame's before.
  virtual double frameTime(std::size_t frame) const = 0;
  virtual Result<SnapshotPointer> frame(std::size_t index) const = 0;
  /// Breaks up to this frame since the one before.
  virtual Result<std::vector<BreakEvent>> eventsOf(std::size_t frame) const = 0;
  /// Of all frames. One damaged record of them is a Problem: eventsOf() has the others.
  virtual Result<std::vector<BreakEvent>> events() const = 0;
  /// In increasing order.
  virtual std::vector<std::size_t> checkpointFrames() const = 0;
  virtual Result<std::vector<std::byte>> checkpoint(std::size_t frame) const = 0;
  /// How the run ended; nothing when it was killed or goes on still.
  virtual std::optional<std::string> outcome() const = 0;
  /// Bytes that were left out: a torn tail, or damage in the middle; 0 for a whole file.
  virtual std::uint64_t droppedBytes() const = 0;
};

}  // namespace sim
