#include "sim/dynamics/stepper.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/dynamics/checkpoint.h"
#include "sim/passes/collider_stops.h"
#include "sim/passes/health.h"
#include "sim/skipping/bodies.h"
#include "sim/skipping/review.h"
#include "sim/skipping/sleeping.h"
#include "sim/skipping/transitions.h"
#include "sim/world/forces.h"

namespace sim {
namespace {

/// Energy is drawn up this often: a few per cent of a step's cost each time.
constexpr std::uint64_t kStepsPerLedger = 64;
/// With a tolerance the step may grow this often.
constexpr std::uint64_t kStepsPerGrowth = 16;
/// Where turns lie on each other, so many nodes push one: those around its place in the turn above and in the
/// one below.
constexpr double kTouchInCoil = 8.0;
/// Frames are due when the time is within this share of a step.
constexpr double kTimeSlack = 1e-6;

std::optional<tbb::global_control> allowThreads(int threads) {
  if (threads <= tbb::this_task_arena::max_concurrency()) return std::nullopt;
  return std::optional<tbb::global_control>(std::in_place, tbb::global_control::max_allowed_parallelism,
                                            static_cast<std::size_t>(threads));
}

/// Some node is inside a collider that begins or ceases to act now.
bool switchingPushes(World& world, const Controls& ahead) {
  placeBodies(world);
  for (std::size_t c = 0; c < world.controls.colliders().size(); ++c) {
    const MovingCollider& before = world.controls.colliders()[c];
    const MovingCollider& after = ahead.colliders()[c];
    if (before.active == after.active) continue;
    const Collider& collider = (after.active ? after : before).shape;
    for (NodeIndex node = 0; node < world.network.nodeCount(); ++node) {
      if (intrusion(collider, world.now.position.get(node)).depth > 0.0) return true;
    }
  }
  return false;
}

bool skipsFragments(const Settings& settings) {
  return isLeapfrog(settings.method) && (settings.skip.sleep || settings.skip.rigid);
}

}  // namespace

Stepper::Stepper(Network network, Environment environment, std::vector<Track> tracks,
                 const Settings& settings)
    : world_(std::move(network), std::move(environment), std::move(tracks), settings),
      length_(settings, measureSpectrum(world_.network)),
      integrator_(recordOf(settings.method).make(world_)),
      moreThreads_(allowThreads(settings.threads)),
      arena_(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic) {
  arena_.execute([&] {
    beginSkipping(world_);
    world_.controls.moveTo(0.0);
    if (length_.hasTolerance() && integrator_->stepsAsWanted())
      length_.beginSurely(world_.controls.largestStiffnessScale());
    chooseStep();
    refreshContacts();
    world_.ledger.begin(drawAccount(world_, integrator_->present(world_)),
                        integrator_->keptEnergy(world_).energy);
  });
}

/// The order of a step. Between steps everything is of one moment, but for the half kick of leapfrog methods.
Status Stepper::makeStep() {
  if (!(world_.clock.wanted > 0.0)) {
    return Problem{"t = " + std::to_string(world_.time()) + " s",
                   "no step is stable any more: forward Euler gains energy wherever a bond has no damping",
                   "choose velocity-verlet, or keep the damping's track above zero"};
  }
  const bool moving = !world_.fragments.noneDeforms() || anyTouched(world_);
  // Forces act, and nodes move.
  const Result<double> travel = integrator_->advance(world_, length_);
  if (!travel) return travel.problem();
  countWork();
  world_.clock.tick();
  // Contact rows cover what can touch until something has travelled too far.
  if (world_.contacts.age().looksAfter(*travel)) placeBodies(world_);
  world_.contacts.ageByStep(world_.now, *travel);
  // What is overstretched breaks, and what no longer hangs together becomes fragments.
  if (moving && breakOverstretched(world_, integrator_->breakingMoment(world_))) integrator_->forgetForces();
  // The world becomes that of the new moment.
  applyTracks();
  refreshContacts();
  followTolerance();
  // What need not be computed is put aside, and what must be is taken up again.
  if (moving && skipsFragments(world_.settings) && world_.work.steps % kStepsPerReview == 0)
    reviewFragments(world_);
  meltStopped(world_);
  if (latticeMoves(world_) != length_.countsLattice()) chooseStep();
  // The account of energy is drawn up now and then.
  if (moving && world_.work.steps % kStepsPerLedger == 0) return watchEnergy();
  ++world_.work.ledgersSkipped;
  return Done{};
}

void Stepper::countWork() {
  const std::uint64_t rigid = world_.fragments.bondsIn(FragmentState::rigid);
  const std::uint64_t asleep = world_.fragments.bondsIn(FragmentState::asleep);
  const std::uint64_t skipped = world_.breakage.brokenBondCount() + rigid + asleep;
  Work& work = world_.work;
  ++work.steps;
  // Methods that ask for forces several times a step count where they ask.
  if (isLeapfrog(world_.settings.method)) work.bondsEvaluated += world_.network.bondCount() - skipped;
  work.bondsSkipped += skipped;
  work.bondsRigid += rigid;
  work.bondsAsleep += asleep;
  if (world_.fragments.noneDeforms()) ++work.stepsRigid;
  work.bondsUntested += world_.layout.untestedBonds();
  work.bondsUndamped += world_.layout.undampedBonds();
}

/// Where all sleep, nothing happens until a track says otherwise: the clock moves on by itself, to the same
/// step that stepping would have ended on.
void Stepper::sleepUntil(double until) {
  if (!world_.fragments.allAsleep() || world_.contacts.age().looksAfter(0.0)) return;
  const double end = std::min(until, world_.controls.constantUntil());
  const double steps = std::floor((end - world_.time()) / world_.clock.step) - 2.0;
  if (!(steps >= 1.0)) return;
  // The last few steps are taken one by one, so that rounding cannot take one too many.
  const auto count = static_cast<std::uint64_t>(std::min(steps, 1e15));
  world_.clock.segmentSteps += count;
  world_.clock.last = world_.clock.step;
  world_.work.steps += count;
  world_.work.stepsRigid += count;
  world_.work.bondsSkipped += count * world_.network.bondCount();
  world_.work.bondsAsleep += count * world_.fragments.bondsIn(FragmentState::asleep);
}

/// Tracks change the world at fixed positions; what that does to the energy is work from outside. The half
/// kick that ends at this moment belongs to the world as it was.
void Stepper::applyTracks() {
  world_.controlsTime = world_.time();
  if (world_.controlsTime < world_.controls.constantUntil()) return;
  const Vec3 gravityBefore = world_.controls.gravity();
  const std::vector<MovingCollider> collidersBefore = world_.controls.colliders();
  Controls ahead = world_.controls;
  const Controls::Change change = ahead.moveTo(world_.controlsTime);
  const bool energyChanges =
      change.stiffness || change.leap || (change.colliders && switchingPushes(world_, ahead));
  if (energyChanges) bringToPresent();
  const double before = energyChanges ? potentialEnergy(world_) : 0.0;
  world_.controls = std::move(ahead);
  if (!change.any()) return;
  integrator_->forgetForces();
  world_.contacts.age().moveColliders(world_.controls.colliderTravel());
  if (change.colliders || change.leap) world_.contacts.beginAmong(collidersBefore);
  if (energyChanges || change.colliders) refreshContacts();
  if (energyChanges) {
    world_.ledger.addOutsideWork(potentialEnergy(world_) - before);
    world_.ledger.forgetKept();
    chooseStep();
  }
  if (change.gravity) {
    wakeEverything(world_, world_.time());
    placeBodies(world_);
    world_.ledger.addOutsideWork(
        world_.ledger.gravityWork(world_.now.position, gravityBefore, world_.controls.gravity()));
    integrator_->shiftKick(world_, gravityBefore);
  }
  wakeByColliders(world_, world_.time());
}

/// Everything deforms, and positions and velocities are of one moment.
void Stepper::bringToPresent() {
  wakeEverything(world_, world_.time());
  meltEverything(world_, world_.time());
  integrator_->finishKick(world_);
}

void Stepper::refreshContacts() {
  RowAge& age = world_.contacts.age();
  if (!age.stale()) {
    if (age.choiceIsOld(world_.contacts.model())) chooseStep();
    return;
  }
  placeBodies(world_);
  world_.contacts.rebuild(world_.now, world_.components, world_.breakage, world_.controls.colliders(),
                          world_.time(), world_.clock.step * fastestSpeed(world_));
  ++world_.work.neighbourLists;
  world_.work.contactSearches = world_.contacts.searches();
  noteNewRows(world_);
  integrator_->forgetForces();
  chooseStep();
}

void Stepper::chooseStep() {
  world_.contacts.age().noteChoice();
  const Stiffest stiffest = stiffestNow();
  StepLength::Scene scene;
  scene.stiffnessScale = world_.controls.largestStiffnessScale();
  scene.dampingScale = world_.controls.largestDampingScale();
  scene.latticeMoves = latticeMoves(world_);
  scene.contactRateSquared = stiffest.rateSquared;
  scene.contactDamping = stiffest.damping;
  scene.speed = fastestSpeed(world_);
  scene.longestTravel = world_.contacts.age().longestTravel(world_.contacts.model());
  const double wanted = length_.choose(scene, world_.clock.wanted);
  // Friction knows how long it acts.
  if (wanted != world_.clock.wanted) integrator_->forgetForces();
  world_.clock.wanted = wanted;
  // What a one-step method has just done was done in the step that it was done in.
  if (integrator_->stepsAsWanted() || world_.clock.step == 0.0) setStep(world_, wanted);
}

/// Nothing is changed within a step.
void Stepper::followTolerance() {
  if (!length_.hasTolerance()) return;
  if (length_.exceeds(world_.clock.wanted) || world_.work.steps % kStepsPerGrowth == 0) chooseStep();
}

StepLimit Stepper::stepLimit() const {
  return length_.limit(world_.controls.largestStiffnessScale(), world_.controls.largestDampingScale(),
                       world_.clock.step);
}

Stiffest Stepper::stiffestNow() const {
  const ContactMoment moment = contactMoment(world_, integrator_->kick(world_.clock));
  return stiffestContacts(world_.contacts, moment, world_.forces);
}

Stiffest Stepper::stiffestCoil() const {
  const ContactModel& model = world_.contacts.model();
  Stiffest most;
  if (!model.settings().self) return most;
  for (NodeIndex node = 0; node < world_.network.nodeCount(); ++node) {
    const double mass = world_.network.masses[node];
    if (!std::isfinite(mass) || !model.maySpring(node, node)) continue;
    const PairConstants pair = model.constantsOf(node, {0.0, node, kNone});
    most.raise({2.0 * kTouchInCoil * pair.stiffness / mass, 2.0 * kTouchInCoil * pair.damping / mass});
  }
  return most;
}

double Stepper::stepAt(double time, double speed, bool deforms, const Stiffest& touching) const {
  Controls then = world_.controls;
  then.moveTo(time);
  StepLength::Scene scene;
  scene.stiffnessScale = then.largestStiffnessScale();
  scene.dampingScale = then.largestDampingScale();
  scene.latticeMoves = deforms;
  scene.contactRateSquared = touching.rateSquared;
  scene.contactDamping = touching.damping;
  scene.speed = speed;
  // Whether anything may touch is not known before the first step; where nothing is there to be touched, it
  // never is.
  if (!then.colliders().empty() || pairsAreCompared(world_.contacts.model(), world_.components))
    scene.longestTravel = RowAge::travelLimit(world_.contacts.model());
  StepLength length = length_;
  return length.choose(scene, 0.0);
}

Status Stepper::watchEnergy() {
  placeBodies(world_);
  const Integrator::Kept kept = integrator_->keptEnergy(world_);
  if (world_.ledger.watch(kept.row, kept.energy)) return Done{};
  return blowUp(world_, "is the fastest, and there is far more energy than there was to have");
}

Status Stepper::stepOnce() {
  return arena_.execute([&] { return makeStep(); });
}

Status Stepper::advanceTo(double until, const std::function<void()>& afterStep) {
  return arena_.execute([&]() -> Status {
    while (world_.time() < until - kTimeSlack * world_.clock.step) {
      sleepUntil(until);
      if (const Status status = makeStep(); !status) return status;
      if (afterStep) afterStep();
    }
    return Done{};
  });
}

Present Stepper::present() const {
  return arena_.execute([&] { return integrator_->present(world_); });
}

std::vector<std::byte> Stepper::checkpoint() const {
  return saveCheckpoint(world_, length_);
}

Status Stepper::restore(std::span<const std::byte> checkpoint) {
  const Status status = loadCheckpoint(checkpoint, world_, length_);
  if (status) integrator_->forgetForces();
  return status;
}

/// What depends on the other conditions is found anew: the step, who is near whom, what may be skipped. What
/// has happened to the network is taken over.
void Stepper::takeOver(Stepper& other) {
  assert(world_.work.steps == 0);
  double before = 0.0;
  other.arena_.execute([&] {
    other.bringToPresent();
    before = potentialEnergy(other.world_);
  });
  arena_.execute([&] {
    adoptState(other);
    world_.controlsTime = world_.time();
    world_.controls.moveTo(world_.controlsTime);
    if (length_.hasTolerance() && integrator_->stepsAsWanted())
      length_.beginSurely(world_.controls.largestStiffnessScale());
    world_.contacts.takeOver(other.world_.contacts, other.world_.controls.colliders());
    refreshContacts();
    world_.ledger.addOutsideWork(potentialEnergy(world_) - before);
    world_.ledger.addOutsideWork(world_.ledger.gravityWork(
        world_.now.position, other.world_.controls.gravity(), world_.controls.gravity()));
    world_.ledger.forgetKept();
  });
}

void Stepper::adoptState(const Stepper& other) {
  const World& from = other.world_;
  world_.now = from.now;
  world_.next = world_.now;
  world_.layout = layoutOf(world_.network, from.breakage.brokenBonds(), from.layout.plasticRestLengths());
  world_.breakage.restore(from.breakage.brokenBonds(), from.breakage.brokenCells());
  world_.components.restore(from.components.fragmentOfNode(), from.components.births(),
                            from.components.relabelings());
  restoreFragments(world_, {from.fragments.activity.states(), from.fragments.records,
                            from.fragments.neighbours, from.fragments.bodies, from.fragments.peakSpeed});
  world_.ledger.takeOver(from.ledger);
  world_.work = from.work;
  world_.clock = {.segmentStart = from.time()};
  length_.takeOver(other.length_);
  world_.forces.forgetRows();
  integrator_->forgetForces();
  world_.events.clear();
}

std::size_t Stepper::memoryBytes() const {
  return world_.memoryBytes() + integrator_->memoryBytes();
}

}  // namespace sim
