#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "sim/take/frame_codec.h"
#include "sim/take/take.h"
#include "sim/take/take_file.h"
#include "sim/take/take_index.h"

namespace sim {

/// A take on disk. Also how a writer that continues one finds where to go on.
class FileTakeReader final : public TakeReader {
 public:
  static Result<std::unique_ptr<FileTakeReader>> over(TakeFile file);

  const TakeHeader& header() const override { return header_; }
  const Network& network() const override { return network_; }
  std::size_t frameCount() const override { return index_.frames.size(); }
  Result<std::string> sceneOf(std::size_t frame) const override;
  double frameTime(std::size_t frame) const override;
  Result<SnapshotPointer> frame(std::size_t index) const override;
  Result<std::vector<BreakEvent>> eventsOf(std::size_t frame) const override;
  Result<std::vector<BreakEvent>> events() const override;
  std::vector<std::size_t> checkpointFrames() const override;
  Result<std::vector<std::byte>> checkpoint(std::size_t frame) const override;
  std::optional<std::string> outcome() const override { return outcome_; }
  std::uint64_t droppedBytes() const override { return index_.droppedBytes; }

  const TakeIndex& index() const { return index_; }
  /// The checked and decompressed content of a chunk; nothing when it is damaged.
  std::optional<std::vector<std::byte>> content(std::size_t chunk) const;
  /// Gives the file away; nothing can be read afterwards.
  TakeFile releaseFile() && { return std::move(file_); }

 private:
  FileTakeReader(TakeFile file, TakeIndex index) : file_(std::move(file)), index_(std::move(index)) {}
  Status readBeginning();
  Result<Snapshot> snapshotAt(const TakeIndex::Frame& place) const;
  /// What a breakage chunk says. Frames that lean on one chunk share it, in whatever order they are read.
  Result<BrokenPointer> brokenAt(std::size_t chunk) const;
  std::optional<std::string> textOf(std::size_t chunk) const;
  /// The newest of these that is intact.
  std::optional<std::string> newestScene(const TakeIndex::Scenes& scenes) const;
  Problem damaged(const std::string& what, const std::string& remedy) const;
  Problem noSuchFrame(std::size_t frame) const;
  /// What to do where this frame's checkpoint can't be had.
  std::string remedyWithout(std::size_t checkpointFrame) const;

  TakeFile file_;
  TakeIndex index_;
  TakeHeader header_;
  std::string firstScene_;  ///< the head's
  Network network_;
  NetworkSize size_;
  std::optional<std::string> outcome_;

  mutable std::mutex brokenMutex_;  ///< of both below
  /// By chunk: those that some snapshot still holds.
  mutable std::map<std::size_t, std::weak_ptr<const Broken>> held_;
  mutable BrokenPointer newest_;  ///< read last, so that frames read one by one find it held
};

}  // namespace sim
