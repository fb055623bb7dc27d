#include "app/cli/frames.h"

#include <charconv>
#include <cmath>

namespace app {

namespace {

/// The number that is the whole text, `absent` for an empty text, nothing for any other.
std::optional<std::size_t> frameNumber(std::string_view text, std::size_t absent) {
  if (text.empty()) return absent;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

sim::Status needFrames(const sim::TakeReader& take, const std::string& path) {
  if (take.frameCount() > 0) return sim::Done{};
  return sim::Problem{path, "this take has no frames", "simulate it again"};
}

sim::Result<FrameRange> parseFrameRange(const std::string& text, const sim::TakeReader& take) {
  const std::size_t newest = take.frameCount() - 1;
  const std::string present = "frames 0:" + std::to_string(newest);
  const std::string_view view(text);
  const std::size_t colon = view.find(':');
  const std::string_view start = view.substr(0, colon);
  const auto first = frameNumber(start, 0);
  const auto last = colon == std::string_view::npos ? first : frameNumber(view.substr(colon + 1), newest);
  if (!first || !last || text.empty()) {
    return sim::Problem{"--frames", "\"" + text + "\" is no range of frames", "write A:B, as in " + present};
  }
  if (*first > *last || *last > newest) {
    return sim::Problem{"--frames", "the take does not have frames " + text, "it has " + present};
  }
  return FrameRange{*first, *last};
}

std::size_t frameNearest(double time, const sim::TakeReader& take) {
  std::size_t nearest = 0;
  for (std::size_t frame = 1; frame < take.frameCount(); ++frame) {
    if (std::abs(take.frameTime(frame) - time) < std::abs(take.frameTime(nearest) - time)) nearest = frame;
  }
  return nearest;
}

}  // namespace app
