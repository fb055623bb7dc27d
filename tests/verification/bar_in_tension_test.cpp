#include <catch2/catch.hpp>

#include "tests/support/elastic_body.h"

using tests::Block;

namespace {

/// Young's modulus of a bar (relative to its material's) pulled along z: its end faces stay flat and
/// parallel, free to contract; modulus = pull * length / (area * extension).
double tensileModulus(const Block& bar, const modeling::Lattice& lattice,
                      const modeling::Material& material) {
  const sim::Blueprint body = tests::bodyOf(lattice, material);
  const Eigen::SparseMatrix<double> stiffness = tests::stiffnessMatrix(body);
  std::vector<bool> held(3 * bar.nodeCount(), false);
  Eigen::VectorXd given = Eigen::VectorXd::Zero(Eigen::Index(held.size()));
  for (unsigned i = 0; i <= bar.cells[0]; ++i)
    for (unsigned j = 0; j <= bar.cells[1]; ++j) {
      held[3 * bar.node(i, j, 0) + 2] = held[3 * bar.node(i, j, bar.cells[2]) + 2] = true;
      given[Eigen::Index(3 * bar.node(i, j, bar.cells[2]) + 2)] = 1.0;
    }
  // Three more, against sliding and turning.
  held[3 * bar.node(0, 0, 0)] = held[3 * bar.node(0, 0, 0) + 1] = held[3 * bar.node(bar.cells[0], 0, 0) + 1] =
      true;

  const Eigen::SparseMatrix<double> free = tests::freeSpace(held);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(
      Eigen::SparseMatrix<double>(free.transpose() * stiffness * free));
  const Eigen::VectorXd moved = given - free * factor.solve(free.transpose() * (stiffness * given));
  const double pull = given.dot(stiffness * moved);
  const sim::Vec3 size = bar.size();
  return pull * size.z() / (size.x() * size.y()) / material.youngsModulus;
}

/// Mean over five random distortions.
double shakenModulus(double amount, modeling::BondPattern pattern = modeling::BondPattern::full) {
  const Block bar{{4, 4, 16}, 0.5};
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    sum += tensileModulus(bar, bar.shaken(amount, seed), tests::plainMaterial(pattern)) / 5.0;
  return sum;
}

}  // namespace

TEST_CASE("a bar of cubes has exactly its material's modulus at every resolution") {
  for (const unsigned n : {1U, 2U, 4U}) {
    const Block bar{{n, n, 4 * n}, 2.0 / n};
    CHECK(tensileModulus(bar, bar.lattice(), tests::plainMaterial()) == Approx(1.0).epsilon(1e-9));
  }
}

TEST_CASE("a bar keeps its modulus when its cells are distorted at random") {
  const Block bar{{4, 4, 16}, 0.5};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    CHECK(tensileModulus(bar, bar.shaken(0.10, seed), tests::plainMaterial()) == Approx(1.0).epsilon(0.005));
    CHECK(tensileModulus(bar, bar.shaken(0.25, seed), tests::plainMaterial()) == Approx(1.0).epsilon(0.04));
  }
}

TEST_CASE("a bar of boxes has its material's modulus where the full pattern can have it") {
  // Boxes half as long again as they are wide: the 15 equations and the bounds can be met.
  Block bar{{3, 3, 8}, 1.0};
  modeling::Lattice lattice = bar.lattice();
  for (sim::Vec3& node : lattice.nodes) node.z() *= 1.5;
  // The bar is 1.5 times as long as tensileModulus() takes it to be.
  CHECK(1.5 * tensileModulus(bar, lattice, tests::plainMaterial()) == Approx(1.0).epsilon(0.002));
}

TEST_CASE("the sparser patterns are right in cubes and near it in distorted cells") {
  using modeling::BondPattern;
  CHECK(shakenModulus(0.0, BondPattern::faces) == Approx(1.0).epsilon(1e-9));
  CHECK(shakenModulus(0.1, BondPattern::faces) == Approx(1.0).epsilon(0.005));
  CHECK(shakenModulus(0.25, BondPattern::faces) == Approx(1.0).epsilon(0.04));
  // With one diagonal a face the cells of the border are out of balance, and give.
  CHECK(shakenModulus(0.0, BondPattern::fig2) == Approx(0.985).epsilon(0.005));
  CHECK(shakenModulus(0.1, BondPattern::fig2) == Approx(0.975).epsilon(0.005));
  CHECK(shakenModulus(0.25, BondPattern::fig2) == Approx(0.923).epsilon(0.01));
  CHECK(shakenModulus(0.0, BondPattern::fig1) == Approx(1.0).epsilon(1e-9));
  CHECK(shakenModulus(0.1, BondPattern::fig1) == Approx(0.973).epsilon(0.005));
  CHECK(shakenModulus(0.25, BondPattern::fig1) == Approx(0.88).epsilon(0.02));
}
