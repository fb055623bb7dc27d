#include "ui/picture/radiance_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace ui {
namespace {

using sim::Problem;

constexpr std::size_t kLongestHeader = 65536;
// Scanlines of other lengths are never of the new run lengths.
constexpr std::int64_t kShortestNewRuns = 8;
constexpr std::int64_t kLongestNewRuns = 0x7fff;
constexpr std::uint8_t kLongestDump = 128;

const char* const kSaveAgain = "open it in an image editor and save it again";

Problem damaged() {
  return {"", "this Radiance image is damaged or cut off", kSaveAgain};
}

using Rgbe = std::array<std::uint8_t, 4>;

/// Takes bytes from the front, as long as there are any.
class Source {
 public:
  explicit Source(std::span<const std::byte> bytes) : rest_(bytes) {}

  bool take(std::uint8_t& byte) {
    if (rest_.empty()) return false;
    byte = std::to_integer<std::uint8_t>(rest_.front());
    rest_ = rest_.subspan(1);
    return true;
  }
  bool take(Rgbe& pixel) { return take(pixel[0]) && take(pixel[1]) && take(pixel[2]) && take(pixel[3]); }
  /// Without its end; nothing where there is no end within `most` bytes.
  std::optional<std::string> line(std::size_t most) {
    std::string text;
    std::uint8_t byte = 0;
    while (text.size() < most && take(byte)) {
      if (byte != '\n') {
        text += static_cast<char>(byte);
        continue;
      }
      if (text.ends_with('\r')) text.pop_back();
      return text;
    }
    return std::nullopt;
  }
  std::uint8_t ahead(std::size_t index) const {
    return index < rest_.size() ? std::to_integer<std::uint8_t>(rest_[index]) : std::uint8_t{0};
  }

 private:
  std::span<const std::byte> rest_;
};

/// The numbers of a text; empty where something else is among them.
std::vector<double> numbersOf(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    const std::size_t start = text.find_first_not_of(" \t");
    if (start == std::string_view::npos) return numbers;
    text.remove_prefix(start);
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return {};
    numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

/// What the header says of the numbers of all pixels.
struct Header {
  std::array<double, 3> multiplier{1.0, 1.0, 1.0};  ///< that was laid over radiance
  double gamma = 1.0;                               ///< radiance was raised to its inverse
};

std::optional<Problem> takeVariable(std::string_view name, std::string_view value, Header& header) {
  if (name == "FORMAT") {
    const std::size_t start = value.find_first_not_of(" \t");
    const std::string format(start == std::string_view::npos ? "" : value.substr(start));
    if (format.starts_with("32-bit_rle_rgbe")) return std::nullopt;
    if (format.starts_with("32-bit_rle_xyze"))
      return Problem{"", "this Radiance image has CIE XYZ colours (32-bit_rle_xyze)",
                     "convert it to RGB, by Radiance's ra_xyze -r or an image editor"};
    return Problem{"", "this Radiance image is of a format that nobody knows", kSaveAgain};
  }
  const std::vector<double> numbers = numbersOf(value);
  const auto isMultiplier = [](double number) { return number >= 1e-30 && number <= 1e30; };
  const bool areMultipliers = std::all_of(numbers.begin(), numbers.end(), isMultiplier);
  if (name == "EXPOSURE" && numbers.size() == 1 && areMultipliers) {
    for (double& channel : header.multiplier) channel *= numbers[0];
  } else if (name == "COLORCORR" && numbers.size() == 3 && areMultipliers) {
    for (std::size_t c = 0; c < 3; ++c) header.multiplier[c] *= numbers[c];
  } else if (name == "GAMMA" && numbers.size() == 1 && numbers[0] >= 0.1 && numbers[0] <= 10.0) {
    header.gamma = numbers[0];
  } else if (name == "EXPOSURE" || name == "COLORCORR" || name == "GAMMA") {
    return Problem{"", "the " + std::string(name) + " of this Radiance image makes no sense", kSaveAgain};
  }
  return std::nullopt;
}

sim::Result<Header> takeHeader(Source& source) {
  Header header;
  std::size_t left = kLongestHeader;
  std::optional<std::string> line = source.line(left);
  if (!line || !line->starts_with("#?")) return damaged();
  while (true) {
    line = source.line(left);
    if (!line) return damaged();
    if (line->empty()) return header;
    left -= std::min(left, line->size() + 1);
    const std::size_t equals = line->find('=');
    if (line->starts_with('#') || equals == std::string::npos) continue;  // a remark, or a command
    const std::string_view text(*line);
    if (const auto problem = takeVariable(text.substr(0, equals), text.substr(equals + 1), header))
      return *problem;
  }
}

/// How scanlines lie in the image. The axis that is named first is the slower one.
struct Order {
  struct Axis {
    char name = 'Y';
    bool forward = true;  ///< as stored: x to the right, y upwards
    std::int64_t count = 0;
  };
  Axis slow, fast;

  std::int64_t width() const { return slow.name == 'X' ? slow.count : fast.count; }
  std::int64_t height() const { return slow.name == 'Y' ? slow.count : fast.count; }
  /// Of the pixel at `index` of scanline `line` in rows from the top.
  std::size_t placeOf(std::int64_t line, std::int64_t index) const {
    std::int64_t x = 0, y = 0;
    for (const auto& [axis, at] : {std::pair(slow, line), std::pair(fast, index)}) {
      const std::int64_t back = axis.count - 1 - at;
      if (axis.name == 'X') x = axis.forward ? at : back;
      if (axis.name == 'Y') y = axis.forward ? back : at;
    }
    return static_cast<std::size_t>(y * width() + x);
  }
};

std::optional<Order::Axis> takeAxis(std::string_view& text) {
  const std::size_t start = std::min(text.find_first_not_of(' '), text.size());
  text.remove_prefix(start);
  if (text.size() < 4 || (text[0] != '+' && text[0] != '-') || (text[1] != 'X' && text[1] != 'Y') ||
      text[2] != ' ')
    return std::nullopt;
  Order::Axis axis{text[1], text[0] == '+', 0};
  text.remove_prefix(std::min(text.find_first_not_of(' ', 2), text.size()));
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), axis.count);
  if (error != std::errc() || axis.count < 1) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return axis;
}

std::optional<Order> takeOrder(Source& source) {
  const std::optional<std::string> line = source.line(256);
  if (!line) return std::nullopt;
  std::string_view text(*line);
  const auto slow = takeAxis(text);
  const auto fast = takeAxis(text);
  if (!slow || !fast || slow->name == fast->name || text.find_first_not_of(' ') != std::string_view::npos)
    return std::nullopt;
  return Order{*slow, *fast};
}

/// Each of the four numbers by itself, in runs and dumps. False: cut off, or a run that goes past the end.
bool takeNewRuns(Source& source, std::vector<Rgbe>& scanline) {
  for (std::size_t channel = 0; channel < 4; ++channel) {
    for (std::size_t at = 0; at < scanline.size();) {
      std::uint8_t count = 0, value = 0;
      if (!source.take(count) || count == 0) return false;
      const bool isRun = count > kLongestDump;
      if (isRun) count = static_cast<std::uint8_t>(count - kLongestDump);
      if (count > scanline.size() - at || (isRun && !source.take(value))) return false;
      for (std::uint8_t n = 0; n < count; ++n) {
        if (!isRun && !source.take(value)) return false;
        scanline[at++][channel] = value;
      }
    }
  }
  return true;
}

/// Pixel by pixel; one of mantissas 1, 1, 1 says how often the last is repeated, in digits to the base 256.
bool takeOldRuns(Source& source, std::vector<Rgbe>& scanline) {
  std::uint32_t shift = 0;
  for (std::size_t at = 0; at < scanline.size();) {
    Rgbe pixel{};
    if (!source.take(pixel)) return false;
    if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
      scanline[at++] = pixel;
      shift = 0;
      continue;
    }
    const std::uint64_t count = shift < 32 ? std::uint64_t{pixel[3]} << shift : ~std::uint64_t{0};
    if (at == 0 || count > scanline.size() - at) return false;
    for (std::uint64_t n = 0; n < count; ++n, ++at) scanline[at] = scanline[at - 1];
    shift += 8;
  }
  return true;
}

bool takeScanline(Source& source, std::vector<Rgbe>& scanline) {
  const auto length = static_cast<std::int64_t>(scanline.size());
  const bool mayBeNew = length >= kShortestNewRuns && length <= kLongestNewRuns;
  if (!mayBeNew || source.ahead(0) != 2 || source.ahead(1) != 2 || (source.ahead(2) & 0x80U) != 0)
    return takeOldRuns(source, scanline);
  Rgbe head{};
  if (!source.take(head) || head[2] * 256 + head[3] != length) return false;
  return takeNewRuns(source, scanline);
}

Light lightOf(const Rgbe& pixel, const Header& header) {
  Light light = Light::Zero();
  if (pixel[3] == 0) return light;
  for (std::size_t c = 0; c < 3; ++c) {
    double value = std::ldexp(static_cast<double>(pixel[c]), pixel[3] - 136);
    if (header.gamma != 1.0) value = std::pow(value, header.gamma);
    light[static_cast<Eigen::Index>(c)] = static_cast<float>(value / header.multiplier[c]);
  }
  return light;
}

}  // namespace

sim::Result<EnvironmentImage> readRadiance(std::span<const std::byte> bytes) {
  Source source(bytes);
  const sim::Result<Header> header = takeHeader(source);
  if (!header) return header.problem();
  const std::optional<Order> order = takeOrder(source);
  if (!order) return damaged();
  if (auto problem = wrongEnvironmentSize(order->width(), order->height())) return *problem;
  EnvironmentImage image{static_cast<int>(order->width()), static_cast<int>(order->height()), {}};
  image.pixels.resize(static_cast<std::size_t>(order->width() * order->height()));
  std::vector<Rgbe> scanline(static_cast<std::size_t>(order->fast.count));
  for (std::int64_t line = 0; line < order->slow.count; ++line) {
    if (!takeScanline(source, scanline)) return damaged();
    for (std::int64_t index = 0; index < order->fast.count; ++index)
      image.pixels[order->placeOf(line, index)] = lightOf(scanline[static_cast<std::size_t>(index)], *header);
  }
  return image;
}

}  // namespace ui
