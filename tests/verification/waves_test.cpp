#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "tests/support/elastic_body.h"

using tests::Block;

namespace {

/// Plane waves exp(i q.x) in an endless lattice, from the bonds of one node in the middle of a block: all its
/// bonds have their final sum there.
class PlaneWaves {
 public:
  explicit PlaneWaves(const modeling::Material& material, double h) {
    const Block block{{4, 4, 4}, h};
    const sim::Blueprint body = tests::bodyOf(block.lattice(), material);
    const std::size_t centre = block.node(2, 2, 2);
    mass_ = body.nodes[centre].mass;
    for (const auto& bond : body.bonds)
      if (bond.a == centre || bond.b == centre)
        bonds_.push_back({body.nodes[bond.b].position - body.nodes[bond.a].position, bond.stiffness});
  }

  /// Angular frequencies of the three polarisations, rising.
  sim::Vec3 frequencies(const sim::Vec3& wave) const {
    Eigen::Matrix3d dynamic = Eigen::Matrix3d::Zero();
    for (const auto& [reach, stiffness] : bonds_) {
      const sim::Vec3 direction = reach.normalized();
      dynamic += stiffness * (1.0 - std::cos(wave.dot(reach))) * direction * direction.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(dynamic / mass_);
    return solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  }

 private:
  struct Bond {
    sim::Vec3 reach;
    double stiffness;
  };
  std::vector<Bond> bonds_;
  double mass_ = 0.0;
};

const std::vector<sim::Vec3> kDirections{sim::Vec3(1.0, 0.0, 0.0), sim::Vec3(1.0, 1.0, 0.0).normalized(),
                                         sim::Vec3(1.0, 1.0, 1.0).normalized(),
                                         sim::Vec3(0.3, -0.5, 0.8).normalized()};

}  // namespace

TEST_CASE("long waves travel as in an isotropic body, in every direction") {
  // lambda = mu = 0.4 E: C11 = 1.2 E, C44 = 0.4 E. Waves of 1000 cells differ from endless ones by 1e-5.
  const modeling::Material material = tests::plainMaterial();
  for (const auto pattern :
       {modeling::BondPattern::full, modeling::BondPattern::faces, modeling::BondPattern::fig1}) {
    modeling::Material patterned = material;
    patterned.pattern = pattern;
    const double h = 0.3;
    const PlaneWaves waves(patterned, h);
    const double q = 2.0 * std::numbers::pi / (1000.0 * h);
    for (const sim::Vec3& direction : kDirections) {
      const sim::Vec3 speeds = waves.frequencies(q * direction) / q;
      CHECK(speeds[0] == Approx(std::sqrt(0.4 * 1000.0 / 2.0)).epsilon(1e-5));
      CHECK(speeds[1] == Approx(std::sqrt(0.4 * 1000.0 / 2.0)).epsilon(1e-5));
      CHECK(speeds[2] == Approx(std::sqrt(1.2 * 1000.0 / 2.0)).epsilon(1e-5));
    }
  }
}

TEST_CASE("waves along an edge disperse as those of a chain") {
  // All bonds that a plane wave along x stretches reach one cell: omega = 2 sqrt(C / rho) / h |sin(q h / 2)|.
  const double h = 0.3;
  const PlaneWaves waves(tests::plainMaterial(), h);
  for (int step = 1; step <= 10; ++step) {
    const double q = std::numbers::pi / h * step / 10.0;
    const sim::Vec3 frequencies = waves.frequencies(sim::Vec3(q, 0.0, 0.0));
    const double sine = std::sin(q * h / 2.0);
    CHECK(frequencies[0] == Approx(2.0 * std::sqrt(0.4 * 1000.0 / 2.0) / h * sine).epsilon(1e-9));
    CHECK(frequencies[2] == Approx(2.0 * std::sqrt(1.2 * 1000.0 / 2.0) / h * sine).epsilon(1e-9));
  }
}

TEST_CASE("no plane wave is faster than the frequency that damping refers to") {
  const modeling::Material material = tests::plainMaterial();
  const double h = 0.3;
  const PlaneWaves waves(material, h);
  double highest = 0.0;
  constexpr int kSteps = 12;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j <= kSteps; ++j)
      for (int k = 0; k <= kSteps; ++k)
        highest = std::max(highest,
                           waves.frequencies(std::numbers::pi / h / kSteps * sim::Vec3(i, j, k)).maxCoeff());
  CHECK(highest == Approx(modeling::highestFrequency(material, h)).epsilon(1e-9));
}

TEST_CASE("a bar held at one end rings as a quarter of a sound wave in a thin bar") {
  // omega = pi / (2 L) sqrt(E / rho), lowered by lateral inertia: 1 - (nu q)^2 I_p / (2 A) (Rayleigh).
  const Block bar{{2, 2, 40}, 0.5};
  const sim::Blueprint body = tests::bodyOf(bar.lattice(), tests::plainMaterial());
  std::vector<bool> held(3 * bar.nodeCount(), false);
  for (unsigned i = 0; i <= 2; ++i)
    for (unsigned j = 0; j <= 2; ++j) held[3 * bar.node(i, j, 0) + 2] = true;
  // Bending would be lower: the bar's axis stays straight.
  for (unsigned k = 0; k <= 40; ++k) held[3 * bar.node(1, 1, k)] = held[3 * bar.node(1, 1, k) + 1] = true;
  for (unsigned k = 0; k <= 40; ++k) held[3 * bar.node(2, 1, k) + 1] = true;  // nor does it turn
  const sim::Vec3 size = bar.size();
  const double q = std::numbers::pi / (2.0 * size.z());
  const double polar = (size.x() * size.x() + size.y() * size.y()) / 12.0;
  const double theory = q * std::sqrt(1000.0 / 2.0) * (1.0 - 0.25 * 0.25 * q * q * polar / 2.0);
  CHECK(tests::lowestFrequency(body, held) == Approx(theory).epsilon(0.001));
}
