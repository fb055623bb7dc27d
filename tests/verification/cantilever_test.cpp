#include <cmath>

#include <catch2/catch.hpp>

#include "tests/support/elastic_body.h"

using tests::Block;

namespace {

/// A beam along z, clamped at z = 0, of n x n cells and 10 times as long as thick.
struct Cantilever {
  explicit Cantilever(unsigned n) : block{{n, n, 10 * n}, 1.0 / n} {
    material = tests::plainMaterial();
    body = tests::bodyOf(block.lattice(), material);
    held.assign(3 * block.nodeCount(), false);
    for (unsigned i = 0; i <= n; ++i)
      for (unsigned j = 0; j <= n; ++j)
        for (std::size_t axis = 0; axis < 3; ++axis) held[3 * block.node(i, j, 0) + axis] = true;
  }

  double length() const { return block.size().z(); }
  double secondMoment() const { return std::pow(block.size().x(), 4) / 12.0; }

  /// Force over deflection of the end, pushed along x.
  double stiffness() const {
    const unsigned n = block.cells[0];
    Eigen::VectorXd force = Eigen::VectorXd::Zero(Eigen::Index(held.size()));
    const double each = 1.0 / ((n + 1) * (n + 1));
    for (unsigned i = 0; i <= n; ++i)
      for (unsigned j = 0; j <= n; ++j) force[Eigen::Index(3 * block.node(i, j, block.cells[2]))] = each;
    const Eigen::SparseMatrix<double> free = tests::freeSpace(held);
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(
        Eigen::SparseMatrix<double>(free.transpose() * tests::stiffnessMatrix(body) * free));
    return 1.0 / force.dot(free * factor.solve(free.transpose() * force));
  }

  Block block;
  modeling::Material material;
  sim::Blueprint body;
  std::vector<bool> held;
};

/// Shear makes a beam softer than bending alone: 1 + 3 E I / (kappa G A L^2), with G = 0.4 E, kappa = 5/6 and
/// I / A = h^2 / 12 (Timoshenko).
double timoshenko(const Cantilever& beam) {
  const double thickness = beam.block.size().x();
  return 1.0 + 3.0 * thickness * thickness / 12.0 / (5.0 / 6.0 * 0.4 * beam.length() * beam.length());
}

double relativeStiffness(const Cantilever& beam) {
  const double theory =
      3.0 * beam.material.youngsModulus * beam.secondMoment() / std::pow(beam.length(), 3) / timoshenko(beam);
  return beam.stiffness() / theory;
}

double relativePeriod(const Cantilever& beam) {
  const double root = 1.8751040687119611;  // first root of cos x cosh x = -1
  const double thickness = beam.block.size().x();
  const double theory =
      root * root *
      std::sqrt(beam.material.youngsModulus * beam.secondMoment() /
                (beam.material.density * thickness * thickness * std::pow(beam.length(), 4)));
  return theory / tests::lowestFrequency(beam.body, beam.held);
}

}  // namespace

TEST_CASE("a cantilever of n cells of thickness is too stiff by 1 + 1.3 / n^2 and no more") {
  for (const unsigned n : {1U, 2U, 3U, 4U}) {
    const Cantilever beam(n);
    INFO(n << " cells of thickness");
    // The law is a fit itself, good to 2 %.
    const double correction = 1.0 + 1.3 / (n * n);
    CHECK(relativeStiffness(beam) == Approx(correction).epsilon(0.02));
    // The period of bending against Euler's and Bernoulli's, which leave out shear and turning (1 % here).
    CHECK(relativePeriod(beam) == Approx(1.0 / std::sqrt(correction)).epsilon(0.03));
  }
}
