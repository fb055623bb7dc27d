#include "app/bench/closed_form_chain.h"

#include <cmath>
#include <numbers>

namespace app {

using Eigen::Index;

ClosedFormChain::ClosedFormChain(const Constants& constants, double pull, double reach)
    : constants_(constants) {
  const auto count = static_cast<Index>(constants.count);
  modes_.resize(count, count);
  for (Index mode = 0; mode < count; ++mode) {
    for (Index node = 0; node < count; ++node) {
      modes_(node, mode) = std::cos(std::numbers::pi * static_cast<double>(mode) *
                                    (static_cast<double>(node) + 0.5) / static_cast<double>(count));
    }
    modes_.col(mode).normalize();
  }
  start_.resize(count);
  for (Index node = 0; node < count; ++node)
    start_(node) = pull * std::exp(-std::pow(static_cast<double>(count - 1 - node) / reach, 2));
  amplitudes_ = modes_.transpose() * start_;
  dampingTime_ = 2.0 * constants.dampingRatio / frequency(count - 1);
}

double ClosedFormChain::frequency(Index mode) const {
  return 2.0 * std::sqrt(constants_.stiffness / constants_.mass) *
         std::sin(static_cast<double>(mode) * std::numbers::pi / (2.0 * constants_.count));
}

double ClosedFormChain::longestPeriod() const {
  return 2.0 * std::numbers::pi / frequency(1);
}

sim::Blueprint ClosedFormChain::blueprint() const {
  sim::Blueprint blueprint;
  blueprint.materials = {{.name = "spring"}};
  blueprint.partNames = {"chain"};
  const double damping = dampingTime_ * constants_.stiffness;
  for (unsigned node = 0; node < constants_.count; ++node) {
    const double x = static_cast<double>(node) + start_(static_cast<Index>(node));
    blueprint.nodes.push_back({.position = sim::Vec3(x, 0.0, 0.0), .mass = constants_.mass});
    if (node > 0) blueprint.bonds.push_back({node - 1, node, constants_.stiffness, 1.0, damping, 0});
  }
  return blueprint;
}

std::vector<sim::Vec3> ClosedFormChain::positionsAt(double time) const {
  Eigen::VectorXd present = amplitudes_;
  for (Index mode = 1; mode < present.size(); ++mode) {
    const double undamped = frequency(mode);
    const double decay = 0.5 * dampingTime_ * undamped * undamped;
    const double damped = std::sqrt(undamped * undamped - decay * decay);
    present(mode) *=
        std::exp(-decay * time) * (std::cos(damped * time) + decay / damped * std::sin(damped * time));
  }
  const Eigen::VectorXd displacement = modes_ * present;
  std::vector<sim::Vec3> positions;
  for (Index node = 0; node < displacement.size(); ++node)
    positions.emplace_back(static_cast<double>(node) + displacement(node), 0.0, 0.0);
  return positions;
}

}  // namespace app
