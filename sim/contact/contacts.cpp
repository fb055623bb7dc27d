#include "sim/contact/contacts.h"

namespace sim {
namespace {

/// More broken pairs than this outside the rows cost more than a rebuild.
constexpr std::size_t kMostFresh = 4096;

}  // namespace

Contacts::Contacts(const Network& network, const ContactSettings& settings) : model_(network, settings) {}

void Contacts::addBroken(BondIndex bond, double restLength) {
  rows_.addBroken(model_.network(), bond, restLength);
  if (rows_.fresh.size() > kMostFresh) age_.makeStale();
}

void Contacts::ageByStep(const Motion& motion, double travel) {
  age_.age(model_, motion, rows_.longest, travel);
}

void Contacts::rebuild(const Motion& motion, const Components& components, const Breakage& breakage,
                       std::span<const MovingCollider> colliders, double travel) {
  std::vector<ContactCandidate> pairs = rows_.settleBroken(model_, motion, components);
  const FragmentBoxes boxes(motion.position, components.fragmentOfNode(), components.births().size());
  const ContactScene scene{motion, components, breakage, colliders, boxes};
  if (pairsAreCompared(model_, components)) {
    const std::vector<NodeIndex> nodes = nodesToCompare(model_, scene);
    if (!nodes.empty()) {
      ++searches_;
      const std::vector<ContactCandidate> found = findContacts(model_, rows_, scene, nodes, grid_);
      pairs.insert(pairs.end(), found.begin(), found.end());
    }
  }
  const NearColliders near = findNearColliders(model_, scene, travel);
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

void Contacts::takeOver(const Contacts& other) {
  rows_.takeOver(model_, other.rows_);
  rebuilds_ = other.rebuilds_;
  searches_ = other.searches_;
  age_.makeStale();
}

void Contacts::save(ByteWriter& writer) const {
  rows_.save(writer);
  age_.save(writer);
  writer.put(rebuilds_);
  writer.put(searches_);
}

bool Contacts::load(ByteReader& reader, std::span<const MovingCollider> colliders) {
  if (!rows_.load(model_, reader, colliders.size()) ||
      !age_.load(reader, model_.network().nodeCount(), anyColliderEnds(colliders)))
    return false;
  reader.read(rebuilds_);
  reader.read(searches_);
  return reader.ok();
}

std::size_t Contacts::memoryBytes() const {
  return model_.memoryBytes() + rows_.memoryBytes() + age_.memoryBytes() + grid_.memoryBytes();
}

}  // namespace sim
