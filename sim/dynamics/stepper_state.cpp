#include <xxhash.h>

#include "sim/dynamics/stepper.h"

namespace sim {
namespace {

/// Changes with the layout of checkpoints, so that a run is never resumed from one it cannot read.
constexpr std::uint32_t kCheckpointVersion = 1;

const Problem kDamaged{"checkpoint", "it does not belong to this network, or is damaged",
                       "resume from an earlier one, or run again"};

void saveVectors(ByteWriter& writer, const NodeVectors& vectors) {
  for (std::size_t k = 0; k < 3; ++k)
    writer.putVector(std::vector<double>(vectors.axis(k), vectors.axis(k) + vectors.size()));
}

bool loadVectors(ByteReader& reader, NodeVectors& vectors) {
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<double> axis;
    if (!reader.readVector(axis) || axis.size() != vectors.size()) return false;
    std::copy(axis.begin(), axis.end(), vectors.axis(k));
  }
  return true;
}

}  // namespace

std::uint64_t Stepper::stateHash() const {
  XXH3_state_t* state = XXH3_createState();
  XXH3_64bits_reset(state);
  for (const NodeVectors* vectors : {&now_.position, &now_.velocity}) {
    for (std::size_t k = 0; k < 3; ++k)
      XXH3_64bits_update(state, vectors->axis(k), vectors->size() * sizeof(double));
  }
  XXH3_64bits_update(state, breakage_.brokenBonds().data(), breakage_.brokenBonds().size());
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
  writer.putVector(components_.fragmentOfNode());
  writer.put<std::uint64_t>(components_.births().size());
  for (const FragmentBirth& birth : components_.births()) {
    writer.put(birth.parent);
    writer.put(birth.born);
    writer.put(birth.nodeCount);
  }
  writer.putVector(layout_.plasticRestLengths());
  contacts_.save(writer);
  ledger_.save(writer);
  writer.put(work_);
  for (const double value : {segmentStart_, step_, lastStep_, controlsTime_}) writer.put(value);
  writer.put(segmentSteps_);
  return std::move(writer).take();
}

Status Stepper::restore(std::span<const std::byte> checkpoint) {
  ByteReader reader(checkpoint);
  std::uint32_t version = 0;
  if (!reader.read(version) || version != kCheckpointVersion) return kDamaged;
  if (!loadVectors(reader, now_.position) || !loadVectors(reader, now_.velocity)) return kDamaged;
  std::vector<std::uint8_t> brokenBonds;
  std::vector<std::uint8_t> brokenCells;
  std::vector<FragmentId> fragmentOfNode;
  reader.readVector(brokenBonds);
  reader.readVector(brokenCells);
  reader.readVector(fragmentOfNode);
  if (brokenBonds.size() != network_.bondCount() || brokenCells.size() != network_.cellCount() ||
      fragmentOfNode.size() != network_.nodeCount()) {
    return kDamaged;
  }
  std::uint64_t births = 0;
  reader.read(births);
  std::vector<FragmentBirth> fragments;
  for (std::uint64_t f = 0; f < births && reader.ok(); ++f) {
    FragmentBirth birth;
    reader.read(birth.parent);
    reader.read(birth.born);
    reader.read(birth.nodeCount);
    fragments.push_back(birth);
  }
  for (const FragmentId id : fragmentOfNode) {
    if (id >= fragments.size()) return kDamaged;
  }
  std::vector<double> restLengths;
  reader.readVector(restLengths);
  if (restLengths.size() != layout_.plasticRestLengths().size()) return kDamaged;
  if (!contacts_.load(reader, controls_.colliders().size()) || !ledger_.load(reader)) return kDamaged;
  reader.read(work_);
  for (double* value : {&segmentStart_, &step_, &lastStep_, &controlsTime_}) reader.read(*value);
  reader.read(segmentSteps_);
  if (!reader.finished()) return kDamaged;

  // Bonds leave the layout in any order: what remains keeps its own.
  layout_ = BondLayout(network_);
  for (BondIndex bond = 0; bond < network_.bondCount(); ++bond) {
    if (brokenBonds[bond] != 0) layout_.remove(network_, bond);
  }
  layout_.setPlasticRestLengths(restLengths);
  breakage_.restore(std::move(brokenBonds), std::move(brokenCells));
  components_.restore(std::move(fragmentOfNode), std::move(fragments), work_.labelings);
  controls_.moveTo(controlsTime_);
  controls_.setFlow(network_, step_);
  next_ = now_;
  events_.clear();
  return Done{};
}

std::size_t Stepper::memoryBytes() const {
  const std::size_t motion = 4 * now_.position.memoryBytes() + 2 * forces_.total.memoryBytes();
  return sizeof(*this) + network_.memoryBytes() + layout_.memoryBytes() + breakage_.memoryBytes() +
         components_.memoryBytes() + contacts_.memoryBytes() + motion +
         inverseMasses_.capacity() * sizeof(double) + reports_.capacity() * sizeof(BlockReport) +
         forces_.touched.capacity() + events_.capacity() * sizeof(BreakEvent);
}

}  // namespace sim
