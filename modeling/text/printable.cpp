#include "modeling/text/printable.h"

#include <array>
#include <cstdint>
#include <cstdio>

namespace modeling {
namespace {

struct Letter {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  ///< 0: this is no UTF-8
};

std::uint8_t byteAt(std::string_view text, std::size_t at) {
  return static_cast<std::uint8_t>(text[at]);
}

/// The letter that begins at the byte: the shortest form only, no surrogates, nothing beyond Unicode.
Letter letterAt(std::string_view text, std::size_t at) {
  const std::uint8_t first = byteAt(text, at);
  if (first < 0x80) return {first, 1};
  const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || at + bytes > text.size()) return {};
  std::uint32_t code = first & (0xffU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    const std::uint8_t next = byteAt(text, at + i);
    if ((next & 0xc0U) != 0x80U) return {};
    code = (code << 6U) | (next & 0x3fU);
  }
  static constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < kLeast[bytes] || code > 0x10ffff || surrogate) return {};
  return {code, bytes};
}

bool isControl(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0);
}

/// Line ends of other kinds, and what changes the direction of writing or is not seen at all.
bool isUnseen(std::uint32_t code) {
  return (code >= 0x200b && code <= 0x200f) || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2060 && code <= 0x206f) || code == 0xfeff || code == 0x061c ||
         (code >= 0xe0000 && code <= 0xe007f);
}

std::string escaped(const char* form, std::uint32_t code) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), form, static_cast<unsigned>(code));
  return text.data();
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letterAt(text, at);
    if (letter.bytes == 0) {
      shown += escaped("\\x%02x", byteAt(text, at));
    } else if (letter.code == '\n') {
      shown += "\\n";
    } else if (letter.code == '\t') {
      shown += "\\t";
    } else if (isControl(letter.code)) {
      shown += escaped("\\x%02x", letter.code);
    } else if (isUnseen(letter.code)) {
      shown += escaped(letter.code > 0xffff ? "\\U%08x" : "\\u%04x", letter.code);
    } else {
      shown += text.substr(at, letter.bytes);
    }
    at += letter.bytes == 0 ? 1 : letter.bytes;
  }
  return shown;
}

}  // namespace modeling
