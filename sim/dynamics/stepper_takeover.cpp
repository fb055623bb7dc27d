#include <cassert>

#include "sim/dynamics/stepper.h"

// How a run goes on under other conditions. What depends on them is found anew: the step, who is near whom,
// what may be skipped. What has happened to the network is taken over.

namespace sim {

/// Everything deforms, and positions and velocities are of one moment.
void Stepper::bringToPresent() {
  fragments_.wakeEverything(time());
  fragments_.meltEverything(time());
  fitReference();
  finishKick();
}

void Stepper::takeOver(Stepper& other) {
  assert(work_.steps == 0);
  double before = 0.0;
  other.arena_.execute([&] {
    other.bringToPresent();
    before = other.potentialEnergy();
  });
  arena_.execute([&] {
    adoptState(other);
    controlsTime_ = time();
    controls_.moveTo(controlsTime_);
    startTolerance();
    contacts_.takeOver(other.contacts_);
    refreshContacts();
    ledger_.addOutsideWork(potentialEnergy() - before);
    ledger_.addOutsideWork(
        ledger_.gravityWork(now_.position, other.controls_.gravity(), controls_.gravity()));
    ledger_.forgetKept();
  });
}

void Stepper::adoptState(const Stepper& other) {
  now_ = other.now_;
  next_ = now_;
  layOut(other.breakage_.brokenBonds(), other.layout_.plasticRestLengths());
  breakage_.restore(other.breakage_.brokenBonds(), other.breakage_.brokenCells());
  components_.restore(other.components_.fragmentOfNode(), other.components_.births(),
                      other.components_.relabelings());
  fragments_.takeOver(other.fragments_);
  if (reference_) {
    reference_->noteBirths(components_);
    reference_->fit(now_.position, fragments_.activity());
    reference_->forgetDisplacements();
  }
  fittedVersion_ = fragments_.activity().version();
  ledger_.takeOver(other.ledger_);
  work_ = other.work_;
  segmentStart_ = other.time();
  segmentSteps_ = 0;
  step_ = wantedStep_ = lastStep_ = 0.0;
  toleratedStep_ = kAnyStep;
  largestStrain_ = other.largestStrain_;
  forces_.forgetRows();
  startKnown_ = false;
  events_.clear();
}

}  // namespace sim
