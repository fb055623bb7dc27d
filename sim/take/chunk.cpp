#include "sim/take/chunk.h"

#include <algorithm>
#include <array>

#include <xxhash.h>
#include <zstd.h>

namespace sim {
namespace {

constexpr std::array<unsigned char, kChunkMagicBytes> kMagic = {0x89, 'S', 'M', 'T', 'A', 'K', 'E', '\n'};
constexpr std::uint32_t kCompressed = 1;
// Levels 1 to 3 take as long as each other on what planes of doubles look like; above 3 only time grows.
constexpr int kCompressionLevel = 3;
constexpr std::uint64_t kAlwaysPlausible = std::uint64_t{256} << 20;
constexpr std::uint64_t kPlausibleRatio = 16;
constexpr std::size_t kChecksummedHeaderBytes = kChunkHeaderBytes - sizeof(std::uint64_t);

std::uint64_t checksum(std::span<const std::byte> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

/// Empty when compressing did not work out.
std::vector<std::byte> compress(std::span<const std::byte> content) {
  std::vector<std::byte> payload(ZSTD_compressBound(content.size()));
  const std::size_t size =
      ZSTD_compress(payload.data(), payload.size(), content.data(), content.size(), kCompressionLevel);
  payload.resize(ZSTD_isError(size) != 0 ? 0 : size);
  return payload;
}

}  // namespace

std::span<const std::byte> chunkMagic() {
  return std::as_bytes(std::span(kMagic));
}

bool contentIsPlausible(std::uint64_t payloadBytes, std::uint64_t contentBytes) {
  if (contentBytes <= kAlwaysPlausible) return true;
  return (contentBytes - kAlwaysPlausible) / kPlausibleRatio <= payloadBytes;
}

void appendChunk(ByteWriter& out, ChunkHeader header, std::span<const std::byte> content) {
  const std::vector<std::byte> compressed = compress(content);
  header.compressed = !compressed.empty() && contentIsPlausible(compressed.size(), content.size());
  const std::span<const std::byte> payload = header.compressed ? std::span(compressed) : content;

  ByteWriter head;
  head.putBytes(chunkMagic());
  head.put(static_cast<std::uint32_t>(header.kind));
  head.put<std::uint32_t>(header.compressed ? kCompressed : 0);
  head.put(header.sequence);
  head.put(header.frame);
  head.put(header.base);
  head.put(header.time);
  head.put<std::uint64_t>(payload.size());
  head.put<std::uint64_t>(content.size());
  head.put(checksum(payload));
  head.put(checksum(head.bytes()));
  out.putBytes(head.bytes());
  out.putBytes(payload);
}

std::optional<ChunkHeader> parseChunkHeader(std::span<const std::byte> bytes) {
  if (bytes.size() < kChunkHeaderBytes || !std::ranges::equal(bytes.first(kChunkMagicBytes), chunkMagic()))
    return std::nullopt;
  ByteReader reader(bytes.subspan(kChunkMagicBytes, kChunkHeaderBytes - kChunkMagicBytes));
  ChunkHeader header;
  std::uint32_t kind = 0;
  std::uint32_t flags = 0;
  std::uint64_t headerChecksum = 0;
  reader.read(kind);
  reader.read(flags);
  reader.read(header.sequence);
  reader.read(header.frame);
  reader.read(header.base);
  reader.read(header.time);
  reader.read(header.payloadBytes);
  reader.read(header.contentBytes);
  reader.read(header.payloadChecksum);
  reader.read(headerChecksum);
  if (headerChecksum != checksum(bytes.first(kChecksummedHeaderBytes))) return std::nullopt;
  header.kind = static_cast<ChunkKind>(kind);
  header.compressed = (flags & kCompressed) != 0;
  if (!contentIsPlausible(header.payloadBytes, header.contentBytes)) return std::nullopt;
  return header;
}

bool payloadIsIntact(const ChunkHeader& header, std::span<const std::byte> payload) {
  return payload.size() == header.payloadBytes && checksum(payload) == header.payloadChecksum;
}

std::optional<std::vector<std::byte>> openPayload(const ChunkHeader& header,
                                                  std::span<const std::byte> payload) {
  if (!payloadIsIntact(header, payload) || !contentIsPlausible(payload.size(), header.contentBytes))
    return std::nullopt;
  if (!header.compressed) {
    if (header.contentBytes != payload.size()) return std::nullopt;
    return std::vector<std::byte>(payload.begin(), payload.end());
  }
  if (ZSTD_getFrameContentSize(payload.data(), payload.size()) != header.contentBytes) return std::nullopt;
  std::vector<std::byte> content(static_cast<std::size_t>(header.contentBytes));
  const std::size_t size = ZSTD_decompress(content.data(), content.size(), payload.data(), payload.size());
  if (ZSTD_isError(size) != 0 || size != content.size()) return std::nullopt;
  return content;
}

}  // namespace sim
