#include "sim/methods/one_step.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/collider_holds.h"
#include "sim/methods/step_length.h"
#include "sim/methods/strain_error.h"
#include "sim/passes/collider_stops.h"
#include "sim/passes/health.h"
#include "sim/world/forces.h"

namespace sim {
namespace {

/// Strain beyond the threshold, relative to it, with which a located bond breaks: above the rounding of the
/// threshold's own 24 bits, and no more than a thousandth of the force that it had.
constexpr double kLocatedExcess = 1e-6;
/// No step is searched more finely than this share of it.
constexpr double kFinestSearch = 1e-4;
/// What breaks within this share of a step breaks together: in a crack that runs on and on, steps must not
/// shrink to nothing.
constexpr double kShortestLocated = 1.0 / 64.0;
/// A step whose end is not found, or only roughly, is made shorter so often at most.
constexpr int kMostAttempts = 12;

/// The largest strain of these bonds over their thresholds, less 1.
double worstExcess(const World& world, std::span<const Breakage::Overstretched> bonds, const Motion& motion) {
  double worst = -1.0;
  for (const Breakage::Overstretched& over : bonds) {
    const double threshold = static_cast<double>(world.network.thresholds[over.bond]);
    worst = std::max(worst, strainIn(world, motion, over.bond) / threshold - 1.0);
  }
  return worst;
}

/// cm/s, of both ends of the step being made.
Result<double> fastestOfStep(const World& world) {
  double fastest = 0.0;
  for (NodeIndex node = 0; node < world.network.nodeCount(); ++node) {
    const double speed = world.next.velocity.get(node).norm();
    if (!(speed * speed < kLightSpeedSquared)) return blowUp(world, "is faster than light");
    fastest = std::max({fastest, speed, world.now.velocity.get(node).norm()});
  }
  return fastest;
}

}  // namespace

/// What the scheme is shown of the world.
class OneStep::Trial final : public RightHandSide {
 public:
  Trial(World& world, double kick) : world_(world), kick_(kick) {}

  void rates(const Motion& at, double ahead, Rates& rates) override {
    ratesAt(world_, at, ahead, kick_, rates);
  }
  void tangents(const Motion& at, double ahead, std::vector<Tangent>& tangents) override {
    tangentsAt(world_, at, ahead, kick_, tangents);
  }

 private:
  World& world_;
  double kick_;
};

OneStep::OneStep(std::unique_ptr<OneStepScheme> scheme, const World& world)
    : scheme_(std::move(scheme)),
      start_{NodeVectors(world.network.nodeCount())},
      end_{NodeVectors(world.network.nodeCount())} {}

Result<double> OneStep::advance(World& world, StepLength& choice) {
  flowPlastically(world);
  setStep(world, world.clock.wanted);
  makeStartKnown(world);
  const double friction = kick(world.clock);
  double length = world.clock.step;
  std::optional<OneStepScheme::Flow> flow = tryStep(world, choice, length);
  if (!flow) return blowUp(world, "moves in a way for which no step is short enough");
  if (const auto bonds = findOverstretched(world, world.next); !bonds.empty()) {
    *flow = locateBreak(world, bonds, *flow, length);
    ratesAt(world, world.next, length, friction, end_);
  }
  if (stopAfterStep(world, end_.acceleration, length)) ratesAt(world, world.next, length, friction, end_);
  const Result<double> fastest = fastestOfStep(world);
  if (!fastest) return fastest.problem();
  setStep(world, length);
  world.ledger.addDissipated(flow->dissipated);
  world.ledger.addOutsideWork(flow->outsideWork);
  std::swap(world.now, world.next);
  std::swap(start_, end_);
  startKnown_ = true;
  world.contacts.settle(world.now, world.controls.colliders(), world.time());
  if (holdsAtColliders(world.contacts.model()) && !world.contacts.quiet()) {
    world.ledger.addDissipated(followHolds(world.contacts, contactMoment(world, friction), world.forces));
    startKnown_ = false;
  }
  if (!world.contacts.surfaces().quiet()) {
    world.ledger.addDissipated(world.contacts.follow(world.now.position));
    startKnown_ = false;
  }
  return *fastest * length;
}

/// Rest lengths flow between steps, by the length of the last.
void OneStep::flowPlastically(World& world) {
  if (!world.layout.hasPlastic() || world.clock.last == 0.0) return;
  KernelStep step = kernelStep(world, world.now, world.next);
  step.flowing = true;
  runKernel(world, step, world.reports);
  world.ledger.addDissipated(dissipatedBy(world, world.reports));
  startKnown_ = false;
}

/// The rates where a step starts, and the bonds that must break before it: those overstretched from the
/// beginning, or by a change from outside.
void OneStep::makeStartKnown(World& world) {
  if (startKnown_) return;
  const double friction = kick(world.clock);
  ratesAt(world, world.now, 0.0, friction, start_);
  const std::uint64_t before = world.breakage.brokenBondCount();
  breakOverstretched(world, breakingMoment(world));
  if (world.breakage.brokenBondCount() != before) ratesAt(world, world.now, 0.0, friction, start_);
  startKnown_ = true;
}

/// Makes the step shorter until the scheme finds its end, and that with a tolerable error.
std::optional<OneStepScheme::Flow> OneStep::tryStep(World& world, StepLength& choice, double& length) {
  const double friction = kick(world.clock);
  Trial trial(world, friction);
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    const std::optional<OneStepScheme::Flow> flow =
        scheme_->advance(trial, world.now, start_, length, world.next);
    if (!flow) {
      length *= 0.5;
      continue;
    }
    ratesAt(world, world.next, length, friction, end_);
    if (isTolerable(world, choice, length)) return flow;
  }
  return std::nullopt;
}

/// Whether the step of this length was no longer than tolerated; else makes it shorter, for another.
bool OneStep::isTolerable(World& world, StepLength& choice, double& length) const {
  if (!choice.hasTolerance()) return true;
  NodeVectors error(world.network.nodeCount());
  scheme_->estimateError(world.now, start_, length, world.next, end_, error);
  const double scale = world.controls.largestStiffnessScale();
  const StrainError wrong = strainError(world, error, choice.stiffestRate(scale));
  return choice.accepts({wrong.error, wrong.strain, length}, length, scale);
}

/// Makes the step shorter until it ends just where the first of these bonds breaks: false position (Illinois)
/// on steps done again. Gives what flowed in the step that now ends in world.next.
OneStepScheme::Flow OneStep::locateBreak(World& world, std::span<const Breakage::Overstretched> bonds,
                                         OneStepScheme::Flow flow, double& length) {
  Trial trial(world, kick(world.clock));
  constexpr double kAim = 0.5 * kLocatedExcess;
  const double whole = length;
  double low = 0.0;
  double lowExcess = std::min(worstExcess(world, bonds, world.now) - kAim, 0.0);
  double highExcess = worstExcess(world, bonds, world.next) - kAim;
  int side = 0;
  bool atHigh = true;
  while (highExcess > kLocatedExcess - kAim && length - low > kFinestSearch * whole &&
         length > kShortestLocated * whole) {
    const double share = std::clamp(lowExcess / (lowExcess - highExcess), 0.01, 0.99);
    const double middle = std::max(low + share * (length - low), kShortestLocated * whole);
    const std::optional<OneStepScheme::Flow> tried =
        scheme_->advance(trial, world.now, start_, middle, world.next);
    if (!tried) break;
    const double excess = worstExcess(world, bonds, world.next) - kAim;
    atHigh = excess > -kAim;
    if (atHigh) {
      length = middle;
      flow = *tried;
      highExcess = std::max(excess, 0.0);
      if (side == 1) lowExcess *= 0.5;
      side = 1;
      if (excess <= 0.0) break;
    } else {
      low = middle;
      lowExcess = excess;
      if (side == -1) highExcess *= 0.5;
      side = -1;
    }
  }
  if (!atHigh) flow = scheme_->advance(trial, world.now, start_, length, world.next).value_or(flow);
  return flow;
}

std::size_t OneStep::memoryBytes() const {
  return scheme_->memoryBytes() + start_.acceleration.memoryBytes() + end_.acceleration.memoryBytes();
}

}  // namespace sim
