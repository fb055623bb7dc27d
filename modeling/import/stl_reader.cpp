#include "modeling/import/stl_reader.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "modeling/import/mesh_text.h"

namespace modeling {
namespace {

using sim::Problem;
using sim::Status;

/// A binary file: a head, the count of triangles, the triangles.
constexpr std::size_t kHead = 80;
constexpr std::size_t kStart = kHead + sizeof(std::uint32_t);
constexpr std::size_t kTriangle = 50;  ///< normal, three corners, two bytes
constexpr std::size_t kNormal = 12;

std::uint32_t countIn(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHead, sizeof count);
  return count;
}

bool looksLikeText(std::string_view bytes) {
  static constexpr std::size_t kLooked = 1024;
  const std::string_view head = bytes.substr(0, std::min(bytes.size(), kLooked));
  std::string_view rest = head;
  if (inLowerCase(nextWord(rest)) != "solid" || head.find('\0') != std::string_view::npos) return false;
  // The name may be in any language, but what stands behind it is not.
  const std::string lower = inLowerCase(bytes.substr(0, std::min<std::size_t>(bytes.size(), 1U << 16U)));
  return lower.find("facet") != std::string::npos || lower.find("endsolid") != std::string::npos;
}

Reading readBinary(std::string_view bytes) {
  RawMesh raw;
  takeStatement(bytes.substr(0, kHead), raw);
  std::uint64_t count = countIn(bytes);
  const std::uint64_t room = (bytes.size() - kStart) / kTriangle;
  const bool isWhole = (bytes.size() - kStart) % kTriangle == 0;
  // Programs that write as they go leave the count at nothing, or at the most there can be.
  if (room > 0 && isWhole && (count == 0 || count == 0xffffffffU)) {
    raw.addNote("it does not say how many triangles it has; all were read");
    count = room;
  }
  if (count > room)
    return Problem{"",
                   "this file is cut short: it says that it has " + std::to_string(count) +
                       " triangles, and ends after " + std::to_string(room),
                   "copy or export it anew"};
  if (count > kMostTriangles)
    return Problem{"", "it has more than " + std::to_string(kMostTriangles) + " triangles",
                   "use a mesh of fewer faces"};
  if (const std::uint64_t left = bytes.size() - kStart - count * kTriangle; left > 0)
    raw.addNote(std::to_string(left) + " bytes behind its last triangle were passed over");
  for (std::uint64_t t = 0; t < count; ++t) {
    const char* at = bytes.data() + kStart + t * kTriangle + kNormal;
    std::array<float, 9> numbers{};
    std::memcpy(numbers.data(), at, sizeof numbers);
    const auto first = static_cast<std::uint32_t>(raw.points.size());
    for (std::size_t c = 0; c < 3; ++c)
      raw.points.emplace_back(numbers[3 * c], numbers[3 * c + 1], numbers[3 * c + 2]);
    raw.triangles.push_back({first, first + 1, first + 2});
  }
  return raw;
}

const Problem kCut{"", "this file is cut short: it ends within a triangle", "copy or export it anew"};

class StlText {
 public:
  Reading run(std::string_view text) {
    MeshLines lines(text);
    while (lines.next()) {
      std::string_view rest = lines.line();
      for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest)) {
        const Status status = take(inLowerCase(word), rest, lines.place());
        // What is wrong with the last line is that it is not all there.
        if (!status) return lines.rest().empty() ? kCut : status.problem();
      }
    }
    if (isOpen_) return kCut;
    return std::move(raw_);
  }

 private:
  Status take(const std::string& word, std::string_view& rest, const std::string& place) {
    if (word == "solid" || word == "endsolid") {
      takeName(rest);
    } else if (word == "facet") {
      isOpen_ = true;
      ring_.clear();
    } else if (word == "vertex" && isOpen_) {
      const auto point = pointOf(rest, place);
      if (!point) return point.problem();
      ring_.push_back(static_cast<std::int64_t>(raw_.points.size()));
      raw_.points.push_back(*point);
    } else if (word == "endfacet" && isOpen_) {
      isOpen_ = false;
      return addPolygon(ring_, place, raw_);
    }
    return sim::Done{};
  }

  /// A name goes to the end of its line, unless the first triangle stands in that, too.
  void takeName(std::string_view& rest) {
    const std::string lower = inLowerCase(rest);
    const std::size_t facet = lower.find("facet normal");
    takeStatement(rest.substr(0, facet), raw_);
    rest.remove_prefix(std::min(facet, rest.size()));
  }

  RawMesh raw_;
  std::vector<std::int64_t> ring_;
  bool isOpen_ = false;
};

}  // namespace

Reading readStl(std::string_view bytes) {
  const bool couldBeBinary = bytes.size() >= kStart;
  const bool isBinary = couldBeBinary && bytes.size() == kStart + kTriangle * std::uint64_t{countIn(bytes)};
  if (!isBinary && looksLikeText(bytes)) return StlText().run(bytes);
  if (!couldBeBinary) return Problem{"", "this is no STL: it is too short for one", "export it anew"};
  const bool isText = std::all_of(bytes.begin(), bytes.begin() + kStart,
                                  [](unsigned char letter) { return letter >= 9 && letter < 127; });
  if (isText && countIn(bytes) > (bytes.size() - kStart) / kTriangle)
    return Problem{"", "this is no STL: it is text that does not begin with \"solid\"", "export it anew"};
  return readBinary(bytes);
}

}  // namespace modeling
