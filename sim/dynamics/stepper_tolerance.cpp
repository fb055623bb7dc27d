#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/base/parallel.h"
#include "sim/dynamics/methods/vector_sums.h"
#include "sim/dynamics/stepper.h"

namespace sim {
namespace {

/// The leapfrog family's error is looked at this often: that takes forces once more.
constexpr std::uint64_t kStepsPerLook = 16;
/// The step aimed at, relative to the one that would use the tolerance up: room for the error to change a
/// little without a change of the step.
constexpr double kAim = 0.8;
/// Twice a swing its error is small. A step must not follow it there, so that it grows by this in a shortest
/// swing at most.
constexpr double kGrowthPerSwing = 2.0;
/// Below this strain there is nothing that an error could be relative to, and rounding would be taken for
/// one.
constexpr double kNoStrain = 1e-9;
constexpr std::size_t kBlockGrain = 32;
constexpr int kLeapfrogErrorPower = 3;
/// omega times the step over tolerance^(1 / (errorPower - 1)). The stiffest swing by itself needs 1.95 with
/// Verlet, 2.67 with rk4, 1.38 with the midpoint rule, 0.32 with implicit Euler, less kAim.
constexpr double kSureOfLeapfrog = 1.5;
constexpr double kSureOfOneStep = 0.25;

/// Sums over bonds.
struct StrainSquares {
  double error = 0.0;
  double strain = 0.0;
};

}  // namespace

/// 1/s: of the shortest swing of bonds.
double Stepper::stiffestRate() const {
  return spectrum_.highestFrequency * std::sqrt(controls_.largestStiffnessScale());
}

/// s: with this the stiffest swing of bonds keeps to the tolerance. Where forces leap, as friction's do, no
/// step would be short enough.
double Stepper::shortestStep() const {
  const int power = oneStep_ ? oneStep_->errorPower() : kLeapfrogErrorPower;
  const double sure = oneStep_ ? kSureOfOneStep : kSureOfLeapfrog;
  return std::min(kAnyStep, sure * std::pow(*settings_.tolerance, 1.0 / (power - 1)) / stiffestRate());
}

/// Leapfrog steps cannot be taken back, so the first is one that surely is short enough.
void Stepper::startTolerance() {
  if (settings_.tolerance && !oneStep_) toleratedStep_ = shortestStep();
}

/// Means over all intact bonds, of the squares of the errors of strain, and of strains with their rates over
/// omega: so a swing is as large when it passes through zero.
double Stepper::strainErrorPerSwing(const NodeVectors& error, double length) {
  const double omega = stiffestRate();
  const std::uint64_t intact = network_.bondCount() - breakage_.brokenBondCount();
  if (!(omega > 0.0) || intact == 0) return 0.0;
  const std::span<const std::uint32_t> blocks = fragments_.activity().activeBlocks();
  std::vector<StrainSquares> squares(blocks.size());
  const auto addBond = [&](BondIndex bond, StrainSquares& sum) {
    const NodeIndex a = network_.bondStart(bond);
    const NodeIndex b = network_.bondEnds[bond];
    const double restLength = layout_.restLength(network_, bond);
    const Vec3 apart = now_.position.get(b) - now_.position.get(a);
    const double distance = apart.norm();
    const Vec3 along = apart / (distance * restLength);
    const double strain = distance / restLength - 1.0;
    const double rate = along.dot(now_.velocity.get(b) - now_.velocity.get(a)) / omega;
    const double wrong = along.dot(error.get(b) - error.get(a));
    sum.error += wrong * wrong;
    sum.strain += strain * strain + rate * rate;
  };
  parallelRanges(blocks.size(), kBlockGrain, Sharing::even, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const NodeIndex first = blocks[i] * static_cast<NodeIndex>(kBlockNodes);
      const auto last =
          static_cast<NodeIndex>(std::min<std::size_t>(network_.nodeCount(), first + kBlockNodes));
      for (NodeIndex node = first; node < last; ++node) {
        if (!fragments_.activity().nodeDeforms(node)) continue;
        for (BondIndex bond = network_.firstBond[node]; bond < network_.firstBond[node + 1]; ++bond) {
          if (!breakage_.bondBroken(bond)) addBond(bond, squares[i]);
        }
      }
    }
  });
  StrainSquares sum;
  for (const StrainSquares& block : squares) {
    sum.error += block.error;
    sum.strain += block.strain;
  }
  const auto count = static_cast<double>(intact);
  largestStrain_ = std::max(largestStrain_, std::sqrt(sum.strain / count));
  const double swing = 2.0 * std::numbers::pi / omega;
  return std::sqrt(sum.error / count) / std::max(largestStrain_, kNoStrain) * swing / length;
}

/// The step that would have used the tolerance up, given the error of one of this length.
double Stepper::longestTolerated(const NodeVectors& error, double length, int errorPower) {
  const double perSwing = strainErrorPerSwing(error, length);
  if (!(perSwing > 0.0)) return std::numeric_limits<double>::infinity();
  return length * std::pow(*settings_.tolerance / perSwing, 1.0 / (errorPower - 1));
}

void Stepper::aimFor(double longest, double elapsed) {
  const double growth = std::pow(kGrowthPerSwing, elapsed * stiffestRate() / (2.0 * std::numbers::pi));
  if (longest < toleratedStep_) {
    toleratedStep_ = std::max(kAim * longest, shortestStep());
  } else {
    toleratedStep_ = std::max(toleratedStep_, std::min({kAim * longest, growth * toleratedStep_, kAnyStep}));
  }
}

/// The step just made from next_ to now_, whose kick was `kick`. Of the error the phase is what grows:
/// Verlet's swings are quicker by (omega h)^2 / 24, so that a step is wrong by h^3 / 24 x'''.
void Stepper::lookAtLeapfrogError(double kick) {
  if (!settings_.tolerance || work_.steps % kStepsPerLook != 0 || fragments_.noneDeforms()) return;
  // What is suspect is still to be looked at.
  std::vector<BlockReport> ofThisStep(reports_.size());
  std::swap(reports_, ofThisStep);
  ratesAt(now_, step_, endRates_);
  std::swap(reports_, ofThisStep);
  NodeVectors error(network_.nodeCount());
  const double weight = step_ * step_ / 24.0;
  addWeighted(error, error, WeightedVectors{weight, &endRates_.acceleration},
              WeightedVectors{-weight / kick, &now_.velocity},
              WeightedVectors{weight / kick, &next_.velocity});
  aimFor(longestTolerated(error, step_, kLeapfrogErrorPower), kStepsPerLook * step_);
}

/// Whether a step of this length to next_ was no longer than tolerated; else makes it shorter, for another.
bool Stepper::tolerates(double& length) {
  if (!settings_.tolerance) return true;
  NodeVectors error(network_.nodeCount());
  oneStep_->estimateError(now_, startRates_, length, next_, endRates_, error);
  const double longest = longestTolerated(error, length, oneStep_->errorPower());
  const double shortest = shortestStep();
  if (longest >= kAim * length || length <= shortest) {
    aimFor(longest, length);
    return true;
  }
  constexpr double kMostShrinking = 0.2;
  length = std::max({kAim * longest, kMostShrinking * length, shortest});
  toleratedStep_ = std::min(toleratedStep_, length);
  return false;
}

/// Between steps: nothing is changed within one.
void Stepper::followTolerance() {
  if (!settings_.tolerance) return;
  if (toleratedStep_ < wantedStep_ || work_.steps % kStepsPerLook == 0) chooseStep();
}

}  // namespace sim
