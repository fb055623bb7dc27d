#include "modeling/material/checkerboard.h"

#include <bit>

namespace modeling {
namespace {

/// The cells at each node, as rows of one array.
struct CellsOfNodes {
  std::vector<std::size_t> first;
  std::vector<sim::CellIndex> cells;
};

CellsOfNodes cellsOfNodes(const std::vector<sim::CellCorners>& cells, std::size_t nodeCount) {
  CellsOfNodes rows;
  rows.first.assign(nodeCount + 1, 0);
  for (const auto& cell : cells)
    for (const auto node : cell) ++rows.first[node + 1];
  for (std::size_t i = 0; i < nodeCount; ++i) rows.first[i + 1] += rows.first[i];
  rows.cells.resize(rows.first.back());
  std::vector<std::size_t> next(rows.first.begin(), rows.first.end() - 1);
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const auto node : cells[c]) rows.cells[next[node]++] = static_cast<sim::CellIndex>(c);
  return rows;
}

}  // namespace

std::vector<std::uint8_t> checkerboard(const std::vector<sim::CellCorners>& cells, std::size_t nodeCount) {
  constexpr std::uint8_t kUnknown = 2;
  const CellsOfNodes rows = cellsOfNodes(cells, nodeCount);
  std::vector<std::uint8_t> colour(nodeCount, kUnknown);
  std::vector<std::uint8_t> odd(cells.size(), kUnknown);
  std::vector<sim::CellIndex> waiting;
  for (std::size_t start = 0; start < cells.size(); ++start) {
    if (odd[start] != kUnknown) continue;
    odd[start] = 0;
    waiting.assign(1, static_cast<sim::CellIndex>(start));
    for (std::size_t next = 0; next < waiting.size(); ++next) {
      const sim::CellCorners& cell = cells[waiting[next]];
      for (unsigned c = 0; c < 8; ++c) {
        if (colour[cell[c]] != kUnknown) continue;
        colour[cell[c]] = static_cast<std::uint8_t>((odd[waiting[next]] + std::popcount(c)) & 1);
      }
      for (const auto node : cell)
        for (std::size_t i = rows.first[node]; i < rows.first[node + 1]; ++i) {
          const sim::CellIndex neighbour = rows.cells[i];
          if (odd[neighbour] != kUnknown) continue;
          // The node just coloured decides, through its place in the neighbour.
          unsigned corner = 0;
          while (cells[neighbour][corner] != node) ++corner;
          odd[neighbour] = static_cast<std::uint8_t>((colour[node] + std::popcount(corner)) & 1);
          waiting.push_back(neighbour);
        }
    }
  }
  return odd;
}

}  // namespace modeling
