#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/base/bytes.h"

namespace sim {

// A take is a row of chunks and nothing else; docs/formats.md has the layout byte by byte. What is here knows
// bytes only, neither files nor what the chunks mean.

enum class ChunkKind : std::uint32_t {
  head = 1,      ///< TakeHeader; the first chunk
  network = 2,   ///< the second chunk
  breakage = 3,  ///< what is broken and which fragments there are, when that has changed
  events = 4,    ///< breaks since the frame before
  frame = 5,
  checkpoint = 6,   ///< of the frame before it
  outcome = 7,      ///< how the run ended
  change = 8,       ///< a frame that says only what is other than in a whole frame before it
  scene = 9,        ///< the scene, added to while it ran: says the same as before of what was recorded
  otherScene = 10,  ///< the scene that what follows comes from
};

struct ChunkHeader {
  static constexpr std::uint64_t kNoBase = ~std::uint64_t{0};

  ChunkKind kind = ChunkKind::head;
  std::uint64_t sequence = 0;      ///< position in the take as written, strictly increasing along the file
  std::uint64_t frame = 0;         ///< number of the frame this chunk belongs to, as written
  std::uint64_t base = kNoBase;    ///< frames: sequence of the breakage chunk that completes them
  double time = 0.0;               ///< frames: their time, s, so that a scan need not open them
  bool compressed = true;          ///< zstd; else the payload is the content
  std::uint64_t payloadBytes = 0;  ///< in the file, behind the header
  std::uint64_t contentBytes = 0;  ///< decompressed
  std::uint64_t payloadChecksum = 0;
};

inline constexpr std::size_t kChunkHeaderBytes = 80;
/// What every chunk begins with. Not text, so that no editor mends it, and no scene or mesh begins like it.
inline constexpr std::size_t kChunkMagicBytes = 8;
std::span<const std::byte> chunkMagic();

/// Compresses the content and appends header and payload to `out`. Sizes and checksum of `header` are filled
/// in here.
void appendChunk(ByteWriter& out, ChunkHeader header, std::span<const std::byte> content);

/// Nothing when these are not the intact kChunkHeaderBytes of a header, or when its sizes are out of
/// proportion (see contentIsPlausible).
std::optional<ChunkHeader> parseChunkHeader(std::span<const std::byte> bytes);

/// Whether so much content may be allocated for because of so few bytes: 256 MiB for any chunk, and 16 times
/// the payload. Bounds what a crafted file can make a reader allocate; appendChunk leaves uncompressed what
/// compresses better than that, so no take of ours is ever refused.
bool contentIsPlausible(std::uint64_t payloadBytes, std::uint64_t contentBytes);

/// Whether the payload is the one the header was written for.
bool payloadIsIntact(const ChunkHeader& header, std::span<const std::byte> payload);

/// The content of a payload, or nothing when it is damaged.
std::optional<std::vector<std::byte>> openPayload(const ChunkHeader& header,
                                                  std::span<const std::byte> payload);

}  // namespace sim
