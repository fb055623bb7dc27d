#include "modeling/shapes/cell_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace modeling {
namespace {

sim::Result<int> countGiven(int count, std::size_t axis, int multiple, int least) {
  const std::string place = "resolution.counts[" + std::to_string(axis) + "]";
  if (count < least)
    return sim::Problem{place, "there must be at least " + std::to_string(least) + " cells along this axis",
                        "use " + std::to_string(least) + " or more"};
  if (count % multiple != 0) {
    const int below = std::max(count / multiple * multiple, least);
    return sim::Problem{place,
                        std::to_string(count) + " cells cannot be laid out here, only a multiple of " +
                            std::to_string(multiple),
                        "use " + std::to_string(below) + " or " + std::to_string(below + multiple)};
  }
  if (count > static_cast<int>(kMaxLatticeNodes))
    return sim::Problem{place, std::to_string(count) + " cells are too many", "use fewer"};
  return count;
}

}  // namespace

std::string roughCount(double count) {
  if (count < 1e6) return std::to_string(static_cast<int>(count));
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g million", count / 1e6);
  return text.data();
}

sim::Result<int> cellsAlong(const Resolution& resolution, std::size_t axis, double length, int multiple,
                            int least) {
  if (resolution.counts[axis]) return countGiven(*resolution.counts[axis], axis, multiple, least);
  const double size = resolution.cellSize;
  if (!(size > 0.0) || !std::isfinite(size))
    return sim::Problem{"resolution.cellSize", "the cell size must be a positive number of centimetres",
                        "use for example 0.5"};
  const double cells = length / size;
  if (!(cells < static_cast<double>(kMaxLatticeNodes)))
    return sim::Problem{"resolution.cellSize", "that would be " + roughCount(cells) + " cells along one axis",
                        "use larger cells"};
  return std::max(least, static_cast<int>(std::lround(cells / multiple)) * multiple);
}

std::optional<sim::Problem> checkNodeCount(double nodes) {
  if (nodes <= static_cast<double>(kMaxLatticeNodes)) return std::nullopt;
  return sim::Problem{"resolution",
                      "the shape would have " + roughCount(nodes) + " nodes; at most " +
                          std::to_string(kMaxLatticeNodes) + " can be held",
                      "use larger cells or smaller counts"};
}

}  // namespace modeling
