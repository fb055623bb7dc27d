#include "sim/dynamics/stepper.h"

#include <algorithm>
#include <cmath>

#include "sim/base/parallel.h"

namespace sim {
namespace {

/// Energy is drawn up this often: a few per cent of a step's cost each time.
constexpr std::uint64_t kStepsPerLedger = 64;
/// Blocks a task takes at least. A block of 16 nodes takes about a microsecond.
constexpr std::size_t kBlockGrain = 32;
/// An automatic step grows only when it may by this much: every change costs Verlet its symmetry in time.
constexpr double kStepGrowth = 1.1;
/// Where no bond is evaluated, the step may be twice as long, but no longer: when a piece melts, the strain
/// it kept acts for half a step of before.
constexpr double kStillLattice = 0.25;
/// s. A network in which nothing is stiff moves in free flight: any step will do, frames set the pace.
constexpr double kLongest = 1e-2;
/// Frames are due when the time is within this share of a step.
constexpr double kTimeSlack = 1e-6;

std::optional<tbb::global_control> allowThreads(int threads) {
  if (threads <= tbb::this_task_arena::max_concurrency()) return std::nullopt;
  return std::optional<tbb::global_control>(std::in_place, tbb::global_control::max_allowed_parallelism,
                                            static_cast<std::size_t>(threads));
}

}  // namespace

Stepper::Stepper(Network network, Environment environment, std::vector<Track> tracks,
                 const Settings& settings)
    : network_(std::move(network)),
      settings_(settings),
      spectrum_(measureSpectrum(network_)),
      layout_(network_, {settings.skip.thresholds, settings.skip.damping}, settings.precision),
      breakage_(network_),
      components_(network_, layout_),
      contacts_(network_, settings.contact, settings.skip.contactSearch),
      controls_(network_, std::move(environment), std::move(tracks)),
      ledger_(network_),
      kernel_(stepBlocksFor(KernelKind::automatic)),
      floatKernel_(floatKernelFor(KernelKind::automatic)),
      now_{NodeVectors(network_.nodeCount(), 0), NodeVectors(network_.nodeCount(), 1)},
      next_{NodeVectors(network_.nodeCount(), 2), NodeVectors(network_.nodeCount(), 3)},
      inverseMasses_(NodeVectors::paddedCount(network_.nodeCount()), 0.0),
      fragments_({network_, layout_, breakage_, components_, contacts_, controls_, ledger_, now_, next_,
                  inverseMasses_},
                 settings.skip),
      reference_(settings.precision == Precision::float32
                     ? std::make_unique<ReferenceFrames>(network_, components_)
                     : nullptr),
      reports_(layout_.blockCount()),
      oneStep_(oneStepMethod(settings.method, inverseMasses_, network_.nodeCount())),
      moreThreads_(allowThreads(settings.threads)),
      arena_(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic) {
  const std::size_t count = network_.nodeCount();
  forces_.touched.assign(layout_.blockCount(), 0);
  if (oneStep_) startRates_ = {NodeVectors(count)};
  if (oneStep_ || settings.tolerance) endRates_ = {NodeVectors(count)};
  for (std::size_t node = 0; node < count; ++node) {
    now_.position.set(node, network_.positions[node]);
    now_.velocity.set(node, network_.velocities[node]);
    const bool held = !std::isfinite(network_.masses[node]);
    inverseMasses_[node] = held ? 0.0 : 1.0 / network_.masses[node];
    if (held && !network_.velocities[node].isZero(0.0)) carried_.push_back(static_cast<NodeIndex>(node));
  }
  arena_.execute([&] {
    controls_.moveTo(0.0);
    startTolerance();
    chooseStep();
    refreshContacts();
    fittedVersion_ = fragments_.activity().version();
    ledger_.begin(drawLedger(present()), keptEnergy().energy);
  });
}

double Stepper::kick() const {
  return settings_.method == Method::velocityVerlet ? 0.5 * (lastStep_ + step_) : wantedStep_;
}

Contacts::Moment Stepper::moment() const {
  return {now_,
          controls_.colliders(),
          controls_.materials(),
          kick(),
          0.0,
          fragments_.activity().movedLanes(),
          fragments_.activity().version(),
          controls_.scalesStiffness()};
}

/// Tracks change the world at fixed positions; what that does to the energy is work from outside. The half
/// kick that ends at this moment belongs to the world as it was.
void Stepper::applyControls() {
  controlsTime_ = time();
  if (controlsTime_ < controls_.constantUntil()) return;
  const Vec3 gravityBefore = controls_.gravity();
  Controls ahead = controls_;
  const Controls::Change change = ahead.moveTo(controlsTime_);
  const bool energyChanges = change.stiffness || change.leap || (change.colliders && switchingPushes(ahead));
  if (energyChanges) {
    fragments_.wakeEverything(time());
    fragments_.meltEverything(time());
    fitReference();
    finishKick();
  }
  const double before = energyChanges ? potentialEnergy() : 0.0;
  controls_ = std::move(ahead);
  if (!change.any()) return;
  startKnown_ = false;
  contacts_.moveColliders(controls_.colliderTravel());
  if (change.colliders) contacts_.changeColliders();
  if (energyChanges || change.colliders) refreshContacts();
  if (energyChanges) {
    ledger_.addOutsideWork(potentialEnergy() - before);
    ledger_.forgetKept();
    chooseStep();
  }
  if (change.gravity) {
    fragments_.wakeEverything(time());
    fragments_.placeBodies();
    ledger_.addOutsideWork(ledger_.gravityWork(now_.position, gravityBefore, controls_.gravity()));
    shiftKick(gravityBefore);
  }
  fragments_.noteColliders(time());
}

/// Some node is inside a collider that begins or ceases to act now.
bool Stepper::switchingPushes(const Controls& ahead) {
  fragments_.placeBodies();
  for (std::size_t c = 0; c < controls_.colliders().size(); ++c) {
    const MovingCollider& before = controls_.colliders()[c];
    const MovingCollider& after = ahead.colliders()[c];
    if (before.active == after.active) continue;
    const Collider& collider = (after.active ? after : before).shape;
    for (NodeIndex node = 0; node < network_.nodeCount(); ++node) {
      if (intrusion(collider, now_.position.get(node)).depth > 0.0) return true;
    }
  }
  return false;
}

void Stepper::refreshContacts() {
  if (!contacts_.stale()) {
    if (contacts_.choiceIsOld()) chooseStep();
    return;
  }
  fragments_.placeBodies();
  contacts_.rebuild(now_, components_, breakage_, controls_.colliders(), step_ * fastestNow());
  ++work_.neighbourLists;
  work_.contactSearches = contacts_.searches();
  fragments_.noteNewRows(time());
  startKnown_ = false;
  chooseStep();
}

/// cm/s; zero where all is still.
double Stepper::fastestNow() const {
  double squared = 0.0;
  for (NodeIndex node = 0; node < network_.nodeCount(); ++node)
    squared = std::max(squared, now_.velocity.get(node).squaredNorm());
  return std::max(std::sqrt(squared), fragments_.fastestBody());
}

void Stepper::chooseStep() {
  contacts_.noteChoice();
  latticeCounts_ = latticeMoves();
  const Contacts::Stiffest stiffest = contacts_.stiffest(moment(), forces_);
  const Stiffening stiffening{latticeStiffness(), controls_.largestDampingScale(), stiffest.rateSquared,
                              stiffest.damping};
  if (settings_.step) {
    want(partOfFixedStep(stiffening));
    return;
  }
  const double stable = automaticStep(spectrum_, stiffening, settings_.method, settings_.safety);
  const double wanted = std::min({stable, kLongest, latticeCounts_ ? toleratedStep_ : kLongest,
                                  contacts_.longestTravel() / fastestNow()});
  if (wantedStep_ == 0.0 || wanted < wantedStep_ || wanted > kStepGrowth * wantedStep_) want(wanted);
}

/// The fixed step, or an equal part of it while contacts or a track make the scene too stiff for the whole.
double Stepper::partOfFixedStep(const Stiffening& stiffening) {
  const double step = *settings_.step;
  if (isImplicit(settings_.method)) return step;
  const Stiffening untouched{stiffening.stiffnessScale, stiffening.dampingScale};
  longestStep_ = stableStep(spectrum_, untouched, settings_.method, 1.0);
  const double longest = stableStep(spectrum_, stiffening, settings_.method, 1.0);
  if (step <= longest) return step;
  if (!(longest > 0.0)) return 0.0;
  constexpr double kSafetyOfParts = 0.9;
  return step / std::ceil(step / (kSafetyOfParts * longest));
}

/// Relative to the network's own.
double Stepper::latticeStiffness() const {
  return (latticeCounts_ ? 1.0 : kStillLattice) * controls_.largestStiffnessScale();
}

StepLimit Stepper::stepLimit() const {
  if (settings_.step) return StepLimit::fixed;
  if (latticeCounts_ && step_ >= toleratedStep_) return StepLimit::tolerance;
  const Stiffening alone{latticeStiffness(), controls_.largestDampingScale(), 0.0, 0.0};
  const double lattice = automaticStep(spectrum_, alone, settings_.method, settings_.safety);
  if (kStepGrowth * step_ >= lattice) return StepLimit::lattice;
  return kStepGrowth * step_ < kLongest ? StepLimit::contact : StepLimit::none;
}

/// Some bond is evaluated.
bool Stepper::latticeMoves() const {
  return network_.bondCount() > breakage_.brokenBondCount() + fragments_.bondsIn(FragmentState::rigid) +
                                    fragments_.bondsIn(FragmentState::asleep);
}

void Stepper::want(double step) {
  if (step != wantedStep_) startKnown_ = false;  // friction knows how long it acts
  wantedStep_ = step;
  // What a one-step method has just done was done in the step that it was done in.
  if (!oneStep_ || step_ == 0.0) setStep(step);
}

void Stepper::setStep(double step) {
  if (step == step_) return;
  segmentStart_ = time();
  segmentSteps_ = 0;
  step_ = step;
  controls_.setFlow(network_, step);
}

KernelStep Stepper::kernelStep(const Motion& from, Motion& to) const {
  KernelStep step{};
  layout_.describe(step);
  for (std::size_t k = 0; k < 3; ++k) {
    step.now.position[k] = from.position.axis(k);
    step.now.velocity[k] = from.velocity.axis(k);
    step.nextPosition[k] = to.position.size() > 0 ? to.position.axis(k) : nullptr;
    step.nextVelocity[k] = to.velocity.size() > 0 ? to.velocity.axis(k) : nullptr;
    // Empty until something touched; not read then.
    step.external[k] = forces_.total.axis(k);
    step.externalLossy[k] = forces_.lossy.axis(k);
    step.gravity[k] = controls_.gravity()[static_cast<Eigen::Index>(k)];
  }
  step.inverseMass = inverseMasses_.data();
  step.awake = fragments_.activity().awakeLanes().data();
  step.hasExternal = forces_.touched.data();
  step.materials = controls_.materials().data();
  return step;
}

/// Calls run(firstBlock, lastBlock) for all runs of blocks that deform.
template <class Run>
void Stepper::forActiveBlocks(const Run& run) const {
  const std::span<const std::uint32_t> blocks = fragments_.activity().activeBlocks();
  const auto runRange = [&](std::size_t begin, std::size_t end) {
    while (begin < end) {
      std::size_t next = begin + 1;
      while (next < end && blocks[next] == blocks[next - 1] + 1) ++next;
      run(blocks[begin], blocks[next - 1] + 1);
      begin = next;
    }
  };
  if (blocks.size() <= kBlockGrain) {
    runRange(0, blocks.size());
  } else {
    parallelRanges(blocks.size(), kBlockGrain, Sharing::even, runRange);
  }
}

void Stepper::runKernel(const KernelStep& step, std::vector<BlockReport>& reports, bool goesOn) const {
  if (!reference_) {
    forActiveBlocks([&](std::size_t first, std::size_t last) { kernel_(step, first, last, reports.data()); });
    return;
  }
  const FloatReference reference = reference_->describe(layout_, goesOn);
  KernelStep inFloat = step;
  inFloat.reference = &reference;
  if (!reference_->displaced() || step.now.position[0] != now_.position.axis(0)) {
    reference_->forgetDisplacements();
    forActiveBlocks(
        [&](std::size_t first, std::size_t last) { floatKernel_.displaceBlocks(inFloat, first, last); });
  }
  forActiveBlocks([&](std::size_t first, std::size_t last) {
    floatKernel_.stepBlocks(inFloat, first, last, reports.data());
  });
  if (goesOn) reference_->noteStepped();
}

/// At the end of a step, from what a checkpoint holds: a resumed run fits when this one does.
void Stepper::fitReference() {
  const std::uint64_t version = fragments_.activity().version();
  if (!reference_) return;
  if (work_.steps % ReferenceFrames::kStepsPerFit != 0 && version == fittedVersion_) return;
  fittedVersion_ = version;
  reference_->fit(now_.position, fragments_.activity());
}

bool Stepper::skipsFragments() const {
  return isLeapfrog(settings_.method) && (settings_.skip.sleep || settings_.skip.rigid);
}

/// Forces at the beginning of the step, and the move they make; afterwards next_ holds the state before.
Result<double> Stepper::moveByLeapfrog() {
  if (contacts_.quiet() || (fragments_.noneDeforms() && !fragments_.anyTouched())) {
    Contacts::clear(forces_);
  } else {
    const Contacts::ColliderWork work = contacts_.computeForces(moment(), forces_);
    contacts_.settle(now_);
    ledger_.addOutsideWork(work.outside);
    ledger_.addDissipated(work.dissipated);
    work_.contactPairs += contacts_.pairCount();
    stopAtColliders();
  }
  ledger_.addDissipated(
      fragments_.moveBodies(kick(), step_, settings_.method == Method::forwardEuler, forces_));
  double travel = fragments_.fastestBody() * step_;
  if (fragments_.noneDeforms()) {
    fragments_.placeTouched();
    return travel;
  }
  ledger_.addOutsideWork(carryingWork(now_, forces_, kick()));
  KernelStep step = kernelStep(now_, next_);
  step.kick = kick();
  step.drift = step_;
  step.driftByOldVelocity = settings_.method == Method::forwardEuler;
  step.flowing = true;
  runKernel(step, reports_, true);
  const Status healthy = readReports(travel);
  if (!healthy) return healthy.problem();
  std::swap(now_, next_);
  fragments_.placeTouched();
  return travel;
}

void Stepper::countWork() {
  const std::uint64_t rigid = fragments_.bondsIn(FragmentState::rigid);
  const std::uint64_t asleep = fragments_.bondsIn(FragmentState::asleep);
  const std::uint64_t skipped = breakage_.brokenBondCount() + rigid + asleep;
  ++work_.steps;
  if (!oneStep_) work_.bondsEvaluated += network_.bondCount() - skipped;  // the others count where they look
  work_.bondsSkipped += skipped;
  work_.bondsRigid += rigid;
  work_.bondsAsleep += asleep;
  if (fragments_.noneDeforms()) ++work_.stepsRigid;
  work_.bondsUntested += layout_.untestedBonds();
  work_.bondsUndamped += layout_.undampedBonds();
}

Status Stepper::stepInArena() {
  if (!(wantedStep_ > 0.0)) {
    return Problem{"t = " + std::to_string(time()) + " s",
                   "no step is stable any more: forward Euler gains energy wherever a bond has no damping",
                   "choose velocity-verlet, or keep the damping's track above zero"};
  }
  const bool moving = !fragments_.noneDeforms() || fragments_.anyTouched();
  const Result<double> travel = oneStep_ ? moveByOneStep() : moveByLeapfrog();
  if (!travel) return travel.problem();
  if (!oneStep_) lookAtLeapfrogError(kick());
  countWork();
  lastStep_ = step_;
  ++segmentSteps_;
  if (contacts_.looksAfter(*travel)) fragments_.placeBodies();
  contacts_.age(now_, *travel);
  if (moving) breakOverstretched();
  if (moving && !settings_.skip.labelling) {
    components_.labelAgain(layout_);
    work_.labelings = components_.relabelings();
    work_.labelingsSkipped = 0;
  }
  applyControls();
  refreshContacts();
  followTolerance();
  if (moving && skipsFragments() && work_.steps % FragmentStates::kStepsPerReview == 0)
    fragments_.review(time(), step_);
  meltStopped();
  if (latticeMoves() != latticeCounts_) chooseStep();
  fitReference();
  if (moving && (!settings_.skip.ledger || work_.steps % kStepsPerLedger == 0)) return watchEnergy();
  ++work_.ledgersSkipped;
  return Done{};
}

/// Where all sleep, nothing happens until a track says otherwise: the clock moves on by itself, to the same
/// step that stepping would have ended on.
void Stepper::sleepUntil(double until) {
  if (!fragments_.allAsleep() || contacts_.looksAfter(0.0)) return;
  const double end = std::min(until, controls_.constantUntil());
  const double steps = std::floor((end - time()) / step_) - 2.0;
  if (!(steps >= 1.0)) return;
  // The last few steps are taken one by one, so that rounding cannot take one too many.
  const auto count = static_cast<std::uint64_t>(std::min(steps, 1e15));
  segmentSteps_ += count;
  lastStep_ = step_;
  work_.steps += count;
  work_.stepsRigid += count;
  work_.bondsSkipped += count * network_.bondCount();
  work_.bondsAsleep += count * fragments_.bondsIn(FragmentState::asleep);
}

Status Stepper::readReports(double& travel) {
  double fastest = 0.0;  // squared
  double dissipated = 0.0;
  for (const std::uint32_t block : fragments_.activity().activeBlocks()) {
    const BlockReport& report = reports_[block];
    dissipated += report.dissipated;
    if (!(report.largestSpeedSquared <= fastest)) fastest = report.largestSpeedSquared;
    if (!(report.largestSpeedSquared < kLightSpeedSquared)) return blowUp("is faster than light");
  }
  ledger_.addDissipated(dissipated);
  travel = std::max(travel, std::sqrt(fastest) * step_);
  return Done{};
}

/// Names the fastest node, or the first whose motion is not finite, of the step being written.
Problem Stepper::blowUp(const char* what) const {
  NodeIndex worst = 0;
  double fastest = -1.0;
  for (NodeIndex node = 0; node < network_.nodeCount(); ++node) {
    const double speed = next_.velocity.get(node).norm();
    if (speed <= fastest) continue;
    worst = node;
    fastest = speed;
    if (!std::isfinite(speed)) break;
  }
  const std::string& part = network_.partNames[network_.nodeParts[worst]];
  const std::string& material = network_.materials[network_.nodeMaterials[worst]].name;
  return {"t = " + std::to_string(time()) + " s",
          "the motion blew up: node " + std::to_string(worst) + " of part '" + part + "' (material '" +
              material + "') " + what,
          "take a smaller step, or leave the step automatic"};
}

Status Stepper::watchEnergy() {
  fragments_.placeBodies();
  const Kept kept = keptEnergy();
  if (ledger_.watch(kept.row, kept.energy)) return Done{};
  return blowUp("is the fastest, and there is far more energy than there was to have");
}

Status Stepper::stepOnce() {
  return arena_.execute([&] { return stepInArena(); });
}

Status Stepper::advanceTo(double until) {
  return arena_.execute([&]() -> Status {
    while (time() < until - kTimeSlack * step_) {
      sleepUntil(until);
      if (const Status status = stepInArena(); !status) return status;
    }
    return Done{};
  });
}

}  // namespace sim
