#include "sim/take/take_index.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

constexpr std::size_t kSearchBytes = std::size_t{1} << 16;
constexpr std::size_t kHeaderAheadBytes = std::size_t{1} << 12;

/// A piece of the file in memory that moves along with the scan.
class Window {
 public:
  explicit Window(const TakeFile& file) : file_(file) {}

  /// `length` bytes from `offset` on; fewer where the file ends or can't be read. Reads `ahead` bytes when it
  /// has to read.
  std::span<const std::byte> view(std::uint64_t offset, std::size_t length, std::size_t ahead) {
    const std::uint64_t left = file_.size() - std::min(offset, file_.size());
    length = static_cast<std::size_t>(std::min<std::uint64_t>(length, left));
    if (offset < start_ || offset + length > start_ + bytes_.size()) {
      bytes_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(std::max(length, ahead), left)));
      start_ = offset;
      if (!file_.read(offset, bytes_)) bytes_.clear();
    }
    if (bytes_.empty()) return {};
    return std::span<const std::byte>(bytes_).subspan(static_cast<std::size_t>(offset - start_), length);
  }

  /// Offset of the next magic at or after `from`; the file's size when there is none.
  std::uint64_t findMagic(std::uint64_t from) {
    const std::span<const std::byte> magic = chunkMagic();
    while (from + kChunkHeaderBytes <= file_.size()) {
      const std::span<const std::byte> bytes = view(from, kSearchBytes, kSearchBytes);
      const auto found = std::search(bytes.begin(), bytes.end(), magic.begin(), magic.end());
      if (found != bytes.end()) return from + static_cast<std::uint64_t>(found - bytes.begin());
      if (bytes.size() < magic.size()) break;
      from += bytes.size() - magic.size() + 1;
    }
    return file_.size();
  }

 private:
  const TakeFile& file_;
  std::uint64_t start_ = 0;
  std::vector<std::byte> bytes_;
};

/// All chunks that are where they say they are, in order.
std::vector<TakeIndex::Chunk> findChunks(const TakeFile& file) {
  std::vector<TakeIndex::Chunk> chunks;
  Window window(file);
  std::uint64_t offset = 0;
  while (offset + kChunkHeaderBytes <= file.size()) {
    const auto header = parseChunkHeader(window.view(offset, kChunkHeaderBytes, kHeaderAheadBytes));
    const bool fits = header && header->payloadBytes <= file.size() - offset - kChunkHeaderBytes &&
                      std::isfinite(header->time);
    const bool follows = fits && (chunks.empty() || header->sequence > chunks.back().header.sequence);
    if (follows) {
      chunks.push_back({offset, *header});
      offset = chunks.back().end();
    } else {
      offset = window.findMagic(offset + 1);
    }
  }
  return chunks;
}

/// After a power cut the file may have its new length without its new bytes: the last chunk counts only if
/// its payload is there.
void dropDamagedTail(const TakeFile& file, std::vector<TakeIndex::Chunk>& chunks) {
  std::vector<std::byte> payload;
  while (!chunks.empty()) {
    const TakeIndex::Chunk& last = chunks.back();
    payload.resize(static_cast<std::size_t>(last.header.payloadBytes));
    if (file.read(last.payloadOffset(), payload) && payloadIsIntact(last.header, payload)) return;
    chunks.pop_back();
  }
}

/// Puts chunks together to frames. Events and breakage precede their frame in the file, so that the frame's
/// chunk seals them: without it they are the remains of an append that was cut short.
class Assembly {
 public:
  explicit Assembly(TakeIndex& index) : index_(index), sealedEnd_(index.chunks[1].end()) {}

  void add(std::size_t chunk) {
    const ChunkHeader& header = index_.chunks[chunk].header;
    switch (header.kind) {
      case ChunkKind::events:
        index_.eventChunks.push_back(chunk);
        return;
      case ChunkKind::frame:
      case ChunkKind::change:
        return addFrame(chunk);
      case ChunkKind::checkpoint:
        if (!index_.frames.empty() && lastFrame().frame == header.frame) {
          index_.frames.back().checkpoint = chunk;
          sealedEnd_ = index_.chunks[chunk].end();
        }
        return;
      case ChunkKind::outcome:
        index_.outcome = chunk;
        sealedEnd_ = index_.chunks[chunk].end();
        return;
      default:
        return;
    }
  }

  /// Where the last thing ends that was appended whole.
  std::uint64_t sealedEnd() const { return sealedEnd_; }

 private:
  const ChunkHeader& lastFrame() const { return index_.chunks[index_.frames.back().chunk].header; }

  void addFrame(std::size_t chunk) {
    const ChunkHeader& header = index_.chunks[chunk].header;
    if (!index_.frames.empty() && (header.frame <= lastFrame().frame || header.time < lastFrame().time))
      return;
    TakeIndex::Frame frame;
    frame.chunk = chunk;
    frame.breakage = chunkOfSequence(index_, header.base, ChunkKind::breakage);
    frame.firstEvents = index_.frames.empty() ? 0 : index_.frames.back().lastEvents;
    frame.lastEvents = index_.eventChunks.size();
    index_.frames.push_back(frame);
    sealedEnd_ = index_.chunks[chunk].end();
  }

  TakeIndex& index_;
  std::uint64_t sealedEnd_;
};

}  // namespace

std::size_t chunkOfSequence(const TakeIndex& index, std::uint64_t sequence, ChunkKind kind) {
  const auto sequenceOf = [](const TakeIndex::Chunk& chunk) { return chunk.header.sequence; };
  const auto found = std::ranges::lower_bound(index.chunks, sequence, {}, sequenceOf);
  if (found == index.chunks.end() || sequenceOf(*found) != sequence || found->header.kind != kind)
    return TakeIndex::kNoChunk;
  return static_cast<std::size_t>(found - index.chunks.begin());
}

Result<TakeIndex> scanTake(const TakeFile& file) {
  TakeIndex index;
  index.chunks = findChunks(file);
  dropDamagedTail(file, index.chunks);
  const std::vector<TakeIndex::Chunk>& chunks = index.chunks;
  if (chunks.empty())
    return Problem{file.path().string(), "this is not a take, or nothing of it is left", ""};
  if (chunks.size() < 2 || chunks[0].offset != 0 || chunks[0].header.kind != ChunkKind::head ||
      chunks[1].header.kind != ChunkKind::network)
    return Problem{file.path().string(), "the beginning of the take is damaged",
                   "record it again from its scene"};

  Assembly assembly(index);
  for (std::size_t chunk = 2; chunk < chunks.size(); ++chunk) assembly.add(chunk);
  index.droppedBytes = file.size();
  for (const TakeIndex::Chunk& chunk : chunks) {
    if (chunk.end() <= assembly.sealedEnd()) index.droppedBytes -= chunk.end() - chunk.offset;
  }
  return index;
}

}  // namespace sim
