#include "tests/fuzz/take_damage.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

#include <xxhash.h>

#include "sim/take/chunk.h"

namespace tests {
namespace {

std::uint64_t hugeCount(Chance& chance) {
  constexpr std::uint64_t kCounts[] = {0x7fffffff,
                                       0xffffffff,
                                       std::uint64_t{1} << 33U,
                                       ~std::uint64_t{0},
                                       std::uint64_t{1} << 61U,
                                       (std::uint64_t{1} << 63U) + 1,
                                       300'000'000,
                                       20'000'000};
  return kCounts[chance.below(std::size(kCounts))];
}

struct Place {
  std::size_t offset = 0;
  sim::ChunkHeader header;
};

/// Up to the first that is none.
std::vector<Place> chunksOf(const std::string& bytes) {
  std::vector<Place> places;
  const std::span<const std::byte> all = std::as_bytes(std::span(bytes));
  for (std::size_t offset = 0; offset < bytes.size();) {
    const auto header = sim::parseChunkHeader(all.subspan(offset));
    if (!header || header->payloadBytes > bytes.size() - offset - sim::kChunkHeaderBytes) break;
    places.push_back({offset, *header});
    offset += sim::kChunkHeaderBytes + header->payloadBytes;
  }
  return places;
}

void spoilHeader(std::string& bytes, const Place& place, Chance& chance) {
  const std::uint64_t count = hugeCount(chance);
  char* const header = bytes.data() + place.offset;
  std::memcpy(header + 8 + 8 * chance.below(7), &count, sizeof count);
  const std::uint64_t seal = XXH3_64bits(header, sim::kChunkHeaderBytes - 8);
  std::memcpy(header + sim::kChunkHeaderBytes - 8, &seal, sizeof seal);
}

void spoilContent(std::string& bytes, const Place& place, Chance& chance) {
  const std::span<const std::byte> all = std::as_bytes(std::span(bytes));
  const std::size_t payload = place.offset + sim::kChunkHeaderBytes;
  auto content = sim::openPayload(place.header, all.subspan(payload, place.header.payloadBytes));
  if (!content) return;
  if (content->size() > 8) {
    // Counts stand anywhere, most of them near the beginning.
    const std::size_t reach =
        chance.below(2) == 0 ? std::min<std::size_t>(content->size(), 48) : content->size();
    const std::size_t at = std::min(chance.below(reach), content->size() - 8);
    const std::uint64_t value = chance.below(2) == 0 ? hugeCount(chance) : chance.any();
    std::memcpy(content->data() + at, &value, chance.below(2) == 0 ? 8 : 1);
    if (chance.below(4) == 0) content->resize(chance.below(content->size()));
  }
  sim::ByteWriter resealed;
  sim::appendChunk(resealed, place.header, *content);
  const std::string chunk(reinterpret_cast<const char*>(resealed.bytes().data()), resealed.size());
  bytes.replace(place.offset, sim::kChunkHeaderBytes + place.header.payloadBytes, chunk);
}

}  // namespace

void damageTake(std::string& bytes, Chance& chance) {
  const std::vector<Place> places = chunksOf(bytes);
  if (places.empty()) return;
  const Place& place = places[chance.below(places.size())];
  if (chance.below(3) == 0) {
    spoilHeader(bytes, place, chance);
  } else {
    spoilContent(bytes, place, chance);
  }
}

}  // namespace tests
