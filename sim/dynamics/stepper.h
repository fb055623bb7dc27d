#pragma once

#include <limits>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "sim/control/controls.h"
#include "sim/dynamics/methods/one_step_method.h"
#include "sim/dynamics/reference_frames.h"
#include "sim/dynamics/simulation.h"
#include "sim/dynamics/stable_step.h"
#include "sim/skipping/fragment_states.h"
#include "sim/state/ledger.h"

namespace sim {

/// The inside of Simulation: one step after the other.
///
/// The methods of the leapfrog family are one recurrence, v' = v + kick a(x, v), x' = x + drift w
/// (bond_kernel.h):
/// - velocity Verlet as leapfrog: v is half a step behind x (Motion), kick is half the last step plus half
/// the next (zero at
///   the start), w = v'. The velocity at the time of x is v + half the last step times a, computed only where
///   it is shown, so that looking never changes the motion. It is the same trajectory as kick-drift-kick
///   (LAMMPS fix nve), with dampers and friction acting on the half-step velocity as there.
/// - symplectic Euler: kick = dt, w = v'.
/// - forward Euler exactly as printed (paper, "Dynamics"; P7): kick = dt, w = v, the old velocity.
/// The others are a OneStepMethod each, with x and v of the same moment.
///
/// Order within a step: contact forces; kernel (forces of bonds, move); then bonds that were overstretched at
/// the step's beginning break (one-step methods: at its end, which is where the first of them breaks), their
/// cells with them, and fragments are relabelled; then tracks make the
/// world that of the new moment, and contact rows are rebuilt, if stale. So between steps all is of one
/// moment, but for the half kick.
class Stepper {
 public:
  Stepper(Network network, Environment environment, std::vector<Track> tracks, const Settings& settings);
  // Its parts point at each other.
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;

  Status advanceTo(double until);
  Status stepOnce();
  /// See Simulation::replan(); the arguments have been checked.
  void replan(Environment environment, std::vector<Track> tracks) {
    controls_.replan(std::move(environment), std::move(tracks));
  }
  const Controls& controls() const { return controls_; }

  double time() const { return segmentStart_ + static_cast<double>(segmentSteps_) * step_; }
  double step() const { return step_; }
  StepLimit stepLimit() const;
  const Network& network() const { return network_; }
  const Work& work() const { return work_; }
  const Breakage& breakage() const { return breakage_; }
  const Components& components() const { return components_; }
  const FragmentStates& fragments() const { return fragments_; }
  /// All of this moment; to be called before positions are looked at.
  void placeAll() { fragments_.placeBodies(); }
  const NodeVectors& positions() const { return now_.position; }
  double maxRise() const { return ledger_.maxRise(); }
  std::vector<BreakEvent> drainEvents() { return std::exchange(events_, {}); }

  /// The moment of the positions: for Verlet half a kick ahead of what is stored.
  struct Present {
    NodeVectors velocity;
    double dissipated = 0.0;   ///< erg, within that half kick
    double outsideWork = 0.0;  ///< erg, likewise
  };
  Present present() const;
  /// s: the longest fixed step that is stable where nothing touches.
  double longestStep() const { return longestStep_; }
  LedgerRow drawLedger(const Present& present) const;
  std::uint64_t stateHash() const;

  std::vector<std::byte> checkpoint() const;
  Status restore(std::span<const std::byte> checkpoint);
  /// See Simulation::takeOver(); the networks are equal.
  void takeOver(Stepper& other);
  std::size_t memoryBytes() const;

 private:
  Status stepInArena();
  /// Moves now_ one step on; gives how far a node went at most, cm.
  Result<double> moveByLeapfrog();
  // Colliders that nodes do not get through (stepper_stops.cpp).
  struct StopForce {
    Vec3 force = Vec3::Zero();  ///< dyn
    double work = 0.0;          ///< erg, of moving colliders
    bool melts = false;         ///< instead, the rigid piece is to deform
  };
  Vec3 velocityAhead(NodeIndex node) const;
  bool movesByItself(NodeIndex node) const;
  StopForce stopForce(const Contacts::NearCollider& near) const;
  bool runsIntoStop(const Contacts::NearCollider& near) const;
  void stopAtColliders();
  void meltStopped();
  bool stopTrial(const Rates& atEnd, double length);
  // One-step methods (stepper_one_step.cpp).
  class TrialWorld;
  Result<double> moveByOneStep();
  void ratesAt(const Motion& at, double ahead, Rates& rates);
  void tangentsAt(const Motion& at, double ahead, std::vector<Tangent>& tangents) const;
  void makeStartKnown();
  void flowPlastically();
  double worstExcess(std::span<const Breakage::Overstretched> bonds, const Motion& motion) const;
  std::optional<OneStepMethod::Flow> tryStep(double& length);
  OneStepMethod::Flow locateBreak(std::span<const Breakage::Overstretched> bonds, OneStepMethod::Flow flow,
                                  double& length);
  Status checkSpeeds(double& fastest) const;

  void adoptState(const Stepper& other);
  void bringToPresent();
  void layOut(std::span<const std::uint8_t> brokenBonds, std::span<const double> restLengths);
  void applyControls();
  bool switchingPushes(const Controls& ahead);
  void refreshContacts();
  void finishKick();
  void shiftKick(const Vec3& gravityBefore);
  bool skipsFragments() const;
  void sleepUntil(double until);
  void countWork();
  Present presentBy(Contacts::Forces& forces, double halfKick) const;
  double halfKick() const;
  /// The account at a moment, and the mechanical energy that the method keeps then, erg.
  struct Kept {
    LedgerRow row;
    double energy = 0.0;
  };
  Kept keptEnergy() const;
  double elasticEnergyNow() const;
  double carryingWork(const Motion& at, const Contacts::Forces& forces, double kick) const;
  Vec3 bondForce(const Motion& at, NodeIndex node, NodeIndex neighbour) const;
  double latticeStiffness() const;
  void chooseStep();
  double partOfFixedStep(const Stiffening& stiffening);
  bool latticeMoves() const;
  // The step that keeps to a tolerance (stepper_tolerance.cpp).
  double stiffestRate() const;
  double shortestStep() const;
  void startTolerance();
  double strainErrorPerSwing(const NodeVectors& error, double length);
  double longestTolerated(const NodeVectors& error, double length, int errorPower);
  void aimFor(double longest, double elapsed);
  void lookAtLeapfrogError(double kick);
  bool tolerates(double& length);
  void followTolerance();
  double fastestNow() const;
  /// Of the next step, s: of this very one for methods that can change it at any time.
  void want(double step);
  void setStep(double step);
  /// s: how long this step's forces act on the velocities.
  double kick() const;
  /// Of the lanes that deform.
  KernelStep kernelStep(const Motion& from, Motion& to) const;
  /// `goesOn`: the state that the step leads to will be now_.
  void runKernel(const KernelStep& step, std::vector<BlockReport>& reports, bool goesOn = false) const;
  template <class Run>
  void forActiveBlocks(const Run& run) const;
  void fitReference();
  /// Sums the blocks' reports; a Problem when a speed is not finite.
  Status readReports(double& travel);
  void breakOverstretched();
  std::vector<Breakage::Overstretched> findOverstretched(const Motion& motion) const;
  void testBlock(const Motion& motion, std::size_t block, std::vector<Breakage::Overstretched>& found) const;
  double strainIn(const Motion& motion, BondIndex bond) const;
  double strainIn(const Motion& motion, BondIndex bond, NodeIndex start) const;
  /// The state in which bonds that have just been found break: of one-step methods, the present one.
  const Motion& breakingMotion() const { return oneStep_ ? now_ : next_; }
  void loseBond(const BreakEvent& event);
  Status watchEnergy();
  Problem blowUp(const char* what) const;
  Contacts::Moment moment() const;
  double potentialEnergy() const;

  Network network_;
  Settings settings_;
  Spectrum spectrum_;
  BondLayout layout_;
  Breakage breakage_;
  Components components_;
  Contacts contacts_;
  Controls controls_;
  Ledger ledger_;
  StepBlocks kernel_;
  FloatKernel floatKernel_;

  Motion now_;   ///< nodes of rigid bodies are where placeBodies() last put them
  Motion next_;  ///< where the step is written; afterwards, the state before it
  AlignedVector<double> inverseMasses_;
  FragmentStates fragments_;
  /// None: forces are double. Its scratch is written wherever forces are computed.
  std::unique_ptr<ReferenceFrames> reference_;
  std::vector<NodeIndex> carried_;   ///< held nodes that move
  std::vector<FragmentId> stopped_;  ///< rigid ones that are to deform from the next step on
  Contacts::Forces forces_;
  std::vector<BlockReport> reports_;
  std::unique_ptr<OneStepMethod> oneStep_;  ///< none: the method is of the leapfrog family
  Rates startRates_;                        ///< of now_, if they are known; one-step methods only
  Rates endRates_;                          ///< of where a step ended
  bool startKnown_ = false;
  std::vector<BreakEvent> events_;
  Work work_;

  double segmentStart_ = 0.0;  ///< s: when the present step size began
  std::uint64_t segmentSteps_ = 0;
  double step_ = 0.0;  ///< s
  /// s: the next step, unless a break cuts it short; of the leapfrog family, step_
  double wantedStep_ = 0.0;
  /// s: see longestStep()
  double longestStep_ = std::numeric_limits<double>::infinity();
  double lastStep_ = 0.0;            ///< s: of the step before; zero at the start
  std::uint64_t fittedVersion_ = 0;  ///< of the activity, at the last fit of the reference
  bool latticeCounts_ = true;        ///< in the choice of the step
  static constexpr double kAnyStep = 1.0;
  double toleratedStep_ = kAnyStep;  ///< s: the longest that keeps to the tolerance, as far as it is known
  double largestStrain_ = 0.0;       ///< rms over bonds, the largest so far; with a tolerance only
  double controlsTime_ = 0.0;        ///< s: when the tracks were last applied
  std::optional<tbb::global_control> moreThreads_;  ///< TBB would not give more than the processor has
  mutable tbb::task_arena arena_;
};

}  // namespace sim
