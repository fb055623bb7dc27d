#include "tests/support/elastic_body.h"

#include <cmath>
#include <random>
#include <stdexcept>

namespace tests {

std::size_t Block::node(unsigned i, unsigned j, unsigned k) const {
  return (std::size_t{i} * (cells[1] + 1) + j) * (cells[2] + 1) + k;
}

std::size_t Block::nodeCount() const {
  return std::size_t{cells[0] + 1} * (cells[1] + 1) * (cells[2] + 1);
}

sim::Vec3 Block::size() const {
  return h * sim::Vec3(cells[0], cells[1], cells[2]);
}

Lattice Block::lattice() const {
  return shaken(0.0, 0);
}

Lattice Block::shaken(double amount, std::uint64_t seed) const {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> within(-1.0, 1.0);
  Lattice lattice;
  for (unsigned i = 0; i <= cells[0]; ++i)
    for (unsigned j = 0; j <= cells[1]; ++j)
      for (unsigned k = 0; k <= cells[2]; ++k) {
        const std::array<unsigned, 3> at{i, j, k};
        sim::Vec3 position;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double shift = amount * within(random);
          const bool onFace = at[axis] == 0 || at[axis] == cells[axis];
          position[Eigen::Index(axis)] = h * (at[axis] + (onFace ? 0.0 : shift));
        }
        lattice.nodes.push_back(position);
      }
  for (unsigned i = 0; i < cells[0]; ++i)
    for (unsigned j = 0; j < cells[1]; ++j)
      for (unsigned k = 0; k < cells[2]; ++k) {
        sim::CellCorners corners{};
        for (unsigned c = 0; c < 8; ++c)
          corners[c] =
              static_cast<sim::NodeIndex>(node(i + (c & 1U), j + (c >> 1U & 1U), k + (c >> 2U & 1U)));
        lattice.cells.push_back(corners);
      }
  return lattice;
}

modeling::GlueResult unglued(const std::vector<modeling::AssemblyPart>& parts) {
  modeling::GlueResult glue;
  for (const auto& part : parts) {
    std::vector<sim::NodeIndex> global;
    for (std::size_t i = 0; i < part.lattice.nodes.size(); ++i)
      global.push_back(static_cast<sim::NodeIndex>(glue.nodeCount++));
    glue.globalNode.push_back(global);
    glue.gluedBy.emplace_back(part.lattice.nodes.size(), sim::kNone);
    glue.droppedCells.emplace_back();
    glue.misshapen.emplace_back();
  }
  return glue;
}

sim::Blueprint bodyOf(const Lattice& lattice, const Material& material) {
  modeling::AssemblyPart part;
  part.name = "body";
  part.lattice = lattice;
  auto blueprint = modeling::assemble({part}, {material}, unglued({part}));
  if (!blueprint) throw std::runtime_error(blueprint.problem().line());
  return std::move(blueprint).value();
}

Material plainMaterial(modeling::BondPattern pattern) {
  Material material;
  material.name = "plain";
  material.pattern = pattern;
  material.youngsModulus = 1000.0;
  material.density = 2.0;
  return material;
}

Eigen::SparseMatrix<double> stiffnessMatrix(const sim::Blueprint& body) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(body.bonds.size() * 36);
  for (const auto& bond : body.bonds) {
    const sim::Vec3 direction = (body.nodes[bond.b].position - body.nodes[bond.a].position).normalized();
    const Eigen::Matrix3d block = bond.stiffness * direction * direction.transpose();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int a = 3 * int(bond.a);
        const int b = 3 * int(bond.b);
        entries.emplace_back(a + i, a + j, block(i, j));
        entries.emplace_back(b + i, b + j, block(i, j));
        entries.emplace_back(a + i, b + j, -block(i, j));
        entries.emplace_back(b + i, a + j, -block(i, j));
      }
  }
  const auto size = Eigen::Index(3 * body.nodes.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::VectorXd massVector(const sim::Blueprint& body) {
  Eigen::VectorXd masses(Eigen::Index(3 * body.nodes.size()));
  for (std::size_t i = 0; i < body.nodes.size(); ++i)
    masses.segment<3>(Eigen::Index(3 * i)).setConstant(body.nodes[i].mass);
  return masses;
}

Eigen::SparseMatrix<double> freeSpace(const std::vector<bool>& held) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (!held[i]) entries.emplace_back(int(i), int(entries.size()), 1.0);
  Eigen::SparseMatrix<double> columns(Eigen::Index(held.size()), Eigen::Index(entries.size()));
  columns.setFromTriplets(entries.begin(), entries.end());
  return columns;
}

double lowestFrequency(const sim::Blueprint& body, const std::vector<bool>& held) {
  const Eigen::SparseMatrix<double> free = freeSpace(held);
  const Eigen::SparseMatrix<double> stiffness = free.transpose() * stiffnessMatrix(body) * free;
  const Eigen::VectorXd masses = free.transpose() * massVector(body);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(stiffness);
  // Inverse iteration. A pair of equal lowest frequencies (bending about two axes) does it no harm.
  Eigen::VectorXd shape = Eigen::VectorXd::LinSpaced(masses.size(), 1.0, 2.0);
  double squared = 0.0;
  for (int turn = 0; turn < 60; ++turn) {
    shape = factor.solve(masses.cwiseProduct(shape));
    squared = shape.dot(stiffness * shape) / shape.dot(masses.cwiseProduct(shape));
    shape.normalize();
  }
  return std::sqrt(squared);
}

}  // namespace tests
