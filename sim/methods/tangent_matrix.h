#pragma once

#include <span>
#include <vector>

#include <Eigen/SparseCore>

#include "sim/state/tangent.h"

namespace sim {

/// M + h C + h^2 K, symmetric and positive definite, three rows a node: what an implicit step of length h
/// solves with. Its pattern is kept as long as all tangents fit in, so that breaks and contacts that end cost
/// nothing, and values are written in the order of the tangents.
class TangentMatrix {
 public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /// Held nodes have an inverse mass of zero; their rows are those of the unit matrix.
  const Matrix& assemble(std::span<const Tangent> tangents, std::span<const double> inverseMasses,
                         std::size_t nodeCount, double h);
  std::size_t memoryBytes() const;

 private:
  void makePattern(std::span<const Tangent> tangents, std::size_t nodeCount);
  /// Of a block in the rows of `row`, in blocks; kNone where the pattern has none.
  std::uint32_t findBlock(NodeIndex row, NodeIndex column) const;
  void addBlock(NodeIndex row, std::uint32_t block, const Eigen::Matrix3d& values);

  Matrix matrix_;
  std::vector<std::uint32_t> firstBlock_;  ///< rows of columns_
  std::vector<NodeIndex> columns_;         ///< ascending in each row, its own among them
};

}  // namespace sim
