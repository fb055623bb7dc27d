#include "sim/methods/tangent_matrix.h"

#include <algorithm>

namespace sim {

void TangentMatrix::makePattern(std::span<const Tangent> tangents, std::size_t nodeCount) {
  std::vector<std::vector<NodeIndex>> rows(nodeCount);
  for (NodeIndex node = 0; node < nodeCount; ++node) rows[node].push_back(node);
  for (const Tangent& tangent : tangents) {
    if (tangent.b == kNone) continue;
    rows[tangent.a].push_back(tangent.b);
    rows[tangent.b].push_back(tangent.a);
  }
  firstBlock_.assign(1, 0);
  columns_.clear();
  for (std::vector<NodeIndex>& row : rows) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    columns_.insert(columns_.end(), row.begin(), row.end());
    firstBlock_.push_back(static_cast<std::uint32_t>(columns_.size()));
  }
  const auto size = static_cast<Eigen::Index>(3 * nodeCount);
  matrix_.resize(size, size);
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(9 * columns_.size()));
  int* column = matrix_.innerIndexPtr();
  int* end = matrix_.outerIndexPtr();
  *end = 0;
  for (const std::vector<NodeIndex>& row : rows) {
    for (int k = 0; k < 3; ++k) {
      for (const NodeIndex other : row) {
        for (int c = 0; c < 3; ++c) *column++ = static_cast<int>(3 * other) + c;
      }
      end[1] = end[0] + 3 * static_cast<int>(row.size());
      ++end;
    }
  }
}

std::uint32_t TangentMatrix::findBlock(NodeIndex row, NodeIndex column) const {
  const auto first = columns_.begin() + firstBlock_[row];
  const auto last = columns_.begin() + firstBlock_[row + 1];
  const auto found = std::lower_bound(first, last, column);
  return found != last && *found == column ? static_cast<std::uint32_t>(found - first) : kNone;
}

void TangentMatrix::addBlock(NodeIndex row, std::uint32_t block, const Eigen::Matrix3d& values) {
  const std::size_t width = 3 * static_cast<std::size_t>(firstBlock_[row + 1] - firstBlock_[row]);
  double* at = matrix_.valuePtr() + 9 * static_cast<std::size_t>(firstBlock_[row]) + 3 * block;
  for (Eigen::Index k = 0; k < 3; ++k, at += width) {
    for (Eigen::Index c = 0; c < 3; ++c) at[c] += values(k, c);
  }
}

const TangentMatrix::Matrix& TangentMatrix::assemble(std::span<const Tangent> tangents,
                                                     std::span<const double> inverseMasses,
                                                     std::size_t nodeCount, double h) {
  const bool fits = firstBlock_.size() == nodeCount + 1 &&
                    std::all_of(tangents.begin(), tangents.end(), [&](const Tangent& tangent) {
                      return tangent.b == kNone || findBlock(tangent.a, tangent.b) != kNone;
                    });
  if (!fits) makePattern(tangents, nodeCount);
  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
  for (NodeIndex node = 0; node < nodeCount; ++node) {
    const double mass = inverseMasses[node] > 0.0 ? 1.0 / inverseMasses[node] : 1.0;
    addBlock(node, findBlock(node, node), mass * Eigen::Matrix3d::Identity());
  }
  for (const Tangent& tangent : tangents) {
    const double along = h * (tangent.damping + h * tangent.stiffness);
    const double across = h * (tangent.lateralDamping + h * tangent.lateralStiffness);
    const Eigen::Matrix3d block =
        (along - across) * tangent.along * tangent.along.transpose() + across * Eigen::Matrix3d::Identity();
    const bool aMoves = inverseMasses[tangent.a] > 0.0;
    const bool bMoves = tangent.b != kNone && inverseMasses[tangent.b] > 0.0;
    if (aMoves) addBlock(tangent.a, findBlock(tangent.a, tangent.a), block);
    if (bMoves) addBlock(tangent.b, findBlock(tangent.b, tangent.b), block);
    if (!aMoves || !bMoves) continue;
    addBlock(tangent.a, findBlock(tangent.a, tangent.b), -block);
    addBlock(tangent.b, findBlock(tangent.b, tangent.a), -block);
  }
  return matrix_;
}

std::size_t TangentMatrix::memoryBytes() const {
  return static_cast<std::size_t>(matrix_.nonZeros()) * (sizeof(double) + sizeof(int)) +
         (columns_.capacity() + firstBlock_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace sim
