#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include "modeling/assembly/assembly.h"

/// Blocks of cells as networks, and the linear algebra of small motions about rest: what holds of a network
/// without stepping it in time.
namespace tests {

using modeling::Lattice;
using modeling::Material;

/// A block of cubes of edge h (cm), its corner at the origin, z innermost.
struct Block {
  std::array<unsigned, 3> cells{1, 1, 1};
  double h = 1.0;

  std::size_t node(unsigned i, unsigned j, unsigned k) const;
  std::size_t nodeCount() const;
  sim::Vec3 size() const;
  Lattice lattice() const;
  /// Nodes displaced by up to `amount` of h in each direction, those on a face of the block within the face.
  Lattice shaken(double amount, std::uint64_t seed) const;
};

/// Parts side by side, nothing glued.
modeling::GlueResult unglued(const std::vector<modeling::AssemblyPart>& parts);

/// One part, assembled; the lattice must be sound.
sim::Blueprint bodyOf(const Lattice& lattice, const Material& material);

/// A material whose numbers make errors easy to see: E = 1000, density 2.
Material plainMaterial(modeling::BondPattern pattern = modeling::BondPattern::full);

/// Force on each degree of freedom (3 node + axis) by small displacements.
Eigen::SparseMatrix<double> stiffnessMatrix(const sim::Blueprint& body);

Eigen::VectorXd massVector(const sim::Blueprint& body);

/// Degrees of freedom that are not `held`, as columns of the identity.
Eigen::SparseMatrix<double> freeSpace(const std::vector<bool>& held);

/// Lowest angular frequency (rad/s) of the body with `held` degrees of freedom at rest.
double lowestFrequency(const sim::Blueprint& body, const std::vector<bool>& held);

}  // namespace tests
