#pragma once

#include <memory>
#include <optional>
#include <span>

#include "sim/methods/integrator.h"
#include "sim/methods/one_step_scheme.h"

namespace sim {

/// Steps a World by a scheme whose positions and velocities are of the same moment. A step in which a bond
/// passes its threshold is done again, shorter, until it ends where the first bond breaks (docs/numerics.md,
/// "Methods").
class OneStep final : public Integrator {
 public:
  OneStep(std::unique_ptr<OneStepScheme> scheme, const World& world);

  Result<double> advance(World& world, StepLength& length) override;
  bool stepsAsWanted() const override { return false; }
  BreakingMoment breakingMoment(const World& world) const override { return {world.now, world.time()}; }
  void forgetForces() override { startKnown_ = false; }
  std::size_t memoryBytes() const override;

 private:
  class Trial;

  void flowPlastically(World& world);
  void makeStartKnown(World& world);
  std::optional<OneStepScheme::Flow> tryStep(World& world, StepLength& choice, double& length);
  bool isTolerable(World& world, StepLength& choice, double& length) const;
  OneStepScheme::Flow locateBreak(World& world, std::span<const Breakage::Overstretched> bonds,
                                  OneStepScheme::Flow flow, double& length);

  std::unique_ptr<OneStepScheme> scheme_;
  Rates start_;  ///< of world.now, if they are known
  Rates end_;    ///< of where a step ended
  bool startKnown_ = false;
};

}  // namespace sim
