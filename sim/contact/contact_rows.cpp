#include "sim/contact/contact_rows.h"

#include <cmath>
#include <limits>

namespace sim {
namespace {

double distanceOf(const Motion& motion, NodeIndex i, NodeIndex j) {
  return (motion.position.get(j) - motion.position.get(i)).norm();
}

BrokenPair brokenPair(const Network& network, BondIndex bond, double restLength) {
  return {bond, network.bondStart(bond), network.bondEnds[bond], restLength};
}

void savePairs(ByteWriter& writer, const std::vector<BrokenPair>& pairs) {
  writer.put<std::uint64_t>(pairs.size());
  for (const BrokenPair& pair : pairs) {
    writer.put(pair.bond);
    writer.put(pair.restLength);
  }
}

void loadPairs(const Network& network, ByteReader& reader, std::vector<BrokenPair>& pairs) {
  pairs.clear();
  std::uint64_t count = 0;
  reader.read(count);
  for (std::uint64_t p = 0; p < count && reader.ok(); ++p) {
    BondIndex bond = kNone;
    double restLength = 0.0;
    if (!reader.read(bond) || !reader.read(restLength)) return;
    if (bond < network.bondCount()) {
      pairs.push_back(brokenPair(network, bond, restLength));
    } else {
      reader.fail();
    }
  }
}

}  // namespace

bool ContactRows::isBrokenPair(BondIndex bond) const {
  const auto found = std::ranges::lower_bound(broken, bond, {}, &BrokenPair::bond);
  return found != broken.end() && found->bond == bond;
}

const ContactEntry* ContactRows::contactOf(NodeIndex i, NodeIndex j) const {
  if (rowOfNode.empty() || rowOfNode[i] == kNone) return nullptr;
  const ContactRow& row = rows[rowOfNode[i]];
  for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
    if (entries[e].other == j && entries[e].brokenBond == kNone) return &entries[e];
  }
  return nullptr;
}

void ContactRows::addBroken(const Network& network, BondIndex bond, double restLength) {
  fresh.push_back(brokenPair(network, bond, restLength));
}

std::vector<ContactCandidate> ContactRows::settleBroken(const ContactModel& model, const Motion& motion,
                                                        const Components& components) {
  const auto byBond = [](const BrokenPair& left, const BrokenPair& right) { return left.bond < right.bond; };
  std::sort(fresh.begin(), fresh.end(), byBond);
  const auto before = static_cast<std::ptrdiff_t>(broken.size());
  broken.insert(broken.end(), fresh.begin(), fresh.end());
  std::inplace_merge(broken.begin(), broken.begin() + before, broken.end(), byBond);
  fresh.clear();
  std::erase_if(broken, [&](const BrokenPair& pair) {
    return model.settings().between && components.of(pair.a) != components.of(pair.b) &&
           distanceOf(motion, pair.a, pair.b) >= pair.restLength;
  });
  std::vector<ContactCandidate> pairs;
  for (const BrokenPair& pair : broken) {
    if (distanceOf(motion, pair.a, pair.b) < pair.restLength + model.pairSkin())
      pairs.push_back({pair.a, pair.b, {pair.restLength, kNone, pair.bond}});
  }
  return pairs;
}

/// Both directions of every pair, by node: counted out, since sorting costs more. Gives where each node's
/// begin.
std::vector<std::uint32_t> ContactRows::fillEntries(std::size_t nodeCount,
                                                    std::span<const ContactCandidate> pairs) {
  std::vector<std::uint32_t> firstEntry(nodeCount + 1, 0);
  for (const ContactCandidate& pair : pairs) {
    ++firstEntry[pair.i + 1];
    ++firstEntry[pair.j + 1];
  }
  for (std::size_t node = 0; node < nodeCount; ++node) firstEntry[node + 1] += firstEntry[node];
  entries.resize(2 * pairs.size());
  std::vector<std::uint32_t> next(firstEntry.begin(), firstEntry.end() - 1);
  for (const ContactCandidate& pair : pairs) {
    ContactEntry& there = entries[next[pair.i]++];
    there = pair.entry;
    there.other = pair.j;
    ContactEntry& back = entries[next[pair.j]++];
    back = pair.entry;
    back.other = pair.i;
  }
  return firstEntry;
}

void ContactRows::fill(const ContactModel& model, std::span<const ContactCandidate> pairs,
                       std::span<const NodeAtCollider> near) {
  const std::size_t nodeCount = model.network().nodeCount();
  const std::vector<HeldNode> held = heldNodes();
  rows.clear();
  entries.clear();
  nearColliders.clear();
  holds = {};
  rowOfNode.assign(pairs.empty() && near.empty() ? 0 : nodeCount, kNone);
  if (rowOfNode.empty()) return deduce(model);
  const std::vector<std::uint32_t> firstEntry = fillEntries(nodeCount, pairs);
  auto collider = near.begin();
  for (NodeIndex node = 0; node < nodeCount; ++node) {
    const bool touchesCollider = collider != near.end() && collider->node == node;
    if (firstEntry[node] == firstEntry[node + 1] && !touchesCollider) continue;
    ContactRow row;
    row.node = node;
    row.firstEntry = firstEntry[node];
    row.lastEntry = firstEntry[node + 1];
    std::sort(entries.begin() + row.firstEntry, entries.begin() + row.lastEntry,
              [](const ContactEntry& left, const ContactEntry& right) { return left.other < right.other; });
    row.firstCollider = static_cast<std::uint32_t>(nearColliders.size());
    for (; collider != near.end() && collider->node == node; ++collider)
      nearColliders.push_back(collider->collider);
    row.lastCollider = static_cast<std::uint32_t>(nearColliders.size());
    rowOfNode[node] = static_cast<std::uint32_t>(rows.size());
    rows.push_back(row);
  }
  holdAgain(held);
  deduce(model);
}

std::vector<ContactRows::HeldNode> ContactRows::heldNodes() const {
  std::vector<HeldNode> held;
  for (const std::uint32_t r : holds.rows) {
    for (std::uint32_t c = rows[r].firstCollider; c < rows[r].lastCollider; ++c) {
      if (holds.byCollider[c].held != 0)
        held.push_back({rows[r].node, nearColliders[c], holds.byCollider[c]});
    }
  }
  return held;
}

void ContactRows::holdAgain(std::span<const HeldNode> held) {
  holds.byCollider.assign(nearColliders.size(), {});
  for (const HeldNode& old : held) {
    const std::uint32_t r = rowOfNode[old.node];
    if (r == kNone) continue;
    for (std::uint32_t c = rows[r].firstCollider; c < rows[r].lastCollider; ++c) {
      if (nearColliders[c] != old.collider) continue;
      holds.byCollider[c] = old.hold;
      if (holds.rows.empty() || holds.rows.back() != r) holds.rows.push_back(r);
    }
  }
}

void ContactRows::deduce(const ContactModel& model) {
  growing.clear();
  constants.resize(entries.size());
  mostOfRow.assign(rows.size(), {});
  longest = model.largestNatural();
  for (const BrokenPair& pair : broken) longest = std::max(longest, pair.restLength);
  for (std::uint32_t r = 0; r < rows.size(); ++r) {
    ContactRow& row = rows[r];
    double reach = 0.0;
    for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
      const ContactEntry& entry = entries[e];
      const bool repels = entry.brokenBond != kNone;
      const double natural = repels ? entry.rho : model.naturalLength(row.node, entry.other);
      constants[e] = model.constantsOf(row.node, entry);
      mostOfRow[r].rateSquared += 2.0 * constants[e].stiffness;
      mostOfRow[r].damping += 2.0 * constants[e].damping;
      reach = std::max(reach, natural);
      if (entry.rho < natural) growing.push_back({r, e});
    }
    row.reach = std::nextafter(static_cast<float>(reach), std::numeric_limits<float>::max());
  }
}

void ContactRows::growApart(const ContactModel& model, const Motion& motion) {
  std::size_t kept = 0;
  for (const auto& [row, entryIndex] : growing) {
    ContactEntry& entry = entries[entryIndex];
    const NodeIndex node = rows[row].node;
    const double squared = (motion.position.get(entry.other) - motion.position.get(node)).squaredNorm();
    const double natural = model.naturalLength(node, entry.other);
    if (squared >= entry.rho * entry.rho) entry.rho = std::min(natural, std::sqrt(squared));
    if (entry.rho < natural) growing[kept++] = {row, entryIndex};
  }
  growing.resize(kept);
}

void ContactRows::takeOver(const ContactModel& model, const ContactRows& other) {
  rows = other.rows;
  entries = other.entries;
  rowOfNode = other.rowOfNode;
  broken = other.broken;
  fresh = other.fresh;
  nearColliders.clear();
  holds = {};
  for (ContactRow& row : rows) {
    row.firstCollider = row.lastCollider = 0;
    for (std::uint32_t e = row.firstEntry; e < row.lastEntry; ++e) {
      ContactEntry& entry = entries[e];
      if (entry.brokenBond == kNone)
        entry.rho = std::min(entry.rho, model.naturalLength(row.node, entry.other));
    }
  }
  deduce(model);
}

void ContactRows::save(ByteWriter& writer) const {
  writer.putVector(rows);
  writer.putVector(entries);
  writer.putVector(nearColliders);
  for (const ColliderHold& hold : holds.byCollider) {
    writer.put(hold.anchor);
    writer.put(hold.stretch);
    writer.put(hold.nearest);
    writer.put(hold.held);
  }
  writer.putVector(holds.rows);
  savePairs(writer, broken);
  savePairs(writer, fresh);
}

bool ContactRows::isProper(const Network& network, std::size_t colliderCount) const {
  const auto properRow = [&](const ContactRow& row) {
    return row.node < network.nodeCount() && row.firstEntry <= row.lastEntry &&
           row.lastEntry <= entries.size() && row.firstCollider <= row.lastCollider &&
           row.lastCollider <= nearColliders.size();
  };
  const auto properEntry = [&](const ContactEntry& entry) {
    return entry.other < network.nodeCount() &&
           (entry.brokenBond == kNone || entry.brokenBond < network.bondCount());
  };
  return std::ranges::all_of(rows, properRow) && std::ranges::all_of(entries, properEntry) &&
         std::ranges::all_of(nearColliders, [&](std::uint32_t c) { return c < colliderCount; }) &&
         std::ranges::is_sorted(holds.rows) &&
         std::ranges::all_of(holds.rows, [&](std::uint32_t r) { return r < rows.size(); });
}

bool ContactRows::load(const ContactModel& model, ByteReader& reader, std::size_t colliderCount) {
  const Network& network = model.network();
  reader.readVector(rows);
  reader.readVector(entries);
  reader.readVector(nearColliders);
  holds.byCollider.assign(reader.ok() ? nearColliders.size() : 0, {});
  for (ColliderHold& hold : holds.byCollider) {
    reader.read(hold.anchor);
    reader.read(hold.stretch);
    reader.read(hold.nearest);
    reader.read(hold.held);
  }
  reader.readVector(holds.rows);
  loadPairs(network, reader, broken);
  loadPairs(network, reader, fresh);
  if (!reader.ok() || !isProper(network, colliderCount)) return false;
  rowOfNode.assign(network.nodeCount(), kNone);
  for (std::uint32_t r = 0; r < rows.size(); ++r) rowOfNode[rows[r].node] = r;
  deduce(model);
  return std::ranges::all_of(entries,
                             [&](const ContactEntry& entry) { return rowOfNode[entry.other] != kNone; });
}

std::size_t ContactRows::memoryBytes() const {
  const auto bytes = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return bytes(rows) + bytes(entries) + bytes(constants) + bytes(mostOfRow) + bytes(nearColliders) +
         bytes(holds.byCollider) + bytes(holds.rows) + bytes(rowOfNode) + bytes(growing) + bytes(broken) +
         bytes(fresh);
}

}  // namespace sim
