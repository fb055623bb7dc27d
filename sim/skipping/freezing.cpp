#include "sim/skipping/freezing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/skipping/bodies.h"
#include "sim/skipping/transitions.h"
#include "sim/world/forces.h"

namespace sim {
namespace {

using Past = FragmentRecord::Past;

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
/// Of what is nothing to speak of: what bears more must deform. ...
constexpr double kLoadShare = 0.8;
/// ... Bending strains a wall by so many times the mean, times its extent over its thickness (a beam on two
/// supports, loaded in its middle).
constexpr double kBending = 3.0;
/// Sum of k L^2 over Young's modulus times volume: the bulk modulus is two thirds of it (Poisson's ratio
/// 1/4).
constexpr double kStiffnessShare = 6.0;
/// Gentle is what nears slowly enough: 0.15 threshold times speed of sound, given kCalmStrainShare and the
/// two thirds of the speed of sound that strainsOf() finds.
constexpr double kGentleShare = 0.9;

double calmStrain(Past past) {
  if (past == Past::broken) return kCalmStrainMost;
  return past == Past::touched ? kWholeStrainMost : kUndeformed;
}

/// How strained a fragment's whole bonds are.
struct Strains {
  double calm = 0.0;       ///< is nothing to speak of
  double bears = 0.0;      ///< is nothing to speak of in what touches something
  double largest = 0.0;    ///< of either sign
  double stiffness = 0.0;  ///< erg: sum of k L^2
  bool mayGive = false;    ///< some bond yields, or is too near its threshold
  double sound = 0.0;      ///< cm/s: about two thirds of the speed of sound
  std::size_t bonds = 0;
};

Strains strainsOf(const World& world, const RigidBody& body, Past past) {
  const Network& network = world.network;
  Strains strains;
  strains.calm = calmStrain(past);
  strains.bears = calmStrain(past == Past::untouched ? Past::touched : past);
  for (const NodeIndex node : body.nodes()) {
    for (BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      if (world.breakage.bondBroken(bond)) continue;
      const BondClass& constants = network.bond(bond);
      const Material& material = network.materials[constants.material];
      const double threshold = network.thresholds[bond];
      const double strain = std::abs(strainIn(world, world.now, bond));
      const double most = std::isfinite(material.thresholdMean) ? kCalmStrainShare * threshold : kUndeformed;
      strains.calm = std::min(strains.calm, most);
      strains.bears = std::min(strains.bears, most);
      strains.largest = std::max(strains.largest, strain);
      if (strain > kHeldStrainShare * threshold || strain > material.yieldStrain) strains.mayGive = true;
      strains.stiffness += constants.stiffness * constants.restLength * constants.restLength;
      ++strains.bonds;
    }
  }
  // Mean of k L^2 over mean mass: two thirds of the speed of sound, or a little less.
  if (strains.bonds > 0)
    strains.sound = std::sqrt(strains.stiffness / static_cast<double>(strains.bonds) *
                              static_cast<double>(body.nodes().size()) / body.mass());
  return strains;
}

/// Vibration is strain a quarter of a swing later.
bool vibratesBelow(const World& world, const RigidBody& body, double speed) {
  for (std::size_t i = 0; i < body.nodes().size(); ++i) {
    if (body.vibration(i, world.now.velocity.get(body.nodes()[i])).norm() > speed) return false;
  }
  return true;
}

/// s: what its slowest swing takes, half of it, if it is a free plate.
double halfSwingOf(const World& world, const RigidBody& body, const Strains& strains) {
  const double extent = 2.0 * body.radius();
  return kHalfSwing * extent * extent / (world.fragments.typicalLength * strains.sound);
}

/// cm: of its walls, if they are all alike. Zero where it has no outside.
double thicknessOf(const World& world, const RigidBody& body) {
  const Outside& outside = world.contacts.outside();
  double area = 0.0;
  double volume = 0.0;
  for (const NodeIndex node : body.nodes()) {
    for (const std::uint32_t t : outside.trianglesOf(node)) {
      const OutsideTriangle& triangle = outside.triangles()[t];
      if (triangle.nodes[0] != node) continue;
      const Vec3 a = world.now.position.get(triangle.nodes[0]) - body.centre();
      const Vec3 b = world.now.position.get(triangle.nodes[1]) - body.centre();
      const Vec3 c = world.now.position.get(triangle.nodes[2]) - body.centre();
      area += 0.5 * (b - a).cross(c - a).norm();
      volume += a.dot(b.cross(c)) / 6.0;
    }
  }
  return area > 0.0 && volume > 0.0 ? 2.0 * volume / area : 0.0;
}

/// What the body bears before it is strained by more than nothing to speak of.
RigidBody::Bearing bearingOf(const World& world, const RigidBody& body, const Strains& strains) {
  const double thickness = thicknessOf(world, body);
  if (thickness == 0.0) return {};
  const double slender = std::max(1.0, 2.0 * body.radius() / thickness);
  const double strainShare = kStiffnessShare * kBending * slender / strains.stiffness;
  return {kLoadShare * strains.bears / strainShare, halfSwingOf(world, body, strains)};
}

/// May the body go rigid, and if so, what it then bears. Not where its strain or its vibration is more than
/// nothing to speak of. What broke may be strained for good, by its broken bonds, which push inside it: so if
/// its strain is more, it must have been quiet for half of its slowest swing.
bool isCalm(const World& world, RigidBody& body, double interval, FragmentRecord& record) {
  const Strains strains = strainsOf(world, body, record.past);
  body.setGentleSpeed(std::numeric_limits<double>::infinity());
  if (strains.bonds == 0) return true;
  const double quietSpeed = strains.calm * strains.sound;
  const bool strained = strains.largest > strains.calm;
  if (strains.mayGive || (strained && record.past != Past::broken) ||
      !vibratesBelow(world, body, quietSpeed)) {
    record.quietLooks = 0;
    return false;
  }
  if (strained) {
    if (record.quietLooks < std::numeric_limits<std::uint16_t>::max()) ++record.quietLooks;
    if (static_cast<double>(record.quietLooks) * interval < halfSwingOf(world, body, strains)) return false;
  }
  body.setGentleSpeed(kGentleShare * quietSpeed);
  body.setBearing(bearingOf(world, body, strains));
  return quietSpeed > 0.0;
}

/// Nodes that contacts no longer push stand in the lattice.
void standStill(World& world, const RigidBody& body) {
  for (const std::uint32_t place : body.touched()) {
    world.now.velocity.set(body.nodes()[place], Vec3::Zero());
    world.next.velocity.set(body.nodes()[place], Vec3::Zero());
  }
}

/// Goes through the contact rows and finds what they may do to rigid bodies.
class TouchSearch {
 public:
  explicit TouchSearch(World& world)
      : world_(world),
        bodyOf_(world.fragments.records.size(), kNone),
        rates_(world.fragments.bodies.size()),
        touched_(world.fragments.bodies.size()),
        struck_(world.fragments.bodies.size(), 0) {
    for (std::uint32_t b = 0; b < rates_.size(); ++b) {
      bodyOf_[world.fragments.bodies[b].fragment()] = b;
      rates_[b] = world.fragments.bodies[b].rates();
    }
  }

  void run() {
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
    for (std::vector<std::uint32_t>& places : touched_) {
      std::ranges::sort(places);
      places.erase(std::ranges::unique(places).begin(), places.end());
    }
  }

  /// Places in nodes() of a body, by its place in `bodies`.
  std::vector<std::uint32_t>& touched(std::size_t body) { return touched_[body]; }
  /// Something nears the body faster than is gentle.
  bool struck(std::size_t body) const { return struck_[body] != 0; }

 private:
  Vec3 velocityOf(NodeIndex node) const {
    const std::uint32_t b = bodyOf_[world_.components.of(node)];
    if (b == kNone) return world_.now.velocity.get(node);
    return rates_[b].at(world_.now.position.get(node) - world_.fragments.bodies[b].centre());
  }

  void note(NodeIndex node, const Vec3& towards, const Vec3& other) {
    FragmentRecord& record = world_.fragments.records[world_.components.of(node)];
    if (record.past == Past::untouched) record.past = Past::touched;
    const std::uint32_t b = bodyOf_[world_.components.of(node)];
    if (b == kNone) return;
    const RigidBody& body = world_.fragments.bodies[b];
    const auto place = std::ranges::lower_bound(body.nodes(), node) - body.nodes().begin();
    touched_[b].push_back(static_cast<std::uint32_t>(place));
    if ((velocityOf(node) - other).dot(towards) > body.gentleSpeed()) struck_[b] = 1;
  }

  World& world_;
  std::vector<std::uint32_t> bodyOf_;  ///< by fragment; kNone where it is not rigid
  std::vector<RigidBody::Rates> rates_;
  std::vector<std::vector<std::uint32_t>> touched_;
  std::vector<std::uint8_t> struck_;
};

}  // namespace

void freezeCalm(World& world, double time, double interval) {
  FragmentMotions& fragments = world.fragments;
  for (const RigidBody& body : fragments.bodies) fragments.records[body.fragment()].lastWait /= 2;
  for (FragmentId fragment = 0; fragment < fragments.records.size(); ++fragment) {
    FragmentRecord& record = fragments.records[fragment];
    if (!fragments.activity.deforms(fragment) || record.skippable == 0) continue;
    if (record.wait > 0) {
      --record.wait;
      continue;
    }
    RigidBody body(world.network, fragment, fragments.activity.nodesOf(fragment), world.now);
    if (isCalm(world, body, interval, record)) {
      makeRigid(world, std::move(body));
    } else if (record.quietLooks == 0) {
      waitLonger(record);
    }
  }
  meltStruck(world, time);
}

void meltStruck(World& world, double time) {
  std::vector<RigidBody>& bodies = world.fragments.bodies;
  if (!world.settings.skip.rigid && bodies.empty()) return;
  TouchSearch search(world);
  placeBodies(world);
  search.run();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    standStill(world, bodies[b]);
    bodies[b].setTouched(std::move(search.touched(b)));
  }
  std::size_t b = 0;
  std::erase_if(bodies, [&](const RigidBody& body) {
    if (!search.struck(b++)) return false;
    waitLonger(world.fragments.records[body.fragment()]);
    melt(world, body, time);
    return true;
  });
  placeTouched(world);
}

}  // namespace sim
