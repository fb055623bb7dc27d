#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace modeling {

/// How finely a shape is divided, the same for all shapes. Each shape's header says what its axes u, v, w
/// are. An axis with a count gets exactly that many cells; an axis without one gets as many as make its cells
/// nearest to cellSize.
struct Resolution {
  double cellSize = 0.5;                       ///< cm, > 0; read only where a count is missing
  std::array<std::optional<int>, 3> counts{};  ///< cells along u, v, w; each >= 1

  bool operator==(const Resolution&) const = default;
};

/// More nodes than this are refused: at 800 bytes a node it is 4 GB, and almost always a slip of the decimal
/// point.
inline constexpr std::size_t kMaxLatticeNodes = 5'000'000;

}  // namespace modeling
