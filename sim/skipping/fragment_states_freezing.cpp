#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/skipping/fragment_states.h"

// Which fragments go on as rigid bodies, and which of those must deform again.

namespace sim {
namespace {

/// Strain that is nothing to speak of: this share of the bond's threshold, ...
constexpr double kCalmStrainShare = 0.25;
/// ... never more than can be seen in what is broken, ...
constexpr double kCalmStrainMost = 1e-2;
/// ... less in what never broke and may be meant to wobble, ...
constexpr double kWholeStrainMost = 5e-4;
/// ... and what never touched anything either may be meant to ring: it must be as good as undeformed.
constexpr double kUndeformed = 1e-9;
/// What is strained for good may be held as it is up to this share of a threshold: what is gentle adds less
/// than the rest.
constexpr double kHeldStrainShare = 0.7;
/// Of the square of its extent over its thickness and the speed of sound: half of a free plate's slowest
/// swing.
constexpr double kHalfSwing = 0.5;
/// Gentle is what nears slowly enough: 0.15 threshold times speed of sound, given kCalmStrainShare and the
/// two thirds of the speed of sound that calmSpeed() finds.
constexpr double kGentleShare = 0.9;
/// After a look in vain the next one waits twice as long, up to so many reviews.
constexpr std::uint32_t kLongestWait = 16;

}  // namespace

double FragmentStates::calmStrain(Past past) {
  if (past == Past::broken) return kCalmStrainMost;
  return past == Past::touched ? kWholeStrainMost : kUndeformed;
}

/// What has no strain to speak of goes on as a rigid body, unless something nears it too fast.
void FragmentStates::freeze() {
  for (RigidBody& body : bodies_) records_[body.fragment()].lastWait /= 2;
  for (FragmentId fragment = 0; fragment < records_.size(); ++fragment) {
    Record& record = records_[fragment];
    if (!activity_.deforms(fragment) || record.skippable == 0) continue;
    if (record.wait > 0) {
      --record.wait;
      continue;
    }
    RigidBody body(world_.network, fragment, activity_.nodesOf(fragment), world_.now);
    body.setGentleSpeed(calmSpeed(body, record));
    if (body.gentleSpeed() > 0.0) {
      makeRigid(std::move(body));
    } else if (record.quietLooks == 0) {
      waitLonger(record);
    }
  }
  noteTouching();
}

void FragmentStates::waitLonger(Record& record) {
  record.lastWait = static_cast<std::uint16_t>(std::clamp(2U * record.lastWait, 1U, kLongestWait));
  record.quietLooks = 0;
  record.wait = record.lastWait;
}

FragmentStates::Strains FragmentStates::strainsOf(const RigidBody& body, Past past) const {
  const Network& network = world_.network;
  Strains strains;
  strains.calm = calmStrain(past);
  double stiffness = 0.0;
  for (const NodeIndex node : body.nodes()) {
    for (BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      if (world_.breakage.bondBroken(bond)) continue;
      const BondClass& constants = network.bond(bond);
      const Material& material = network.materials[constants.material];
      const double threshold = network.thresholds[bond];
      const double strain = std::abs(strainOf(bond));
      strains.calm = std::min(
          strains.calm, std::isfinite(material.thresholdMean) ? kCalmStrainShare * threshold : kUndeformed);
      strains.largest = std::max(strains.largest, strain);
      if (strain > kHeldStrainShare * threshold || strain > material.yieldStrain) strains.mayGive = true;
      stiffness += constants.stiffness * constants.restLength * constants.restLength;
      ++strains.bonds;
    }
  }
  // Mean of k L^2 over mean mass: two thirds of the speed of sound, or a little less.
  if (strains.bonds > 0)
    strains.sound = std::sqrt(stiffness / static_cast<double>(strains.bonds) *
                              static_cast<double>(body.nodes().size()) / body.mass());
  return strains;
}

/// Vibration is strain a quarter of a swing later.
bool FragmentStates::vibratesBelow(const RigidBody& body, double speed) const {
  for (std::size_t i = 0; i < body.nodes().size(); ++i) {
    if (body.vibration(i, world_.now.velocity.get(body.nodes()[i])).norm() > speed) return false;
  }
  return true;
}

/// The speed at which what nears it is still gentle, cm/s; zero where its strain or its vibration is more
/// than nothing to speak of. What broke may be strained for good, by its broken bonds, which push inside it:
/// so if its strain is more, it must have been quiet for half of its slowest swing.
double FragmentStates::calmSpeed(const RigidBody& body, Record& record) const {
  const Strains strains = strainsOf(body, record.past);
  if (strains.bonds == 0) return std::numeric_limits<double>::infinity();
  const double quietSpeed = strains.calm * strains.sound;
  const bool strained = strains.largest > strains.calm;
  if (strains.mayGive || (strained && record.past != Past::broken) || !vibratesBelow(body, quietSpeed)) {
    record.quietLooks = 0;
    return 0.0;
  }
  if (strained) {
    const double extent = 2.0 * body.radius();
    const double halfSwing = kHalfSwing * extent * extent / (typicalLength_ * strains.sound);
    if (record.quietLooks < std::numeric_limits<std::uint16_t>::max()) ++record.quietLooks;
    if (static_cast<double>(record.quietLooks) * reviewTime_ < halfSwing) return 0.0;
  }
  return kGentleShare * quietSpeed;
}

/// Finds which nodes of rigid bodies may be pushed, and melts those bodies that are neared too fast.
void FragmentStates::noteTouching() {
  if (!skip_.rigid && bodies_.empty()) return;
  std::vector<std::vector<std::uint32_t>> touched(bodies_.size());
  std::vector<std::uint8_t> struck(bodies_.size(), 0);
  std::vector<std::uint32_t> bodyOf(records_.size(), kNone);
  std::vector<RigidBody::Rates> rates(bodies_.size());
  for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
    bodyOf[bodies_[b].fragment()] = b;
    rates[b] = bodies_[b].rates();
  }
  const auto velocityOf = [&](NodeIndex node) -> Vec3 {
    const std::uint32_t b = bodyOf[world_.components.of(node)];
    if (b == kNone) return world_.now.velocity.get(node);
    return rates[b].at(world_.now.position.get(node) - bodies_[b].centre());
  };
  const auto note = [&](NodeIndex node, const Vec3& towards, const Vec3& other) {
    Record& record = records_[world_.components.of(node)];
    if (record.past == Past::untouched) record.past = Past::touched;
    const std::uint32_t b = bodyOf[world_.components.of(node)];
    if (b == kNone) return;
    const auto place = std::ranges::lower_bound(bodies_[b].nodes(), node) - bodies_[b].nodes().begin();
    touched[b].push_back(static_cast<std::uint32_t>(place));
    if ((velocityOf(node) - other).dot(towards) > bodies_[b].gentleSpeed()) struck[b] = 1;
  };
  placeBodies();
  world_.contacts.forEachNearPair([&](NodeIndex i, NodeIndex j) {
    const Vec3 towards = (world_.now.position.get(j) - world_.now.position.get(i)).normalized();
    note(i, towards, velocityOf(j));
    note(j, -towards, velocityOf(i));
  });
  world_.contacts.forEachNearCollider([&](NodeIndex node, std::uint32_t collider) {
    const MovingCollider& moving = world_.controls.colliders()[collider];
    const Vec3 here = world_.now.position.get(node);
    note(node, -intrusion(moving.shape, here).normal, moving.velocityAt(here));
  });
  for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
    std::ranges::sort(touched[b]);
    touched[b].erase(std::ranges::unique(touched[b]).begin(), touched[b].end());
    standStill(bodies_[b]);
    bodies_[b].setTouched(std::move(touched[b]));
  }
  std::uint32_t b = 0;
  std::erase_if(bodies_, [&](const RigidBody& body) {
    if (struck[b++] == 0) return false;
    waitLonger(records_[body.fragment()]);
    melt(body);
    return true;
  });
  placeTouched();
}

/// Nodes that contacts no longer push stand in the lattice.
void FragmentStates::standStill(const RigidBody& body) {
  for (const std::uint32_t place : body.touched()) {
    world_.now.velocity.set(body.nodes()[place], Vec3::Zero());
    world_.next.velocity.set(body.nodes()[place], Vec3::Zero());
  }
}

void FragmentStates::makeRigid(RigidBody body) {
  double kinetic = -body.kineticEnergy();
  for (const NodeIndex node : body.nodes())
    kinetic += 0.5 * world_.network.masses[node] * world_.now.velocity.get(node).squaredNorm();
  world_.ledger.addDissipated(std::max(0.0, kinetic));
  hold(body.nodes());
  setState(body.fragment(), FragmentState::rigid);
  bodies_.push_back(std::move(body));
}

void FragmentStates::melt(const RigidBody& body) {
  body.place(world_.now.position);
  body.placeVelocities(world_.now.velocity);
  release(body.nodes());
  Record& record = records_[body.fragment()];
  record.stillSince = time_;
  setState(body.fragment(), FragmentState::deforming);
}

}  // namespace sim
