#include "ui/picture/radiance_file.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace ui {
namespace {

/// The longest line of a head that is looked at; they are seldom longer than a command line.
constexpr std::size_t kLongestLine = 4096;
/// Rows of other widths are never run by run for each share by itself.
constexpr std::size_t kLeastRunWidth = 8;
constexpr std::size_t kMostRunWidth = 32767;

using Pixel = std::array<std::uint8_t, 4>;

/// The bytes that were not read yet.
class Source {
 public:
  explicit Source(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::size_t left() const { return bytes_.size(); }
  std::uint8_t peek(std::size_t at) const { return std::to_integer<std::uint8_t>(bytes_[at]); }
  std::uint8_t take() {
    const std::uint8_t first = peek(0);
    bytes_ = bytes_.subspan(1);
    return first;
  }
  Pixel takePixel() { return {take(), take(), take(), take()}; }
  void skip(std::size_t count) { bytes_ = bytes_.subspan(count); }
  /// Without its end; nothing where there is no end.
  std::optional<std::string_view> takeLine() {
    const std::string_view text(reinterpret_cast<const char*>(bytes_.data()), std::min(left(), kLongestLine));
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    skip(end + 1);
    return text.substr(0, end > 0 && text[end - 1] == '\r' ? end - 1 : end);
  }

 private:
  std::span<const std::byte> bytes_;
};

bool takeNumber(std::string_view& text, std::string_view before, int& number) {
  if (!text.starts_with(before)) return false;
  text.remove_prefix(before.size());
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc{} && number > 0;
}

std::optional<RadianceSize> takeHead(Source& source) {
  const auto first = source.takeLine();
  if (!first || !first->starts_with("#?")) return std::nullopt;
  for (;;) {
    const auto line = source.takeLine();
    if (!line) return std::nullopt;
    if (line->empty()) break;
    if (line->starts_with("FORMAT=") && *line != "FORMAT=32-bit_rle_rgbe") return std::nullopt;
  }
  const auto line = source.takeLine();
  if (!line) return std::nullopt;
  std::string_view rest = *line;
  RadianceSize size;
  const bool proper =
      takeNumber(rest, "-Y ", size.height) && takeNumber(rest, " +X ", size.width) && rest.empty();
  return proper ? std::optional(size) : std::nullopt;
}

/// Each share of the row by itself, in runs of one value and of different ones.
bool takeRuns(Source& source, std::vector<Pixel>& row) {
  for (std::size_t share = 0; share < 4; ++share) {
    for (std::size_t x = 0; x < row.size();) {
      if (source.left() < 2) return false;
      const std::uint8_t code = source.take();
      const bool same = code > 128;
      const std::size_t count = same ? code - 128U : code;
      if (count == 0 || count > row.size() - x || (!same && source.left() < count)) return false;
      const std::uint8_t value = same ? source.take() : std::uint8_t{0};
      for (std::size_t i = 0; i < count; ++i) row[x++][share] = same ? value : source.take();
    }
  }
  return true;
}

/// Pixel by pixel; 1, 1, 1, n repeats the one before n times, and another such after it 256 n times more.
bool takePixels(Source& source, std::vector<Pixel>& row) {
  unsigned shift = 0;
  for (std::size_t x = 0; x < row.size();) {
    if (source.left() < 4) return false;
    const Pixel pixel = source.takePixel();
    if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
      row[x++] = pixel;
      shift = 0;
      continue;
    }
    const std::size_t count = shift < 24 ? std::size_t{pixel[3]} << shift : row.size() + 1;
    if (x == 0 || count > row.size() - x) return false;
    for (std::size_t i = 0; i < count; ++i, ++x) row[x] = row[x - 1];
    shift += 8;
  }
  return true;
}

bool takeRow(Source& source, std::vector<Pixel>& row) {
  const std::size_t width = row.size();
  const bool runs = width >= kLeastRunWidth && width <= kMostRunWidth && source.left() >= 4 &&
                    source.peek(0) == 2 && source.peek(1) == 2 && source.peek(2) < 128;
  if (!runs) return takePixels(source, row);
  if (256U * source.peek(2) + source.peek(3) != width) return false;
  source.skip(4);
  return takeRuns(source, row);
}

Light lightOf(const Pixel& pixel) {
  if (pixel[3] == 0) return Light::Zero();
  const float unit = std::ldexp(1.0F, static_cast<int>(pixel[3]) - (128 + 8));
  return Light(static_cast<float>(pixel[0]), static_cast<float>(pixel[1]), static_cast<float>(pixel[2])) *
         unit;
}

}  // namespace

std::optional<RadianceSize> radianceSize(std::span<const std::byte> file) {
  Source source(file);
  return takeHead(source);
}

std::optional<EnvironmentImage> readRadiance(std::span<const std::byte> file) {
  Source source(file);
  const auto size = takeHead(source);
  if (!size) return std::nullopt;
  EnvironmentImage image{size->width, size->height, {}};
  image.pixels.reserve(static_cast<std::size_t>(size->width) * static_cast<std::size_t>(size->height));
  std::vector<Pixel> row(static_cast<std::size_t>(size->width));
  for (int y = 0; y < size->height; ++y) {
    if (!takeRow(source, row)) return std::nullopt;
    for (const Pixel& pixel : row) image.pixels.push_back(lightOf(pixel));
  }
  return image;
}

}  // namespace ui
