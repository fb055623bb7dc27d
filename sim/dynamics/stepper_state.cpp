#include <algorithm>
#include <array>
#include <cmath>

#include <xxhash.h>

#include "sim/dynamics/stepper.h"

namespace sim {
namespace {

/// Changes with the layout of checkpoints, so that a run is never resumed from one it cannot read.
constexpr std::uint32_t kCheckpointVersion = 8;

const Problem kDamaged{"checkpoint", "it does not belong to this network, or is damaged",
                       "resume from an earlier one, or run again"};

void saveVectors(ByteWriter& writer, const NodeVectors& vectors) {
  for (std::size_t k = 0; k < 3; ++k)
    writer.putVector(std::vector<double>(vectors.axis(k), vectors.axis(k) + vectors.size()));
}

bool loadNumbers(ByteReader& reader, std::size_t count, std::vector<double>& numbers) {
  return reader.readVector(numbers) && numbers.size() == count &&
         std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
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

void saveFragments(ByteWriter& writer, const Components& components) {
  writer.putVector(components.fragmentOfNode());
  writer.put<std::uint64_t>(components.births().size());
  for (const FragmentBirth& birth : components.births()) {
    writer.put(birth.parent);
    writer.put(birth.born);
    writer.put(birth.nodeCount);
  }
}

bool loadFragments(ByteReader& reader, std::size_t nodeCount, std::vector<FragmentId>& fragmentOfNode,
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
  return reader.ok() && std::all_of(fragmentOfNode.begin(), fragmentOfNode.end(),
                                    [&](FragmentId id) { return id < births.size(); });
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

std::uint64_t Stepper::stateHash() const {
  XXH3_state_t* state = XXH3_createState();
  XXH3_64bits_reset(state);
  for (const NodeVectors* vectors : {&now_.position, &now_.velocity}) {
    for (std::size_t k = 0; k < 3; ++k)
      XXH3_64bits_update(state, vectors->axis(k), vectors->size() * sizeof(double));
  }
  const std::vector<std::uint8_t> broken = breakage_.brokenBonds();
  XXH3_64bits_update(state, broken.data(), broken.size());
  const double moment = time();
  XXH3_64bits_update(state, &moment, sizeof moment);
  const std::uint64_t hash = XXH3_64bits_digest(state);
  XXH3_freeState(state);
  return hash;
}

std::vector<std::byte> Stepper::checkpoint() const {
  ByteWriter writer;
  writer.put(kCheckpointVersion);
  saveVectors(writer, now_.position);
  saveVectors(writer, now_.velocity);
  writer.putVector(breakage_.brokenBonds());
  writer.putVector(breakage_.brokenCells());
  saveFragments(writer, components_);
  writer.putVector(layout_.plasticRestLengths());
  contacts_.save(writer);
  fragments_.save(writer);
  writer.put(settings_.precision);
  if (reference_) reference_->save(writer);
  ledger_.save(writer);
  writer.put(work_);
  for (const double value :
       {segmentStart_, step_, lastStep_, controlsTime_, wantedStep_, toleratedStep_, largestStrain_})
    writer.put(value);
  writer.put(segmentSteps_);
  writer.put(XXH3_64bits(writer.bytes().data(), writer.size()));
  return std::move(writer).take();
}

/// Bonds leave the layout in any order: what remains keeps its own.
void Stepper::layOut(std::span<const std::uint8_t> brokenBonds, std::span<const double> restLengths) {
  layout_ = BondLayout(network_, {settings_.skip.thresholds, settings_.skip.damping}, settings_.precision);
  for (BondIndex bond = 0; bond < network_.bondCount(); ++bond) {
    if (brokenBonds[bond] != 0) layout_.remove(network_, bond);
  }
  layout_.setPlasticRestLengths(restLengths);
}

Status Stepper::restore(std::span<const std::byte> checkpoint) {
  if (!isSealed(checkpoint)) return kDamaged;
  ByteReader reader(checkpoint.first(checkpoint.size() - kSealBytes));
  std::uint32_t version = 0;
  if (!reader.read(version) || version != kCheckpointVersion) return kDamaged;

  // Everything is read aside, so that what cannot be resumed leaves this run as it was.
  Motion now = now_;
  if (!loadVectors(reader, now.position) || !loadVectors(reader, now.velocity)) return kDamaged;
  std::vector<std::uint8_t> brokenBonds;
  std::vector<std::uint8_t> brokenCells;
  if (!loadFlags(reader, network_.bondCount(), brokenBonds) ||
      !loadFlags(reader, network_.cellCount(), brokenCells)) {
    return kDamaged;
  }
  std::vector<FragmentId> fragmentOfNode;
  std::vector<FragmentBirth> fragments;
  if (!loadFragments(reader, network_.nodeCount(), fragmentOfNode, fragments)) return kDamaged;
  std::vector<double> restLengths;
  if (!loadNumbers(reader, layout_.plasticRestLengths().size(), restLengths)) return kDamaged;
  Contacts contacts = contacts_;
  Ledger ledger = ledger_;
  FragmentStates::Saved states;
  if (!contacts.load(reader, controls_.colliders()) ||
      !FragmentStates::read(reader, network_.nodeCount(), fragments.size(), states))
    return kDamaged;
  Precision precision{};
  std::vector<ReferenceFrame> frames;
  if (!reader.read(precision) || precision != settings_.precision ||
      (reference_ && !ReferenceFrames::read(reader, fragments.size(), frames)) || !ledger.load(reader))
    return kDamaged;
  Work work;
  reader.read(work);
  std::array<double, 7> times{};
  for (double& value : times) reader.read(value);
  std::uint64_t segmentSteps = 0;
  reader.read(segmentSteps);
  const bool finite =
      std::all_of(times.begin(), times.end(), [](double value) { return std::isfinite(value); });
  if (!reader.finished() || !finite || times[1] <= 0.0 || times[4] <= 0.0 || times[5] <= 0.0) return kDamaged;

  now_ = std::move(now);
  next_ = now_;
  contacts_ = std::move(contacts);
  forces_.forgetRows();
  ledger_ = ledger;
  work_ = work;
  segmentStart_ = times[0];
  step_ = times[1];
  lastStep_ = times[2];
  controlsTime_ = times[3];
  wantedStep_ = times[4];
  toleratedStep_ = times[5];
  largestStrain_ = times[6];
  startKnown_ = false;
  segmentSteps_ = segmentSteps;
  layOut(brokenBonds, restLengths);
  breakage_.restore(std::move(brokenBonds), std::move(brokenCells));
  components_.restore(std::move(fragmentOfNode), std::move(fragments), work_.labelings);
  fragments_.restore(std::move(states));
  if (reference_) reference_->restore(std::move(frames), components_);
  fittedVersion_ = fragments_.activity().version();
  latticeCounts_ = latticeMoves();
  controls_.moveTo(controlsTime_);
  controls_.setFlow(network_, step_);
  events_.clear();
  return Done{};
}

std::size_t Stepper::memoryBytes() const {
  const std::size_t motion = 4 * now_.position.memoryBytes() + 2 * forces_.total.memoryBytes();
  const std::size_t method = startRates_.acceleration.memoryBytes() + endRates_.acceleration.memoryBytes() +
                             (oneStep_ ? oneStep_->memoryBytes() : 0);
  const std::size_t reference = reference_ ? reference_->memoryBytes() : 0;
  return sizeof(*this) + method + reference + network_.memoryBytes() + layout_.memoryBytes() +
         breakage_.memoryBytes() + components_.memoryBytes() + fragments_.memoryBytes() +
         contacts_.memoryBytes() + motion + inverseMasses_.capacity() * sizeof(double) +
         reports_.capacity() * sizeof(BlockReport) + forces_.touched.capacity() +
         events_.capacity() * sizeof(BreakEvent);
}

}  // namespace sim
