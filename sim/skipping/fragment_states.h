#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "sim/contact/contacts.h"
#include "sim/control/controls.h"
#include "sim/kernel/bond_layout.h"
#include "sim/skipping/activity.h"
#include "sim/skipping/rigid_body.h"
#include "sim/state/ledger.h"

namespace sim {

/// Decides which fragments deform, fly rigidly or sleep, and carries them from one state to another (B4;
/// docs/numerics.md, "What is skipped"). Raw networks, without cells, always deform: they are experiments
/// with springs. So does what is held.
///
/// - asleep: still for so long that it could have fallen, and everything heavy next to it is, too. It stands
///   where it is, with its strain, until something next to it moves that could move it, a collider next to it
///   moves, or gravity or a stiffness changes.
/// - rigid: strained by nothing to speak of, or for good and still. It moves as a RigidBody, pushed by gentle
///   contacts, until the contact rows, which cover all that can touch before they are built again, say that
///   something nears it too fast.
class FragmentStates {
 public:
  /// What it looks at and what it writes to. The stepper's own, which outlive this.
  struct World {
    const Network& network;
    const BondLayout& layout;
    const Breakage& breakage;
    const Components& components;
    const Contacts& contacts;
    const Controls& controls;
    Ledger& ledger;
    Motion& now;
    Motion& next;
    AlignedVector<double>& inverseMasses;
  };
  FragmentStates(const World& world, const SkipSettings& skip);

  const Activity& activity() const { return activity_; }
  /// Nothing at all moves, or will before something from outside does.
  bool allAsleep() const;
  bool noneDeforms() const { return activity_.activeBlocks().empty(); }

  /// Fragments were born at `time`.
  void noteBirths(double time);
  /// Looks who has come to rest and who flies freely. To be called every kStepsPerReview steps of `step`
  /// seconds, or more rarely.
  void review(double time, double step);
  /// Called whenever the contact rows are new.
  void noteNewRows(double time);
  /// Colliders have moved, or begun to act.
  void noteColliders(double time);
  /// Forces are about to change everywhere.
  void wakeEverything(double time);
  void meltEverything(double time);
  void melt(std::span<const FragmentId> fragments, double time);

  /// Carries the rigid bodies through a step: kicked by gravity and contacts for `kick`, moved for `drift`
  /// seconds. Takes what pushes their nodes out of the forces; returns the work against friction and contact
  /// damping, erg.
  double moveBodies(double kick, double drift, bool byOldVelocity, Contacts::Forces& forces);
  /// Some rigid body may be pushed.
  bool anyTouched() const;
  /// Puts the nodes that contacts may push where they are. After every step, and when rows are new.
  void placeTouched();
  void shiftVelocities(const Vec3& shift);
  /// No node of a rigid body is faster, cm/s.
  double fastestBody() const;
  /// Puts nodes of rigid bodies where they are; elsewhere they are where they were last put.
  void placeBodies();
  /// How the rigid bodies move with gravity and contacts for `kick` seconds more. Takes their forces out, and
  /// adds the work against friction and contact damping, erg.
  std::vector<RigidBody::Rates> ratesAfter(double kick, Contacts::Forces& forces, double& dissipated) const;
  void placeVelocities(NodeVectors& velocities, std::span<const RigidBody::Rates> rates) const;

  /// Whole bonds of fragments in that state.
  std::uint64_t bondsIn(FragmentState state) const { return bonds_[static_cast<std::size_t>(state)]; }
  /// Elastic energy of what does not deform, erg; `step` as for elasticEnergy().
  double stillElasticEnergy(KernelStep step) const;

  /// What a checkpoint holds of it.
  struct Saved;
  void save(ByteWriter& writer) const;
  /// False when it cannot have come from save() of such a network with so many fragments.
  static bool read(ByteReader& reader, std::size_t nodes, std::size_t fragments, Saved& saved);
  /// After everything else in the World was restored.
  void restore(Saved saved);
  /// The same, from where another one of the same network is, in which everything deforms.
  void takeOver(const FragmentStates& other);
  std::size_t memoryBytes() const;

  static constexpr std::uint64_t kStepsPerReview = 64;

 private:
  /// What happened to a fragment so far, the last of these.
  enum class Past : std::uint8_t { untouched, touched, broken };
  /// What is remembered of a fragment. Nothing is padding: checkpoints hold the bytes.
  struct Record {
    double stillSince = 0.0;       ///< s
    std::uint64_t bonds = 0;       ///< whole ones, while it does not deform
    std::uint16_t wait = 0;        ///< reviews until it is looked at again
    std::uint16_t quietLooks = 0;  ///< in a row, at which it was strained but still
    std::uint16_t lastWait = 0;
    std::uint8_t skippable = 0;
    Past past = Past::untouched;
  };
  /// Two fragments that may touch.
  struct Neighbours {
    FragmentId a = kNone;  ///< the lower
    FragmentId b = kNone;
    double approach = 0.0;  ///< cm/s: fastest of their nodes near each other, by their rigid motions

    bool samePair(const Neighbours& other) const { return a == other.a && b == other.b; }
    bool operator<(const Neighbours& other) const { return a != other.a ? a < other.a : b < other.b; }
  };
  /// How a fragment moves.
  struct Sums {
    double mass = 0.0;     ///< g
    double kinetic = 0.0;  ///< erg
    Vec3 centre = Vec3::Zero();
    Vec3 momentum = Vec3::Zero();                       ///< g cm/s
    Vec3 spin = Vec3::Zero();                           ///< angular velocity of the rigid motion, rad/s
    Vec3 angularMomentum = Vec3::Zero();                ///< about the centre, g cm^2/s
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre, g cm^2

    /// By the rigid motion, cm/s.
    Vec3 velocityAt(const Vec3& point) const { return momentum / mass + spin.cross(point - centre); }
    /// Squared root mean square speeds of the rigid motion and of the vibration beside it, cm^2/s^2.
    double rigidSpeedSquared() const;
    double vibrationSquared() const { return std::max(0.0, 2.0 * kinetic / mass - rigidSpeedSquared()); }
  };
  /// Of a fragment's whole bonds.
  struct Strains {
    double calm = 0.0;     ///< is nothing to speak of
    double largest = 0.0;  ///< of either sign
    bool mayGive = false;  ///< some bond yields, or is too near its threshold
    double sound = 0.0;    ///< cm/s: about two thirds of the speed of sound
    std::size_t bonds = 0;
  };
  struct RestLimits {
    double speed = 0.0;  ///< cm/s
    double time = 0.0;   ///< s
  };

  void findSkippable();
  RestLimits restLimits() const;
  std::vector<Sums> sumFragments();
  void noteNeighbours(const std::vector<Sums>& sums);
  void fallAsleep(const std::vector<Sums>& sums);
  bool flows(FragmentId fragment) const;
  void wakeByContact(const std::vector<Sums>& sums);
  void wakeLeftBehind(const std::vector<Sums>& sums);
  void wakeIfAsleep(FragmentId fragment);
  void freeze();
  Strains strainsOf(const RigidBody& body, Past past) const;
  bool vibratesBelow(const RigidBody& body, double speed) const;
  double calmSpeed(const RigidBody& body, Record& record) const;
  struct Push;
  static void findPush(const RigidBody& body, const Contacts::Forces& forces, Push& push);
  static double takeForces(const RigidBody& body, const Push& push, double kick,
                           const RigidBody::Rates& before, const RigidBody::Rates& after,
                           Contacts::Forces& forces);
  void noteTouching();
  void standStill(const RigidBody& body);
  static void waitLonger(Record& record);
  static double calmStrain(Past past);
  double strainOf(BondIndex bond) const;
  std::uint64_t wholeBonds(FragmentId fragment) const;
  void hold(std::span<const NodeIndex> nodes);
  void release(std::span<const NodeIndex> nodes);
  void setState(FragmentId fragment, FragmentState state);
  void putToSleep(FragmentId fragment, double kineticEnergy);
  void wake(FragmentId fragment);
  void makeRigid(RigidBody body);
  void melt(const RigidBody& body);
  void apply();

  World world_;
  SkipSettings skip_;
  Activity activity_;
  std::vector<Record> records_;  ///< by fragment
  std::vector<RigidBody> bodies_;
  std::vector<Neighbours> neighbours_;        ///< in the contact rows, ascending
  std::vector<Neighbours> neighboursBefore_;  ///< at the look before
  std::array<std::uint64_t, kFragmentStates> bonds_{};
  double typicalLength_ = 0.0;  ///< cm: mean distance of a node's nearest neighbour
  double peakSpeed_ = 0.0;      ///< cm/s: highest root mean square speed of everything so far
  double time_ = 0.0;           ///< s
  double reviewTime_ = 0.0;     ///< s: between two looks
  bool changed_ = false;
  mutable std::optional<double> stillElastic_;  ///< erg
};

struct FragmentStates::Saved {
  std::vector<FragmentState> states;
  std::vector<Record> records;
  std::vector<Neighbours> neighbours;
  std::vector<RigidBody> bodies;
  double peakSpeed = 0.0;
};

}  // namespace sim
