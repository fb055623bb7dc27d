#include "sim/contact/contacts.h"

#include <utility>

#include "sim/contact/surface_follow.h"
#include "sim/contact/surface_search.h"

namespace sim {
namespace {

/// More broken pairs than this outside the rows cost more than a rebuild.
constexpr std::size_t kMostFresh = 4096;

}  // namespace

Contacts::Contacts(const Network& network, const ContactSettings& settings)
    : model_(network, settings), outside_(network) {}

void Contacts::addBroken(BondIndex bond, double restLength) {
  rows_.addBroken(model_.network(), bond, restLength);
  if (rows_.fresh.size() > kMostFresh) age_.makeStale();
}

void Contacts::ageByStep(const Motion& motion, double travel) {
  age_.age(model_, motion, rows_.longest, travel);
  lastTravel_ = travel;
}

void Contacts::rebuild(const Motion& motion, const Components& components, const Breakage& breakage,
                       std::span<const MovingCollider> colliders, double time, double travel) {
  std::vector<ContactCandidate> pairs = rows_.settleBroken(model_, motion, components);
  outside_.follow(breakage);
  const FragmentBoxes boxes(motion.position, components.fragmentOfNode(), components.births().size());
  const ContactScene scene{motion, components, breakage, colliders, boxes, outside_};
  if (pairsAreCompared(model_, components)) {
    const std::vector<NodeIndex> nodes = nodesToCompare(model_, scene);
    if (!nodes.empty()) {
      ++searches_;
      const std::vector<ContactCandidate> found = findContacts(model_, rows_, scene, nodes, grid_);
      pairs.insert(pairs.end(), found.begin(), found.end());
    }
  }
  if (model_.settings().kind == ContactKind::surfaces && model_.settings().between &&
      components.births().size() > 1) {
    findSurfaceRows(model_, {outside_, components, motion.position, boxes}, surfaces_);
  } else {
    surfaces_ = {};
  }
  const NearColliders near = findNearColliders(model_, scene, travel);
  if (const auto among = std::exchange(startsAmong_, std::nullopt)) {
    starts_.begin({model_, components, motion.position, colliders, time}, near.nodes, *among);
  } else {
    surfacesStart_ = false;
  }
  rows_.fill(model_, pairs, near.nodes);
  RowAge::Found found;
  found.pairsMayMeet = (model_.settings().between && components.births().size() > 1) ||
                       model_.settings().self || !rows_.broken.empty();
  found.hasColliders = std::ranges::any_of(colliders, &MovingCollider::active);
  found.collidersEnd = anyColliderEnds(colliders);
  found.colliderClearance = near.clearance;
  age_.begin(found, motion.position);
  ++rebuilds_;
}

double Contacts::follow(const NodeVectors& positions) {
  if (surfaces_.quiet()) return 0.0;
  const bool starts = std::exchange(surfacesStart_, false);
  return followSurfaces(model_, outside_, {positions, age_.odometer(), lastTravel_, starts}, surfaces_);
}

void Contacts::takeOver(const Contacts& other, std::span<const MovingCollider> before) {
  rows_.takeOver(model_, other.rows_);
  // Contacts find their rows again when rows are filled anew.
  if (model_.settings().kind == ContactKind::surfaces) {
    outside_.takeOver(other.outside_);
    surfaces_ = other.surfaces_;
  }
  starts_ = other.starts_;
  startsAmong_.emplace(before.begin(), before.end());
  surfacesStart_ = other.surfacesStart_;
  rebuilds_ = other.rebuilds_;
  searches_ = other.searches_;
  age_.makeStale();
}

void Contacts::save(ByteWriter& writer) const {
  rows_.save(writer);
  age_.save(writer);
  outside_.save(writer);
  surfaces_.save(writer);
  starts_.save(writer);
  writer.put<std::uint8_t>(surfacesStart_ ? 1 : 0);
  writer.put(lastTravel_);
  writer.put(rebuilds_);
  writer.put(searches_);
}

bool Contacts::load(ByteReader& reader, std::span<const MovingCollider> colliders) {
  if (!rows_.load(model_, reader, colliders.size()) ||
      !age_.load(reader, model_.network().nodeCount(), anyColliderEnds(colliders)) ||
      !outside_.load(reader) || !surfaces_.load(outside_, reader) ||
      !starts_.load(reader, model_.network().nodeCount(), colliders.size()))
    return false;
  std::uint8_t surfacesStart = 0;
  reader.read(surfacesStart);
  reader.read(lastTravel_);
  surfacesStart_ = surfacesStart != 0;
  startsAmong_.reset();
  reader.read(rebuilds_);
  reader.read(searches_);
  return reader.ok();
}

std::size_t Contacts::memoryBytes() const {
  return model_.memoryBytes() + rows_.memoryBytes() + age_.memoryBytes() + grid_.memoryBytes() +
         outside_.memoryBytes() + surfaces_.memoryBytes() + starts_.memoryBytes();
}

}  // namespace sim
