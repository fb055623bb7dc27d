#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/parallel.h"
#include "sim/contact/contacts.h"
#include "sim/contact/shared_motion.h"

namespace sim {
namespace {

/// Skins relative to the largest natural length: wider ones mean fewer rebuilds and more pairs looked at in
/// vain.
constexpr double kPairSkinShare = 0.6;
constexpr double kColliderSkinShare = 1.0;
/// A burst of breaks is given this many steps before the rows are rebuilt. Pairs of new fragments are at
/// least about a bond's length apart, and move far less than the skin in so few steps.
constexpr std::uint32_t kStepsAfterBirth = 8;
/// More broken pairs than this outside the rows cost more than a rebuild.
constexpr std::size_t kMostFresh = 4096;
/// Of the collider skin: a quarter of the largest radius is well within any cell.
constexpr double kTravelShare = 0.25;
/// What rounding may take off a distance between boxes.
constexpr double kRounding = 1.0 + 1e-9;
/// Nodes of one fragment that were nearer than this, in natural lengths, when at rest are no self contact.
constexpr double kSelfRestShare = 2.0;
constexpr std::size_t kCubesPerTask = 256;
/// Where steps are long, rows cover so many of them around what a node may come out of on another side.
constexpr double kStepsInSkin = 4.0;

double distanceOf(const Motion& motion, NodeIndex i, NodeIndex j) {
  return (motion.position.get(j) - motion.position.get(i)).norm();
}

bool hasAnotherSide(const MovingCollider& collider) {
  return std::isfinite(deepest(collider.shape));
}

}  // namespace

Contacts::Contacts(const Network& network, const ContactSettings& settings, bool boxesFirst)
    : network_(&network),
      settings_(settings),
      boxesFirst_(boxesFirst),
      nodeStiffness_(network.nodeCount(), std::numeric_limits<float>::max()) {
  for (NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
      const auto stiffness = static_cast<float>(network.bond(b).stiffness);
      nodeStiffness_[a] = std::min(nodeStiffness_[a], stiffness);
      nodeStiffness_[network.bondEnds[b]] = std::min(nodeStiffness_[network.bondEnds[b]], stiffness);
    }
  }
  float largestRadius = 0.0F;
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    if (nodeStiffness_[node] == std::numeric_limits<float>::max()) nodeStiffness_[node] = 0.0F;
    largestRadius = std::max(largestRadius, network.radii[node]);
  }
  largestNatural_ = static_cast<double>(largestRadius) * (settings.length == ContactLength::sum ? 2.0 : 1.0);
  pairSkin_ = kPairSkinShare * static_cast<double>(largestRadius);
  colliderSkin_ = kColliderSkinShare * static_cast<double>(largestRadius);
}

double Contacts::naturalLength(NodeIndex i, NodeIndex j) const {
  const double first = network_->radii[i];
  const double second = network_->radii[j];
  return settings_.length == ContactLength::sum ? first + second : std::min(first, second);
}

const Contacts::BrokenPair* Contacts::findBroken(BondIndex bond) const {
  const auto found =
      std::lower_bound(broken_.begin(), broken_.end(), bond,
                       [](const BrokenPair& pair, BondIndex wanted) { return pair.bond < wanted; });
  return found != broken_.end() && found->bond == bond ? &*found : nullptr;
}

Contacts::BrokenPair Contacts::brokenPair(BondIndex bond, double restLength) const {
  return {bond, network_->bondStart(bond), network_->bondEnds[bond], restLength};
}

void Contacts::addBroken(BondIndex bond, double restLength) {
  fresh_.push_back(brokenPair(bond, restLength));
  if (fresh_.size() > kMostFresh) stale_ = true;
}

void Contacts::noteBirths() {
  if (stepsToRebuild_ == 0) stepsToRebuild_ = kStepsAfterBirth;
}

void Contacts::moveColliders(double travel) {
  odometer_ += travel;
  if (stale_ || !hasColliders_) return;
  colliderTravel_ += travel;
  slack_ -= travel;
  if (slack_ < 0.0) stale_ = true;
}

bool Contacts::choiceIsOld() const {
  return (pairsMayMeet_ || hasColliders_) &&
         2.0 * (odometer_ - odometerAtChoice_) > kChoiceShare * largestNatural_;
}

double Contacts::longestTravel() const {
  const bool unlimited = !(pairsMayMeet_ || hasColliders_) || !(colliderSkin_ > 0.0);
  return unlimited ? std::numeric_limits<double>::infinity() : kTravelShare * colliderSkin_;
}

void Contacts::age(const Motion& motion, double travel) {
  odometer_ += travel;
  if (stepsToRebuild_ > 0 && --stepsToRebuild_ == 0) stale_ = true;
  if (stale_ || !(pairsMayMeet_ || hasColliders_)) return;
  slack_ -= travel;
  if (slack_ > nextTravel(travel)) return;

  // The bound ran out: look how far nodes really are from where they would be, had all gone on together.
  const SharedMotion moved(reference_, motion.position);
  const double unlimited = std::numeric_limits<double>::max();
  const double pairRoom = pairsMayMeet_ ? moved.nearest(longest_ + pairSkin_) - longest_ : unlimited;
  const double colliderRoom =
      hasColliders_ ? colliderClearance_ - moved.furthest() - colliderTravel_ : unlimited;
  // Two nodes close in on each other by both their ways.
  slack_ = std::min(0.5 * pairRoom, colliderRoom);
  if (slack_ <= nextTravel(travel)) stale_ = true;
}

bool Contacts::mayTouch(NodeIndex i, NodeIndex j, const Components& components,
                        const Breakage& breakage) const {
  const bool same = components.of(i) == components.of(j);
  if (same) {
    if (!settings_.self) return false;
    const double atRest = (network_->positions[j] - network_->positions[i]).norm();
    if (atRest < kSelfRestShare * naturalLength(i, j)) return false;
  } else if (!settings_.between) {
    return false;
  }
  const BondIndex bond = network_->findBond(i, j);
  return bond == kNone || (breakage.bondBroken(bond) && findBroken(bond) == nullptr);
}

const Contacts::Entry* Contacts::oldEntry(NodeIndex i, NodeIndex j) const {
  if (rowOfNode_.empty() || rowOfNode_[i] == kNone) return nullptr;
  const Row& row = rows_[rowOfNode_[i]];
  for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
    if (entries_[e].other == j && entries_[e].brokenBond == kNone) return &entries_[e];
  }
  return nullptr;
}

void Contacts::collectBroken(const Motion& motion, const Components& components,
                             std::vector<Candidate>& pairs) {
  const auto byBond = [](const BrokenPair& left, const BrokenPair& right) { return left.bond < right.bond; };
  std::sort(fresh_.begin(), fresh_.end(), byBond);
  const auto before = static_cast<std::ptrdiff_t>(broken_.size());
  broken_.insert(broken_.end(), fresh_.begin(), fresh_.end());
  std::inplace_merge(broken_.begin(), broken_.begin() + before, broken_.end(), byBond);
  fresh_.clear();
  std::erase_if(broken_, [&](const BrokenPair& pair) {
    return settings_.between && components.of(pair.a) != components.of(pair.b) &&
           distanceOf(motion, pair.a, pair.b) >= pair.restLength;
  });
  for (const BrokenPair& pair : broken_) {
    if (distanceOf(motion, pair.a, pair.b) < pair.restLength + pairSkin_)
      pairs.push_back({pair.a, pair.b, {pair.restLength, kNone, pair.bond}});
  }
}

std::vector<NodeIndex> Contacts::nodesToCompare(const Motion& motion, const Components& components,
                                                const FragmentBoxes& boxes) const {
  std::vector<NodeIndex> nodes;
  const bool all = settings_.self || !boxesFirst_;
  const auto meetings =
      all ? std::vector<FragmentBoxes::Box>() : boxes.meetings(kRounding * (largestNatural_ + pairSkin_));
  for (NodeIndex node = 0; node < network_->nodeCount(); ++node) {
    if (all || meetings[components.of(node)].contains(motion.position.get(node))) nodes.push_back(node);
  }
  return nodes;
}

void Contacts::collectContacts(const Motion& motion, std::span<const NodeIndex> nodes,
                               const Components& components, const Breakage& breakage,
                               std::vector<Candidate>& pairs) {
  ++searches_;
  grid_.build(motion.position, nodes, components.fragmentOfNode(), largestNatural_ + pairSkin_);
  const auto consider = [&](NodeIndex first, NodeIndex second, std::vector<Candidate>& found) {
    const NodeIndex i = std::min(first, second);
    const NodeIndex j = std::max(first, second);
    const double natural = naturalLength(i, j);
    const double reach = natural + pairSkin_;
    const double squared = (motion.position.get(j) - motion.position.get(i)).squaredNorm();
    if (squared >= reach * reach || !mayTouch(i, j, components, breakage)) return;
    if (!(std::min(nodeStiffness_[i], nodeStiffness_[j]) > 0.0F)) return;
    const Entry* old = oldEntry(i, j);
    const double rho = old != nullptr ? old->rho : std::min(natural, std::sqrt(squared));
    found.push_back({i, j, {rho, kNone, kNone}});
  };
  const auto near = collectInOrder<Candidate>(
      grid_.cubeCount(), kCubesPerTask, [&](std::size_t cube, std::vector<Candidate>& found) {
        grid_.forEachPairOf(cube, settings_.self, [&](NodeIndex i, NodeIndex j) { consider(i, j, found); });
      });
  pairs.insert(pairs.end(), near.begin(), near.end());
}

/// One flag a fragment: some of its nodes may be near the collider. No depth changes by more than the way
/// between two points. Keeps count of how far the others are at least.
std::vector<std::uint8_t> Contacts::fragmentsNear(const Collider& collider, double skin,
                                                  const FragmentBoxes& boxes, std::size_t fragmentCount) {
  std::vector<std::uint8_t> near(fragmentCount, 0);
  for (FragmentId fragment = 0; fragment < fragmentCount; ++fragment) {
    const FragmentBoxes::Box& box = boxes.of(fragment);
    if (box.isEmpty()) continue;
    const double radius = 0.5 * kRounding * box.diagonal().norm();
    const double clearance = -intrusion(collider, box.center()).depth - radius;
    near[fragment] = clearance < kRounding * skin ? 1 : 0;
    if (near[fragment] == 0) colliderClearance_ = std::min(colliderClearance_, clearance);
  }
  return near;
}

std::vector<Contacts::NodeAtCollider> Contacts::collectColliders(const Motion& motion,
                                                                 const Components& components,
                                                                 const FragmentBoxes& boxes,
                                                                 std::span<const MovingCollider> colliders,
                                                                 double travel) {
  std::vector<NodeAtCollider> near;
  colliderClearance_ = std::numeric_limits<double>::max();
  const double skin = std::max(colliderSkin_, collidersEnd_ ? kStepsInSkin * travel : 0.0);
  for (std::uint32_t c = 0; c < colliders.size(); ++c) {
    if (!colliders[c].active) continue;
    const Collider& collider = colliders[c].shape;
    const auto fragments = fragmentsNear(collider, skin, boxes, components.births().size());
    if (boxesFirst_ && std::find(fragments.begin(), fragments.end(), 1) == fragments.end()) continue;
    const bool plane = collider.isFloor();
    const Vec3 normal = collider.rotation * Vec3::UnitZ();
    const double offset = normal.dot(collider.position);
    for (NodeIndex node = 0; node < network_->nodeCount(); ++node) {
      const bool nearby = fragments[components.of(node)] != 0;
      if (boxesFirst_ && !nearby) continue;
      const Vec3 position = motion.position.get(node);
      const double clearance = plane ? normal.dot(position) - offset : -intrusion(collider, position).depth;
      if (clearance < skin) {
        near.push_back({node, c});
      } else if (nearby) {
        colliderClearance_ = std::min(colliderClearance_, clearance);
      }
    }
  }
  if (colliders.size() < 2) return near;
  std::stable_sort(near.begin(), near.end(), [](const NodeAtCollider& left, const NodeAtCollider& right) {
    return left.node < right.node;
  });
  return near;
}

/// Both directions of every pair, by node, then by the other: counted out, since sorting costs more.
void Contacts::fillEntries(const std::vector<Candidate>& pairs, std::vector<std::uint32_t>& firstEntry) {
  firstEntry.assign(network_->nodeCount() + 1, 0);
  for (const Candidate& pair : pairs) {
    ++firstEntry[pair.i + 1];
    ++firstEntry[pair.j + 1];
  }
  for (std::size_t node = 0; node < network_->nodeCount(); ++node) firstEntry[node + 1] += firstEntry[node];
  entries_.resize(2 * pairs.size());
  std::vector<std::uint32_t> next(firstEntry.begin(), firstEntry.end() - 1);
  for (const Candidate& pair : pairs) {
    Entry& there = entries_[next[pair.i]++];
    there = pair.entry;
    there.other = pair.j;
    Entry& back = entries_[next[pair.j]++];
    back = pair.entry;
    back.other = pair.i;
  }
}

void Contacts::fillRows(const std::vector<Candidate>& pairs, const std::vector<NodeAtCollider>& near) {
  rows_.clear();
  entries_.clear();
  nearColliders_.clear();
  rowOfNode_.assign(pairs.empty() && near.empty() ? 0 : network_->nodeCount(), kNone);
  if (rowOfNode_.empty()) return deduce();
  std::vector<std::uint32_t> firstEntry;
  fillEntries(pairs, firstEntry);
  auto collider = near.begin();
  for (NodeIndex node = 0; node < network_->nodeCount(); ++node) {
    const bool touchesCollider = collider != near.end() && collider->node == node;
    if (firstEntry[node] == firstEntry[node + 1] && !touchesCollider) continue;
    Row row;
    row.node = node;
    row.firstEntry = firstEntry[node];
    row.lastEntry = firstEntry[node + 1];
    std::sort(entries_.begin() + row.firstEntry, entries_.begin() + row.lastEntry,
              [](const Entry& left, const Entry& right) { return left.other < right.other; });
    row.firstCollider = static_cast<std::uint32_t>(nearColliders_.size());
    for (; collider != near.end() && collider->node == node; ++collider)
      nearColliders_.push_back(collider->collider);
    row.lastCollider = static_cast<std::uint32_t>(nearColliders_.size());
    rowOfNode_[node] = static_cast<std::uint32_t>(rows_.size());
    rows_.push_back(row);
  }
  deduce();
}

/// What follows from rows, entries and broken bonds.
void Contacts::deduce() {
  growing_.clear();
  constants_.resize(entries_.size());
  mostOfRow_.assign(rows_.size(), {});
  longest_ = largestNatural_;
  for (const BrokenPair& pair : broken_) longest_ = std::max(longest_, pair.restLength);
  for (std::uint32_t r = 0; r < rows_.size(); ++r) {
    Row& row = rows_[r];
    double reach = 0.0;
    for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
      const Entry& entry = entries_[e];
      const bool broken = entry.brokenBond != kNone;
      const double natural = broken ? entry.rho : naturalLength(row.node, entry.other);
      constants_[e] = constantsOf(row.node, entry);
      mostOfRow_[r].rateSquared += 2.0 * constants_[e].stiffness;
      mostOfRow_[r].damping += 2.0 * constants_[e].damping;
      reach = std::max(reach, natural);
      if (entry.rho < natural) growing_.push_back({r, e});
    }
    row.reach = std::nextafter(static_cast<float>(reach), std::numeric_limits<float>::max());
  }
}

void Contacts::rebuild(const Motion& motion, const Components& components, const Breakage& breakage,
                       std::span<const MovingCollider> colliders, double travel) {
  const bool several = settings_.between && components.births().size() > 1;
  hasColliders_ = std::ranges::any_of(colliders, &MovingCollider::active);
  collidersEnd_ = std::ranges::any_of(colliders, hasAnotherSide);
  std::vector<Candidate> pairs;
  collectBroken(motion, components, pairs);
  // Nodes without bonds have no size.
  const bool compared = (several || settings_.self) && largestNatural_ > 0.0;
  const FragmentBoxes boxes(motion.position, components.fragmentOfNode(), components.births().size());
  if (compared) {
    const std::vector<NodeIndex> nodes = nodesToCompare(motion, components, boxes);
    if (!nodes.empty()) collectContacts(motion, nodes, components, breakage, pairs);
  }
  fillRows(pairs, collectColliders(motion, components, boxes, colliders, travel));
  pairsMayMeet_ = several || settings_.self || !broken_.empty();
  if (pairsMayMeet_ || hasColliders_) reference_ = motion.position;
  colliderTravel_ = 0.0;
  odometer_ = 0.0;
  odometerAtChoice_ = 0.0;
  slack_ = 0.0;
  stepsToRebuild_ = 0;
  stale_ = false;
  ++rebuilds_;
}

void Contacts::takeOver(const Contacts& other) {
  rows_ = other.rows_;
  entries_ = other.entries_;
  rowOfNode_ = other.rowOfNode_;
  broken_ = other.broken_;
  fresh_ = other.fresh_;
  rebuilds_ = other.rebuilds_;
  searches_ = other.searches_;
  nearColliders_.clear();
  for (Row& row : rows_) {
    row.firstCollider = row.lastCollider = 0;
    for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
      Entry& entry = entries_[e];
      if (entry.brokenBond == kNone) entry.rho = std::min(entry.rho, naturalLength(row.node, entry.other));
    }
  }
  deduce();
  stale_ = true;
}

void Contacts::savePairs(ByteWriter& writer, const std::vector<BrokenPair>& pairs) {
  writer.put<std::uint64_t>(pairs.size());
  for (const BrokenPair& pair : pairs) {
    writer.put(pair.bond);
    writer.put(pair.restLength);
  }
}

void Contacts::loadPairs(ByteReader& reader, std::vector<BrokenPair>& pairs) const {
  pairs.clear();
  std::uint64_t count = 0;
  reader.read(count);
  for (std::uint64_t p = 0; p < count && reader.ok(); ++p) {
    BondIndex bond = kNone;
    double restLength = 0.0;
    if (!reader.read(bond) || !reader.read(restLength)) return;
    if (bond < network_->bondCount()) {
      pairs.push_back(brokenPair(bond, restLength));
    } else {
      reader.fail();
    }
  }
}

void Contacts::save(ByteWriter& writer) const {
  writer.putVector(rows_);
  writer.putVector(entries_);
  writer.putVector(nearColliders_);
  savePairs(writer, broken_);
  savePairs(writer, fresh_);
  for (std::size_t k = 0; k < 3; ++k) {
    writer.putVector(std::vector<double>(reference_.axis(k), reference_.axis(k) + reference_.size()));
  }
  for (const bool flag : {pairsMayMeet_, hasColliders_, stale_}) writer.put<std::uint8_t>(flag ? 1 : 0);
  writer.put(odometer_);
  writer.put(odometerAtChoice_);
  writer.put(slack_);
  writer.put(colliderTravel_);
  writer.put(colliderClearance_);
  writer.put(stepsToRebuild_);
  writer.put(rebuilds_);
  writer.put(searches_);
}

/// False where the bytes cannot have come from save() of such a network.
bool Contacts::load(ByteReader& reader, std::span<const MovingCollider> colliders) {
  reader.readVector(rows_);
  reader.readVector(entries_);
  reader.readVector(nearColliders_);
  loadPairs(reader, broken_);
  loadPairs(reader, fresh_);
  std::array<std::vector<double>, 3> reference;
  for (std::vector<double>& axis : reference) reader.readVector(axis);
  std::array<std::uint8_t, 3> flags{};
  for (std::uint8_t& flag : flags) reader.read(flag);
  reader.read(odometer_);
  reader.read(odometerAtChoice_);
  reader.read(slack_);
  reader.read(colliderTravel_);
  reader.read(colliderClearance_);
  reader.read(stepsToRebuild_);
  reader.read(rebuilds_);
  reader.read(searches_);
  pairsMayMeet_ = flags[0] != 0;
  hasColliders_ = flags[1] != 0;
  stale_ = flags[2] != 0;
  collidersEnd_ = std::ranges::any_of(colliders, hasAnotherSide);

  const std::size_t nodes = network_->nodeCount();
  const std::size_t bonds = network_->bondCount();
  const auto properRow = [&](const Row& row) {
    return row.node < nodes && row.firstEntry <= row.lastEntry && row.lastEntry <= entries_.size() &&
           row.firstCollider <= row.lastCollider && row.lastCollider <= nearColliders_.size();
  };
  bool proper = reader.ok() && std::all_of(rows_.begin(), rows_.end(), properRow) &&
                std::all_of(nearColliders_.begin(), nearColliders_.end(),
                            [&](std::uint32_t c) { return c < colliders.size(); });
  proper = proper && std::all_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
             return entry.other < nodes && (entry.brokenBond == kNone || entry.brokenBond < bonds);
           });
  const std::size_t length = reference[0].size();
  const bool needed = pairsMayMeet_ || hasColliders_;
  proper = proper && (length == nodes || (length == 0 && !needed)) && reference[1].size() == length &&
           reference[2].size() == length;
  if (!proper) return false;
  reference_ = NodeVectors(length);
  for (std::size_t k = 0; k < 3; ++k) std::copy(reference[k].begin(), reference[k].end(), reference_.axis(k));
  rowOfNode_.assign(nodes, kNone);
  for (std::uint32_t r = 0; r < rows_.size(); ++r) rowOfNode_[rows_[r].node] = r;
  deduce();
  return std::all_of(entries_.begin(), entries_.end(),
                     [&](const Entry& entry) { return rowOfNode_[entry.other] != kNone; });
}

std::size_t Contacts::memoryBytes() const {
  const auto bytes = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return bytes(nodeStiffness_) + grid_.memoryBytes() + bytes(rows_) + bytes(entries_) + bytes(constants_) +
         bytes(mostOfRow_) + bytes(nearColliders_) + bytes(rowOfNode_) + bytes(growing_) + bytes(broken_) +
         bytes(fresh_) + (reference_.size() > 0 ? reference_.memoryBytes() : 0);
}

}  // namespace sim
