#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/result.h"
#include "sim/take/chunk.h"
#include "sim/take/take_file.h"

namespace sim {

/// Where everything stands in a take, found by reading chunk headers only.
///
/// Invariants: chunks increase in offset and sequence, don't overlap and lie within the file; chunks[0] is
/// the head and chunks[1] the network; frames increase in number and never decrease in time.
struct TakeIndex {
  static constexpr std::size_t kNoChunk = ~std::size_t{0};

  struct Chunk {
    std::uint64_t offset = 0;  ///< of its header
    ChunkHeader header;

    std::uint64_t payloadOffset() const { return offset + kChunkHeaderBytes; }
    std::uint64_t end() const { return payloadOffset() + header.payloadBytes; }
  };
  struct Frame {
    std::size_t chunk = kNoChunk;
    std::size_t breakage = kNoChunk;  ///< kNoChunk: it was lost
    std::size_t checkpoint = kNoChunk;
    /// Entries of eventChunks: [firstEvents, lastEvents).
    std::size_t firstEvents = 0;
    std::size_t lastEvents = 0;
  };

  std::vector<Chunk> chunks;
  std::vector<Frame> frames;
  std::vector<std::size_t> eventChunks;
  std::size_t outcome = kNoChunk;
  std::uint64_t droppedBytes = 0;
};

/// The chunk of that sequence, if it is there and of that kind; else kNoChunk.
std::size_t chunkOfSequence(const TakeIndex& index, std::uint64_t sequence, ChunkKind kind);

/// Scans the file. Where no chunk begins that could, it goes on at the next place where one does. A Problem
/// when the file doesn't begin with head and network.
Result<TakeIndex> scanTake(const TakeFile& file);

}  // namespace sim
