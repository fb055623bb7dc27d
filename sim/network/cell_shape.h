#pragma once

#include <array>
#include <cstdint>

/// The sides and edges of a cell, by its corners: corner c = i + 2 j + 4 k is at local coordinates (i, j, k).
namespace sim {

inline constexpr std::uint32_t kCellCorners = 8;
inline constexpr std::uint32_t kCellSides = 6;

/// Corners of a cell's sides, counter-clockwise seen from outside the cell. Side 2 a + b is where the local
/// coordinate a is b.
inline constexpr std::array<std::array<std::uint8_t, 4>, kCellSides> kSideCorners{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

/// An edge from a corner to the one a step further along a local axis, with its two sides in such an order
/// that (edge's middle, first side's middle, cell's middle, second side's middle) turns counter-clockwise
/// seen from the far end.
struct CellEdge {
  std::uint8_t low;
  std::uint8_t high;
  std::uint8_t firstSide;
  std::uint8_t secondSide;
};

constexpr std::array<CellEdge, 12> makeCellEdges() {
  std::array<CellEdge, 12> edges{};
  std::size_t count = 0;
  for (std::uint8_t axis = 0; axis < 3; ++axis) {
    const auto second = static_cast<std::uint8_t>((axis + 1) % 3);
    const auto third = static_cast<std::uint8_t>((axis + 2) % 3);
    for (std::uint8_t bits = 0; bits < 4; ++bits) {
      const auto secondBit = static_cast<std::uint8_t>(bits & 1U);
      const auto thirdBit = static_cast<std::uint8_t>(bits >> 1U);
      const auto low = static_cast<std::uint8_t>((secondBit << second) | (thirdBit << third));
      // The side across the third axis lies, seen from the edge, along the second, and the other way round.
      const auto acrossThird = static_cast<std::uint8_t>(2 * third + thirdBit);
      const auto acrossSecond = static_cast<std::uint8_t>(2 * second + secondBit);
      const bool straight = secondBit == thirdBit;
      edges[count++] = {low, static_cast<std::uint8_t>(low | (1U << axis)),
                        straight ? acrossThird : acrossSecond, straight ? acrossSecond : acrossThird};
    }
  }
  return edges;
}
inline constexpr std::array<CellEdge, 12> kCellEdges = makeCellEdges();

}  // namespace sim
