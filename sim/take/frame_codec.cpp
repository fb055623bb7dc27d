#include "sim/take/frame_codec.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "sim/take/planes.h"

namespace sim {
namespace {

// A member added to one of these must be stored too, and kTakeVersion raised.
static_assert(sizeof(Energy) == 8 * sizeof(double));
static_assert(sizeof(LedgerRow) == sizeof(Energy) + 8 * sizeof(double));
static_assert(sizeof(Fragment) == 4 * sizeof(double));
static_assert(sizeof(MovingFragment) == 14 * sizeof(double));
static_assert(sizeof(BreakEvent) == 4 * sizeof(double));
static_assert(sizeof(Snapshot) ==
              sizeof(LedgerRow) + 2 * sizeof(double) + 3 * sizeof(std::vector<int>) + sizeof(BrokenPointer));
static_assert(sizeof(Broken) == 4 * sizeof(std::vector<int>) + sizeof(std::uint64_t));

/// One member of every record, so that like stands by like and compresses.
template <class Member, class Record>
void putColumn(ByteWriter& writer, const std::vector<Record>& records, Member Record::*member) {
  std::vector<Member> column(records.size());
  std::ranges::transform(records, column.begin(), [member](const Record& record) { return record.*member; });
  putPlanes(writer, column);
}

/// Records and column must be equally many.
template <class Member, class Record>
void readColumn(ByteReader& reader, std::vector<Record>& records, Member Record::*member) {
  std::vector<Member> column;
  if (!readPlanes(reader, column, records.size())) return;
  for (std::size_t i = 0; i < records.size(); ++i) records[i].*member = column[i];
}

/// Makes room for as many records as the first column has members, but at most `limit`: a record is larger
/// than its first member, so a damaged count may not be believed just because that many members follow.
template <class Member, class Record>
void readFirstColumn(ByteReader& reader, std::vector<Record>& records, Member Record::*member,
                     std::size_t limit) {
  std::vector<Member> column;
  readPlanes(reader, column);
  if (column.size() > limit) reader.fail();
  if (!reader.ok()) return;
  records.resize(column.size());
  for (std::size_t i = 0; i < records.size(); ++i) records[i].*member = column[i];
}

constexpr double Energy::*kEnergyMembers[] = {&Energy::kinetic,     &Energy::elastic,    &Energy::gravity,
                                              &Energy::contact,     &Energy::dissipated, &Energy::released,
                                              &Energy::outsideWork, &Energy::residual};

void putLedger(ByteWriter& writer, const LedgerRow& row) {
  writer.put(row.time);
  for (const auto member : kEnergyMembers) writer.put(row.energy.*member);
  writer.put(row.linearMomentum);
  writer.put(row.angularMomentum);
  writer.put(row.step);
}

void readLedger(ByteReader& reader, LedgerRow& row) {
  reader.read(row.time);
  for (const auto member : kEnergyMembers) reader.read(row.energy.*member);
  reader.read(row.linearMomentum);
  reader.read(row.angularMomentum);
  reader.read(row.step);
}

void readMoment(ByteReader& reader, Snapshot& snapshot) {
  reader.read(snapshot.time);
  reader.read(snapshot.stepCount);
  readLedger(reader, snapshot.ledger);
}

void readMotion(ByteReader& reader, const NetworkSize& size, Snapshot& snapshot) {
  readPlanes(reader, snapshot.positions, size.nodes);
  readPlanes(reader, snapshot.velocities, size.nodes);
}

void readFragments(ByteReader& reader, Snapshot& snapshot) {
  readColumn(reader, snapshot.fragments, &MovingFragment::centre);
  readColumn(reader, snapshot.fragments, &MovingFragment::velocity);
  readColumn(reader, snapshot.fragments, &MovingFragment::boxMin);
  readColumn(reader, snapshot.fragments, &MovingFragment::boxMax);
  readColumn(reader, snapshot.fragments, &MovingFragment::state);
}

void readFrame(ByteReader& reader, const NetworkSize& size, Snapshot& snapshot) {
  readMoment(reader, snapshot);
  readMotion(reader, size, snapshot);
  readFragments(reader, snapshot);
}

/// Over positions and velocities of the whole frame.
void readChange(ByteReader& reader, const NetworkSize& size, Snapshot& snapshot) {
  std::uint64_t whole = 0;
  std::vector<std::uint8_t> changed;
  reader.read(whole);
  readMoment(reader, snapshot);
  if (!readFlags(reader, changed, size.nodes)) return;
  const auto count = static_cast<std::size_t>(std::ranges::count(changed, std::uint8_t{1}));
  std::vector<Vec3> positions;
  std::vector<Vec3> velocities;
  if (!readPlanes(reader, positions, count) || !readPlanes(reader, velocities, count)) return;
  std::size_t next = 0;
  for (std::size_t node = 0; node < size.nodes; ++node) {
    if (changed[node] == 0) continue;
    snapshot.positions[node] = positions[next];
    snapshot.velocities[node] = velocities[next++];
  }
  readFragments(reader, snapshot);
}

void putMoment(ByteWriter& writer, const Snapshot& snapshot) {
  writer.put(snapshot.time);
  writer.put(snapshot.stepCount);
  putLedger(writer, snapshot.ledger);
}

void putFragments(ByteWriter& writer, const Snapshot& snapshot) {
  putColumn(writer, snapshot.fragments, &MovingFragment::centre);
  putColumn(writer, snapshot.fragments, &MovingFragment::velocity);
  putColumn(writer, snapshot.fragments, &MovingFragment::boxMin);
  putColumn(writer, snapshot.fragments, &MovingFragment::boxMax);
  putColumn(writer, snapshot.fragments, &MovingFragment::state);
}

/// A snapshot with the fragments that are to be read for it.
Snapshot stillOf(const BrokenPointer& broken) {
  Snapshot snapshot;
  snapshot.broken = broken;
  for (const Fragment& fragment : broken->fragments) snapshot.fragments.push_back({.id = fragment.id});
  return snapshot;
}

bool sameBits(const Vec3& a, const Vec3& b) {
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bits are meant.
  return std::memcmp(a.data(), b.data(), sizeof(Vec3)) == 0;
}

std::optional<std::string> faultOfFragments(const NetworkSize& size, const Broken& broken) {
  const std::vector<Fragment>& fragments = broken.fragments;
  const auto outOfOrder = [](const Fragment& a, const Fragment& b) { return a.id >= b.id; };
  if (std::ranges::adjacent_find(fragments, outOfOrder) != fragments.end())
    return "its fragments are out of order";
  FragmentId known = kNone;
  for (std::size_t node = 0; node < size.nodes; ++node) {
    const FragmentId id = broken.fragmentOfNode[node];
    if (id == known) continue;
    const auto found = std::ranges::lower_bound(fragments, id, {}, &Fragment::id);
    if (id != kNone && (found == fragments.end() || found->id != id))
      return "its node " + std::to_string(node) + " is in a fragment that is not there";
    known = id;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> faultOf(const NetworkSize& size, const Snapshot& snapshot) {
  const Broken& broken = *snapshot.broken;
  if (snapshot.positions.size() != size.nodes || snapshot.velocities.size() != size.nodes ||
      broken.fragmentOfNode.size() != size.nodes)
    return "it has another number of nodes than the network";
  if (broken.bonds.size() != size.bonds) return "it has another number of bonds than the network";
  if (broken.cells.size() != size.cells) return "it has another number of cells than the network";
  if (broken.fragments.size() > size.nodes) return "it has more fragments than nodes";
  if (!std::ranges::equal(snapshot.fragments, broken.fragments, {}, &MovingFragment::id, &Fragment::id))
    return "other fragments move than there are";
  if (!std::isfinite(snapshot.time)) return "its time is not finite";
  return faultOfFragments(size, broken);
}

std::optional<std::string> faultOf(const NetworkSize& size, const std::vector<BreakEvent>& events) {
  if (events.size() > size.bonds) return "more bonds broke between two frames than there are";
  const auto improper = [&size](const BreakEvent& event) {
    return event.bond >= size.bonds || event.a >= size.nodes || event.b >= size.nodes ||
           (event.cell != kNone && event.cell >= size.cells) || !std::isfinite(event.time);
  };
  const auto found = std::ranges::find_if(events, improper);
  if (found == events.end()) return std::nullopt;
  return "break event " + std::to_string(found - events.begin()) + " names what is not in the network";
}

ByteWriter encodeBreakage(const Broken& broken) {
  ByteWriter writer;
  putPlanes(writer, broken.fragmentOfNode);
  putFlags(writer, broken.bonds);
  putFlags(writer, broken.cells);
  putColumn(writer, broken.fragments, &Fragment::id);
  putColumn(writer, broken.fragments, &Fragment::parent);
  putColumn(writer, broken.fragments, &Fragment::born);
  putColumn(writer, broken.fragments, &Fragment::nodeCount);
  putColumn(writer, broken.fragments, &Fragment::mass);
  return writer;
}

ByteWriter encodeFrame(const Snapshot& snapshot) {
  ByteWriter writer;
  putMoment(writer, snapshot);
  putPlanes(writer, snapshot.positions);
  putPlanes(writer, snapshot.velocities);
  putFragments(writer, snapshot);
  return writer;
}

std::vector<std::uint8_t> changedNodes(const Snapshot& snapshot, const WholeFrame& whole) {
  std::vector<std::uint8_t> changed(snapshot.positions.size(), 1);
  if (whole.positions.size() != changed.size()) return changed;
  for (std::size_t node = 0; node < changed.size(); ++node) {
    if (sameBits(snapshot.positions[node], whole.positions[node]) &&
        sameBits(snapshot.velocities[node], whole.velocities[node]))
      changed[node] = 0;
  }
  return changed;
}

ByteWriter encodeChange(const Snapshot& snapshot, std::uint64_t whole,
                        const std::vector<std::uint8_t>& changed) {
  std::vector<Vec3> positions;
  std::vector<Vec3> velocities;
  for (std::size_t node = 0; node < changed.size(); ++node) {
    if (changed[node] == 0) continue;
    positions.push_back(snapshot.positions[node]);
    velocities.push_back(snapshot.velocities[node]);
  }
  ByteWriter writer;
  writer.put(whole);
  putMoment(writer, snapshot);
  putFlags(writer, changed);
  putPlanes(writer, positions);
  putPlanes(writer, velocities);
  putFragments(writer, snapshot);
  return writer;
}

std::optional<std::uint64_t> wholeFrameOf(std::span<const std::byte> change) {
  ByteReader reader(change);
  std::uint64_t whole = 0;
  if (!reader.read(whole)) return std::nullopt;
  return whole;
}

Result<BrokenPointer> decodeBreakage(const NetworkSize& size, std::span<const std::byte> breakage) {
  Broken broken;
  ByteReader reader(breakage);
  readPlanes(reader, broken.fragmentOfNode, size.nodes);
  readFlags(reader, broken.bonds, size.bonds);
  readFlags(reader, broken.cells, size.cells);
  readFirstColumn(reader, broken.fragments, &Fragment::id, size.nodes);
  readColumn(reader, broken.fragments, &Fragment::parent);
  readColumn(reader, broken.fragments, &Fragment::born);
  readColumn(reader, broken.fragments, &Fragment::nodeCount);
  readColumn(reader, broken.fragments, &Fragment::mass);
  if (!reader.finished()) return Problem{"", "its record of what is broken is damaged", ""};
  return sealed(std::move(broken));
}

Result<Snapshot> decodeSnapshot(const NetworkSize& size, std::span<const std::byte> frame,
                                const BrokenPointer& broken) {
  Snapshot snapshot = stillOf(broken);
  ByteReader frameReader(frame);
  readFrame(frameReader, size, snapshot);
  if (!frameReader.finished()) return Problem{"", "its record of what moves is damaged", ""};
  if (const auto fault = faultOf(size, snapshot)) return Problem{"", *fault, ""};
  return snapshot;
}

Result<Snapshot> decodeSnapshot(const NetworkSize& size, std::span<const std::byte> change,
                                std::span<const std::byte> whole, const BrokenPointer& broken) {
  Snapshot snapshot = stillOf(broken);
  // What follows in the whole frame is of fragments as they were then.
  ByteReader wholeReader(whole);
  readMoment(wholeReader, snapshot);
  readMotion(wholeReader, size, snapshot);
  if (!wholeReader.ok()) return Problem{"", "the frame it leans on is damaged", ""};
  ByteReader changeReader(change);
  readChange(changeReader, size, snapshot);
  if (!changeReader.finished()) return Problem{"", "its record of what moves is damaged", ""};
  if (const auto fault = faultOf(size, snapshot)) return Problem{"", *fault, ""};
  return snapshot;
}

ByteWriter encodeEvents(const std::vector<BreakEvent>& events) {
  ByteWriter writer;
  putColumn(writer, events, &BreakEvent::time);
  putColumn(writer, events, &BreakEvent::bond);
  putColumn(writer, events, &BreakEvent::a);
  putColumn(writer, events, &BreakEvent::b);
  putColumn(writer, events, &BreakEvent::strain);
  putColumn(writer, events, &BreakEvent::cell);
  return writer;
}

Result<std::vector<BreakEvent>> decodeEvents(const NetworkSize& size, std::span<const std::byte> content) {
  std::vector<BreakEvent> events;
  ByteReader reader(content);
  readFirstColumn(reader, events, &BreakEvent::time, size.bonds);
  readColumn(reader, events, &BreakEvent::bond);
  readColumn(reader, events, &BreakEvent::a);
  readColumn(reader, events, &BreakEvent::b);
  readColumn(reader, events, &BreakEvent::strain);
  readColumn(reader, events, &BreakEvent::cell);
  if (!reader.finished()) return Problem{"", "its record of breaks is damaged", ""};
  if (const auto fault = faultOf(size, events)) return Problem{"", *fault, ""};
  return events;
}

}  // namespace sim
