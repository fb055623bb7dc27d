#include <algorithm>
#include <cmath>

#include "sim/dynamics/methods/vector_sums.h"
#include "sim/dynamics/stepper.h"

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

}  // namespace

/// What one-step methods are shown of the world.
class Stepper::TrialWorld final : public World {
 public:
  explicit TrialWorld(Stepper& stepper) : stepper_(&stepper) {}

  void rates(const Motion& at, double ahead, Rates& rates) override { stepper_->ratesAt(at, ahead, rates); }
  void tangents(const Motion& at, double ahead, std::vector<Tangent>& tangents) override {
    stepper_->tangentsAt(at, ahead, tangents);
  }

 private:
  Stepper* stepper_;
};

void Stepper::ratesAt(const Motion& at, double ahead, Rates& rates) {
  rates.dissipated = 0.0;
  rates.outsideWork = 0.0;
  if (contacts_.quiet()) {
    Contacts::clear(forces_);
  } else {
    const std::vector<MovingCollider> colliders = controls_.collidersAhead(ahead);
    Contacts::Moment trial{at, colliders, controls_.materials(), kick()};
    trial.awake = fragments_.activity().awakeLanes();
    trial.awakeVersion = fragments_.activity().version();
    const Contacts::ColliderWork work = contacts_.computeForces(trial, forces_);
    rates.outsideWork += work.outside / kick();
    rates.dissipated += work.dissipated / kick();
    work_.contactPairs += contacts_.pairCount();
  }
  rates.outsideWork += carryingWork(at, forces_, 1.0);
  Motion unmoved;
  KernelStep step = kernelStep(at, unmoved);
  for (std::size_t k = 0; k < 3; ++k) step.nextVelocity[k] = rates.acceleration.axis(k);
  step.accelerationOnly = true;
  runKernel(step, reports_);
  for (const std::uint32_t block : fragments_.activity().activeBlocks())
    rates.dissipated += reports_[block].dissipated;
  work_.bondsEvaluated += network_.bondCount() - breakage_.brokenBondCount();
}

void Stepper::tangentsAt(const Motion& at, double ahead, std::vector<Tangent>& tangents) const {
  tangents.clear();
  for (BondIndex index = 0; index < network_.bondCount(); ++index) {
    if (breakage_.bondBroken(index)) continue;
    const BondClass& bond = network_.bond(index);
    const MaterialNow& material = controls_.materials()[bond.material];
    const NodeIndex a = network_.bondStart(index);
    const NodeIndex b = network_.bondEnds[index];
    const Vec3 apart = at.position.get(b) - at.position.get(a);
    const double length = apart.norm();
    const double stiffness = bond.stiffness * material.stiffnessScale;
    const double tension = std::max(0.0, 1.0 - layout_.restLength(network_, index) / length);
    tangents.push_back(
        {a, b, apart / length, stiffness, stiffness * tension, bond.damping * material.dampingScale, 0.0});
  }
  if (contacts_.quiet()) return;
  const std::vector<MovingCollider> colliders = controls_.collidersAhead(ahead);
  contacts_.addTangents({at, colliders, controls_.materials(), kick()}, forces_, tangents);
}

/// Rest lengths flow between steps, by the length of the last.
void Stepper::flowPlastically() {
  if (!layout_.hasPlastic() || lastStep_ == 0.0) return;
  KernelStep step = kernelStep(now_, next_);
  step.flowing = true;
  runKernel(step, reports_);
  for (const std::uint32_t block : fragments_.activity().activeBlocks())
    ledger_.addDissipated(reports_[block].dissipated);
  startKnown_ = false;
}

double Stepper::worstExcess(std::span<const Breakage::Overstretched> bonds, const Motion& motion) const {
  double worst = -1.0;
  for (const Breakage::Overstretched& over : bonds) {
    const double threshold = static_cast<double>(network_.thresholds[over.bond]);
    worst = std::max(worst, strainIn(motion, over.bond) / threshold - 1.0);
  }
  return worst;
}

/// Makes the step shorter until it ends just where the first of these bonds breaks: false position (Illinois)
/// on steps done again. Gives what flowed in the step that now ends in next_.
OneStepMethod::Flow Stepper::locateBreak(std::span<const Breakage::Overstretched> bonds,
                                         OneStepMethod::Flow flow, double& length) {
  TrialWorld world(*this);
  constexpr double kAim = 0.5 * kLocatedExcess;
  const double whole = length;
  double low = 0.0;
  double lowExcess = std::min(worstExcess(bonds, now_) - kAim, 0.0);
  double highExcess = worstExcess(bonds, next_) - kAim;
  int side = 0;
  bool atHigh = true;
  while (highExcess > kLocatedExcess - kAim && length - low > kFinestSearch * whole &&
         length > kShortestLocated * whole) {
    const double share = std::clamp(lowExcess / (lowExcess - highExcess), 0.01, 0.99);
    const double middle = std::max(low + share * (length - low), kShortestLocated * whole);
    const std::optional<OneStepMethod::Flow> trial =
        oneStep_->advance(world, now_, startRates_, middle, next_);
    if (!trial) break;
    const double excess = worstExcess(bonds, next_) - kAim;
    atHigh = excess > -kAim;
    if (atHigh) {
      length = middle;
      flow = *trial;
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
  if (!atHigh) flow = oneStep_->advance(world, now_, startRates_, length, next_).value_or(flow);
  return flow;
}

/// The rates where a step starts, and the bonds that must break before it: those overstretched from the
/// beginning, or by a change from outside.
void Stepper::makeStartKnown() {
  if (startKnown_) return;
  ratesAt(now_, 0.0, startRates_);
  const std::uint64_t before = breakage_.brokenBondCount();
  breakOverstretched();
  if (breakage_.brokenBondCount() != before) {
    ratesAt(now_, 0.0, startRates_);
  }
  startKnown_ = true;
}

/// Makes the step shorter until the method finds its end, and that with a tolerable error.
std::optional<OneStepMethod::Flow> Stepper::tryStep(double& length) {
  TrialWorld world(*this);
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    const std::optional<OneStepMethod::Flow> flow =
        oneStep_->advance(world, now_, startRates_, length, next_);
    if (!flow) {
      length *= 0.5;
      continue;
    }
    ratesAt(next_, length, endRates_);
    if (tolerates(length)) return flow;
  }
  return std::nullopt;
}

Result<double> Stepper::moveByOneStep() {
  flowPlastically();
  setStep(wantedStep_);
  makeStartKnown();
  double length = step_;
  std::optional<OneStepMethod::Flow> flow = tryStep(length);
  if (!flow) return blowUp("moves in a way for which no step is short enough");
  if (const auto bonds = findOverstretched(next_); !bonds.empty()) {
    *flow = locateBreak(bonds, *flow, length);
    ratesAt(next_, length, endRates_);
  }
  if (stopTrial(endRates_, length)) ratesAt(next_, length, endRates_);
  double fastest = 0.0;
  if (const Status healthy = checkSpeeds(fastest); !healthy) return healthy.problem();
  setStep(length);
  ledger_.addDissipated(flow->dissipated);
  ledger_.addOutsideWork(flow->outsideWork);
  std::swap(now_, next_);
  std::swap(startRates_, endRates_);
  startKnown_ = true;
  contacts_.settle(now_);
  return fastest * length;
}

/// Of both ends of the step being made.
Status Stepper::checkSpeeds(double& fastest) const {
  fastest = 0.0;
  for (NodeIndex node = 0; node < network_.nodeCount(); ++node) {
    const double speed = next_.velocity.get(node).norm();
    if (!(speed * speed < kLightSpeedSquared)) return blowUp("is faster than light");
    fastest = std::max({fastest, speed, now_.velocity.get(node).norm()});
  }
  return Done{};
}

}  // namespace sim
