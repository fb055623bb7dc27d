#include "sim/take/planes.h"

#include <cassert>
#include <cstring>

namespace sim {
namespace {

template <class Word>
Word zigzag(Word difference) {
  constexpr int kTop = 8 * static_cast<int>(sizeof(Word)) - 1;
  const Word sign = static_cast<Word>(Word{0} - static_cast<Word>(difference >> kTop));
  return static_cast<Word>(static_cast<Word>(difference << 1) ^ sign);
}

template <class Word>
Word unzigzag(Word code) {
  const Word sign = static_cast<Word>(Word{0} - static_cast<Word>(code & 1));
  return static_cast<Word>(static_cast<Word>(code >> 1) ^ sign);
}

template <class Word>
void scatter(const std::byte* elements, std::size_t count, std::size_t lanes, std::byte* planes) {
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::byte* from = elements + lane * sizeof(Word);
    std::byte* to = planes + lane * sizeof(Word) * count;
    Word previous = 0;
    for (std::size_t i = 0; i < count; ++i) {
      Word word;
      std::memcpy(&word, from + i * lanes * sizeof(Word), sizeof(Word));
      const Word code = zigzag(static_cast<Word>(word - previous));
      previous = word;
      for (std::size_t b = 0; b < sizeof(Word); ++b)
        to[b * count + i] = static_cast<std::byte>(code >> (8 * b));
    }
  }
}

template <class Word>
void gather(const std::byte* planes, std::size_t count, std::size_t lanes, std::byte* elements) {
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::byte* from = planes + lane * sizeof(Word) * count;
    std::byte* to = elements + lane * sizeof(Word);
    Word word = 0;
    for (std::size_t i = 0; i < count; ++i) {
      Word code = 0;
      for (std::size_t b = 0; b < sizeof(Word); ++b) {
        code = static_cast<Word>(code | static_cast<Word>(static_cast<Word>(from[b * count + i]) << (8 * b)));
      }
      word = static_cast<Word>(word + unzigzag(code));
      std::memcpy(to + i * lanes * sizeof(Word), &word, sizeof(Word));
    }
  }
}

}  // namespace

void toPlanes(const std::byte* elements, std::size_t count, std::size_t lanes, std::size_t wordBytes,
              std::byte* planes) {
  switch (wordBytes) {
    case 1:
      return scatter<std::uint8_t>(elements, count, lanes, planes);
    case 2:
      return scatter<std::uint16_t>(elements, count, lanes, planes);
    case 4:
      return scatter<std::uint32_t>(elements, count, lanes, planes);
    default:
      assert(wordBytes == 8);
      return scatter<std::uint64_t>(elements, count, lanes, planes);
  }
}

void fromPlanes(const std::byte* planes, std::size_t count, std::size_t lanes, std::size_t wordBytes,
                std::byte* elements) {
  switch (wordBytes) {
    case 1:
      return gather<std::uint8_t>(planes, count, lanes, elements);
    case 2:
      return gather<std::uint16_t>(planes, count, lanes, elements);
    case 4:
      return gather<std::uint32_t>(planes, count, lanes, elements);
    default:
      assert(wordBytes == 8);
      return gather<std::uint64_t>(planes, count, lanes, elements);
  }
}

void putFlags(ByteWriter& writer, const std::vector<std::uint8_t>& flags) {
  writer.put<std::uint64_t>(flags.size());
  const std::span<std::byte> bits = writer.extend((flags.size() + 7) / 8);
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i] != 0) bits[i / 8] |= static_cast<std::byte>(1U << (i % 8));
  }
}

bool readFlags(ByteReader& reader, std::vector<std::uint8_t>& flags, std::size_t expectedCount) {
  flags.clear();
  std::uint64_t count = 0;
  if (!reader.read(count) || count != expectedCount) return reader.fail();
  const std::span<const std::byte> bits = reader.readBytes((expectedCount + 7) / 8);
  if (!reader.ok()) return false;
  flags.resize(expectedCount);
  for (std::size_t i = 0; i < expectedCount; ++i) {
    flags[i] = static_cast<std::uint8_t>((static_cast<unsigned>(bits[i / 8]) >> (i % 8)) & 1U);
  }
  return true;
}

}  // namespace sim
