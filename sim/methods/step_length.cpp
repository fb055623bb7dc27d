#include "sim/methods/step_length.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/methods/stable_step.h"

namespace sim {
namespace {

/// An automatic step grows only when it may by this much.
constexpr double kStepGrowth = 1.1;
/// Where no bond is evaluated, the step may be twice as long, but no longer: when a piece melts, the strain
/// it kept acts for half a step of before.
constexpr double kStillLattice = 0.25;
/// s. A network in which nothing is stiff moves in free flight: any step will do, frames set the pace.
constexpr double kLongest = 1e-2;
/// Of the longest stable step: where a fixed one is too long it is divided into equal parts no longer than
/// this.
constexpr double kSafetyOfParts = 0.9;
/// The step aimed at, relative to the one that would use the tolerance up: room for the error to change a
/// little without a change of the step.
constexpr double kAim = 0.8;
/// Twice a swing its error is small. A step must not follow it there, so that it grows by this in a shortest
/// swing at most.
constexpr double kGrowthPerSwing = 2.0;
/// Below this strain there is nothing that an error could be relative to, and rounding would be taken for
/// one.
constexpr double kNoStrain = 1e-9;
/// No attempt at a step is shorter than this share of the one before.
constexpr double kMostShrinking = 0.2;

}  // namespace

StepLength::StepLength(const Settings& settings, const Spectrum& spectrum)
    : settings_(settings), spectrum_(spectrum) {}

double StepLength::choose(const Scene& scene, double wanted) {
  latticeCounts_ = scene.latticeMoves;
  const Stiffening stiffening{latticeStiffness(scene.stiffnessScale), scene.dampingScale,
                              scene.contactRateSquared, scene.contactDamping};
  if (settings_.step) return partOfFixed(stiffening);
  const double stable = automaticStep(spectrum_, stiffening, settings_.method, settings_.safety);
  const double best = std::min(
      {stable, kLongest, latticeCounts_ ? toleratedStep_ : kLongest, scene.longestTravel / scene.speed});
  const bool changes = wanted == 0.0 || best < wanted || best > kStepGrowth * wanted;
  return changes ? best : wanted;
}

/// The fixed step, or an equal part of it while contacts or a track make the scene too stiff for the whole.
double StepLength::partOfFixed(const Stiffening& stiffening) {
  const double step = *settings_.step;
  if (isImplicit(settings_.method)) return step;
  const Stiffening untouched{stiffening.stiffnessScale, stiffening.dampingScale};
  longestFixed_ = stableStep(spectrum_, untouched, settings_.method, 1.0);
  const double longest = stableStep(spectrum_, stiffening, settings_.method, 1.0);
  if (step <= longest) return step;
  if (!(longest > 0.0)) return 0.0;
  return step / std::ceil(step / (kSafetyOfParts * longest));
}

/// Relative to the network's own.
double StepLength::latticeStiffness(double stiffnessScale) const {
  return (latticeCounts_ ? 1.0 : kStillLattice) * stiffnessScale;
}

StepLimit StepLength::limit(double stiffnessScale, double dampingScale, double step) const {
  if (settings_.step) return StepLimit::fixed;
  if (latticeCounts_ && step >= toleratedStep_) return StepLimit::tolerance;
  const Stiffening alone{latticeStiffness(stiffnessScale), dampingScale, 0.0, 0.0};
  const double lattice = automaticStep(spectrum_, alone, settings_.method, settings_.safety);
  if (kStepGrowth * step >= lattice) return StepLimit::lattice;
  return kStepGrowth * step < kLongest ? StepLimit::contact : StepLimit::none;
}

double StepLength::stiffestRate(double stiffnessScale) const {
  return spectrum_.highestFrequency * std::sqrt(stiffnessScale);
}

/// With this the stiffest swing of bonds keeps to the tolerance. Where forces leap, as friction's do, no step
/// would be short enough.
double StepLength::shortestTolerated(double stiffnessScale) const {
  const ErrorRule& rule = recordOf(settings_.method).error;
  return std::min(kAnyStep, rule.sure * std::pow(*settings_.tolerance, 1.0 / (rule.power - 1)) /
                                stiffestRate(stiffnessScale));
}

void StepLength::beginSurely(double stiffnessScale) {
  toleratedStep_ = shortestTolerated(stiffnessScale);
}

/// The step that would have used the tolerance up.
double StepLength::longestTolerated(const Made& made, double stiffnessScale) {
  const double omega = stiffestRate(stiffnessScale);
  if (!(omega > 0.0)) return std::numeric_limits<double>::infinity();
  largestStrain_ = std::max(largestStrain_, made.strain);
  const double swing = 2.0 * std::numbers::pi / omega;
  const double perSwing = made.error / std::max(largestStrain_, kNoStrain) * swing / made.length;
  if (!(perSwing > 0.0)) return std::numeric_limits<double>::infinity();
  const int power = recordOf(settings_.method).error.power;
  return made.length * std::pow(*settings_.tolerance / perSwing, 1.0 / (power - 1));
}

void StepLength::aimFor(double longest, double elapsed, double stiffnessScale) {
  const double growth =
      std::pow(kGrowthPerSwing, elapsed * stiffestRate(stiffnessScale) / (2.0 * std::numbers::pi));
  if (longest < toleratedStep_) {
    toleratedStep_ = std::max(kAim * longest, shortestTolerated(stiffnessScale));
  } else {
    toleratedStep_ = std::max(toleratedStep_, std::min({kAim * longest, growth * toleratedStep_, kAnyStep}));
  }
}

void StepLength::follow(const Made& made, double elapsed, double stiffnessScale) {
  aimFor(longestTolerated(made, stiffnessScale), elapsed, stiffnessScale);
}

bool StepLength::accepts(const Made& made, double& length, double stiffnessScale) {
  const double longest = longestTolerated(made, stiffnessScale);
  const double shortest = shortestTolerated(stiffnessScale);
  if (longest >= kAim * length || length <= shortest) {
    aimFor(longest, length, stiffnessScale);
    return true;
  }
  length = std::max({kAim * longest, kMostShrinking * length, shortest});
  toleratedStep_ = std::min(toleratedStep_, length);
  return false;
}

void StepLength::save(ByteWriter& writer) const {
  writer.put(toleratedStep_);
  writer.put(largestStrain_);
}

bool StepLength::load(ByteReader& reader) {
  reader.read(toleratedStep_);
  reader.read(largestStrain_);
  return reader.ok() && std::isfinite(toleratedStep_) && std::isfinite(largestStrain_) &&
         toleratedStep_ > 0.0;
}

void StepLength::takeOver(const StepLength& other) {
  toleratedStep_ = kAnyStep;
  largestStrain_ = other.largestStrain_;
}

}  // namespace sim
