#include "sim/dynamics/checkpoint.h"

#include <algorithm>
#include <cmath>

#include <xxhash.h>

#include "sim/skipping/review.h"

namespace sim {
namespace {

/// Changes with the layout of checkpoints, so that a run is never resumed from one it cannot read.
constexpr std::uint32_t kCheckpointVersion = 11;

const Problem kDamaged{"checkpoint", "it does not belong to this network, or is damaged",
                       "resume from an earlier one, or run again"};

const Problem kOlder{"checkpoint",
                     "another version of the program wrote it, in a form that this one does not continue",
                     "go on from a frame in a take beside it, by --from or --time, or run again"};

void saveVectors(ByteWriter& writer, const NodeVectors& vectors) {
  for (std::size_t k = 0; k < 3; ++k)
    writer.putVector(std::vector<double>(vectors.axis(k), vectors.axis(k) + vectors.size()));
}

bool loadNumbers(ByteReader& reader, std::size_t count, std::vector<double>& numbers) {
  return reader.readVector(numbers) && numbers.size() == count &&
         std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

bool loadVectors(ByteReader& reader, NodeVectors& vectors) {
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<double> axis;
    if (!loadNumbers(reader, vectors.size(), axis)) return false;
    std::copy(axis.begin(), axis.end(), vectors.axis(k));
  }
  return true;
}

bool loadFlags(ByteReader& reader, std::size_t count, std::vector<std::uint8_t>& flags) {
  return reader.readVector(flags) && flags.size() == count;
}

void saveClock(ByteWriter& writer, const Clock& clock) {
  writer.put(clock.segmentStart);
  writer.put(clock.segmentSteps);
  writer.put(clock.step);
  writer.put(clock.wanted);
  writer.put(clock.last);
}

bool loadClock(ByteReader& reader, Clock& clock) {
  reader.read(clock.segmentStart);
  reader.read(clock.segmentSteps);
  reader.read(clock.step);
  reader.read(clock.wanted);
  reader.read(clock.last);
  const bool finite = std::isfinite(clock.segmentStart) && std::isfinite(clock.step) &&
                      std::isfinite(clock.wanted) && std::isfinite(clock.last);
  return reader.ok() && finite && clock.step > 0.0 && clock.wanted > 0.0;
}

void saveComponents(ByteWriter& writer, const Components& components) {
  writer.putVector(components.fragmentOfNode());
  writer.put<std::uint64_t>(components.births().size());
  for (const FragmentBirth& birth : components.births()) {
    writer.put(birth.parent);
    writer.put(birth.born);
    writer.put(birth.nodeCount);
  }
}

bool loadComponents(ByteReader& reader, std::size_t nodeCount, std::vector<FragmentId>& fragmentOfNode,
                    std::vector<FragmentBirth>& births) {
  std::uint64_t count = 0;
  reader.readVector(fragmentOfNode);
  reader.read(count);
  // Each fragment has a node at least.
  if (fragmentOfNode.size() != nodeCount || count > nodeCount) return false;
  births.resize(static_cast<std::size_t>(count));
  for (FragmentBirth& birth : births) {
    reader.read(birth.parent);
    reader.read(birth.born);
    reader.read(birth.nodeCount);
  }
  return reader.ok() &&
         std::ranges::all_of(fragmentOfNode, [&](FragmentId id) { return id < births.size(); });
}

/// What is read of a checkpoint, aside from the World: what cannot be resumed leaves a run as it was.
struct Loaded {
  Clock clock;
  Motion now;
  std::vector<std::uint8_t> brokenBonds;
  std::vector<std::uint8_t> brokenCells;
  std::vector<double> restLengths;
  std::vector<FragmentId> fragmentOfNode;
  std::vector<FragmentBirth> births;
  SavedFragments fragments;
  Contacts contacts;
  double controlsTime = 0.0;
  Ledger ledger;
  Work work;
  StepLength length;
};

bool load(ByteReader& reader, const World& world, Loaded& loaded) {
  const Network& network = world.network;
  return loadClock(reader, loaded.clock) && loadVectors(reader, loaded.now.position) &&
         loadVectors(reader, loaded.now.velocity) &&
         loadFlags(reader, network.bondCount(), loaded.brokenBonds) &&
         loadFlags(reader, network.cellCount(), loaded.brokenCells) &&
         loadNumbers(reader, world.layout.plasticRestLengths().size(), loaded.restLengths) &&
         loadComponents(reader, network.nodeCount(), loaded.fragmentOfNode, loaded.births) &&
         readFragments(reader, network.nodeCount(), loaded.births.size(), loaded.fragments) &&
         loaded.contacts.load(reader, world.controls.colliders()) && reader.read(loaded.controlsTime) &&
         std::isfinite(loaded.controlsTime) && loaded.ledger.load(reader) && reader.read(loaded.work) &&
         loaded.length.load(reader) && reader.finished();
}

void restore(Loaded loaded, World& world, StepLength& length) {
  world.clock = loaded.clock;
  world.now = std::move(loaded.now);
  world.next = world.now;
  world.layout = layoutOf(world.network, loaded.brokenBonds, loaded.restLengths);
  world.breakage.restore(std::move(loaded.brokenBonds), std::move(loaded.brokenCells));
  world.work = loaded.work;
  world.components.restore(std::move(loaded.fragmentOfNode), std::move(loaded.births), world.work.labelings);
  world.contacts = std::move(loaded.contacts);
  world.forces.forgetRows();
  restoreFragments(world, std::move(loaded.fragments));
  world.controlsTime = loaded.controlsTime;
  world.controls.moveTo(world.controlsTime);
  world.controls.setFlow(world.network, world.clock.step);
  world.ledger = loaded.ledger;
  world.events.clear();
  length = loaded.length;
  length.setCountsLattice(latticeMoves(world));
}

/// The last bytes are the hash of all before them.
constexpr std::size_t kSealBytes = sizeof(XXH64_hash_t);

bool isSealed(std::span<const std::byte> checkpoint) {
  if (checkpoint.size() < kSealBytes) return false;
  const std::size_t size = checkpoint.size() - kSealBytes;
  XXH64_hash_t seal = 0;
  ByteReader(checkpoint.subspan(size)).read(seal);
  return seal == XXH3_64bits(checkpoint.data(), size);
}

}  // namespace

std::vector<std::byte> saveCheckpoint(const World& world, const StepLength& length) {
  ByteWriter writer;
  writer.put(kCheckpointVersion);
  saveClock(writer, world.clock);
  saveVectors(writer, world.now.position);
  saveVectors(writer, world.now.velocity);
  writer.putVector(world.breakage.brokenBonds());
  writer.putVector(world.breakage.brokenCells());
  writer.putVector(world.layout.plasticRestLengths());
  saveComponents(writer, world.components);
  saveFragments(writer, world.fragments);
  world.contacts.save(writer);
  writer.put(world.controlsTime);
  world.ledger.save(writer);
  writer.put(world.work);
  length.save(writer);
  writer.put(XXH3_64bits(writer.bytes().data(), writer.size()));
  return std::move(writer).take();
}

Status loadCheckpoint(std::span<const std::byte> checkpoint, World& world, StepLength& length) {
  if (!isSealed(checkpoint)) return kDamaged;
  ByteReader reader(checkpoint.first(checkpoint.size() - kSealBytes));
  std::uint32_t version = 0;
  if (!reader.read(version)) return kDamaged;
  if (version != kCheckpointVersion) return kOlder;
  Loaded loaded{.clock = {},
                .now = world.now,
                .brokenBonds = {},
                .brokenCells = {},
                .restLengths = {},
                .fragmentOfNode = {},
                .births = {},
                .fragments = {},
                .contacts = world.contacts,
                .ledger = world.ledger,
                .work = {},
                .length = length};
  if (!load(reader, world, loaded)) return kDamaged;
  restore(std::move(loaded), world, length);
  return Done{};
}

BondLayout layoutOf(const Network& network, std::span<const std::uint8_t> brokenBonds,
                    std::span<const double> restLengths) {
  BondLayout layout(network);
  for (BondIndex bond = 0; bond < network.bondCount(); ++bond) {
    if (brokenBonds[bond] != 0) layout.remove(network, bond);
  }
  layout.setPlasticRestLengths(restLengths);
  return layout;
}

std::uint64_t hashOf(const World& world) {
  XXH3_state_t* state = XXH3_createState();
  XXH3_64bits_reset(state);
  for (const NodeVectors* vectors : {&world.now.position, &world.now.velocity}) {
    for (std::size_t k = 0; k < 3; ++k)
      XXH3_64bits_update(state, vectors->axis(k), vectors->size() * sizeof(double));
  }
  const std::vector<std::uint8_t> broken = world.breakage.brokenBonds();
  XXH3_64bits_update(state, broken.data(), broken.size());
  const double moment = world.time();
  XXH3_64bits_update(state, &moment, sizeof moment);
  const std::uint64_t hash = XXH3_64bits_digest(state);
  XXH3_freeState(state);
  return hash;
}

}  // namespace sim
