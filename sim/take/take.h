#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/dynamics/snapshot.h"
#include "sim/network/network.h"

namespace sim {

/// What stands at the head of a take. `scene` is opaque here: the text of the scene the run came from.
struct TakeHeader {
  std::string scene;
  std::string sceneHash;  ///< hexadecimal, of `scene`
  double framesPerSecond = 24.0;
  std::uint64_t seed = 1;
};

/// Appends to a take on disk. Every append is whole or, after a kill, absent: a reader drops a torn tail.
/// File layout: docs/formats.md. Not thread-safe.
class TakeWriter {
 public:
  /// Creates (or replaces) the file, writes header and network.
  static Result<std::unique_ptr<TakeWriter>> create(const std::filesystem::path& path,
                                                    const TakeHeader& header, const Network& network);
  /// Opens an existing take to continue it after frame `lastFrame`: what stands behind that frame's
  /// checkpoint is cut off.
  static Result<std::unique_ptr<TakeWriter>> continueAfter(const std::filesystem::path& path,
                                                           std::size_t lastFrame);
  virtual ~TakeWriter() = default;

  virtual Status appendFrame(const Snapshot& frame, const std::vector<BreakEvent>& eventsSinceLastFrame) = 0;
  /// A checkpoint belongs to the frame appended last.
  virtual Status appendCheckpoint(const std::vector<std::byte>& checkpoint) = 0;
  /// Notes that the run ended, and how ("done", or the line of the Problem that stopped it).
  virtual Status finish(const std::string& outcome) = 0;
};

/// Random access to a take. Reading a frame reads and checks that frame's chunks only.
class TakeReader {
 public:
  static Result<std::unique_ptr<TakeReader>> open(const std::filesystem::path& path);
  virtual ~TakeReader() = default;

  virtual const TakeHeader& header() const = 0;
  virtual const Network& network() const = 0;
  virtual std::size_t frameCount() const = 0;
  virtual double frameTime(std::size_t frame) const = 0;
  virtual Result<SnapshotPointer> frame(std::size_t index) const = 0;
  virtual Result<std::vector<BreakEvent>> events() const = 0;
  virtual std::vector<std::size_t> checkpointFrames() const = 0;
  virtual Result<std::vector<std::byte>> checkpoint(std::size_t frame) const = 0;
  virtual std::optional<std::string> outcome() const = 0;
  /// Bytes of a torn or damaged tail that were left out; 0 for a whole file.
  virtual std::uint64_t droppedBytes() const = 0;
};

}  // namespace sim
