#include "sim/skipping/review.h"

#include <algorithm>
#include <cmath>

#include "sim/skipping/bodies.h"
#include "sim/skipping/freezing.h"
#include "sim/skipping/sleeping.h"
#include "sim/skipping/transitions.h"

namespace sim {
namespace {

/// Only what is free and made of cells may be skipped.
void findSkippable(World& world) {
  const Network& network = world.network;
  std::vector<std::uint8_t> solid(network.partNames.size(), 0);
  for (const CellCorners& corners : network.cells) solid[network.nodeParts[corners[0]]] = 1;
  for (FragmentRecord& record : world.fragments.records) record.skippable = 1;
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const bool held = !std::isfinite(network.masses[node]);
    if (held || solid[network.nodeParts[node]] == 0)
      world.fragments.records[world.components.of(node)].skippable = 0;
  }
}

std::vector<FragmentSums> sumAndNotePeak(World& world) {
  std::vector<FragmentSums> sums = sumFragments(world);
  world.fragments.peakSpeed = std::max(world.fragments.peakSpeed, meanSpeed(sums));
  return sums;
}

}  // namespace

void beginSkipping(World& world) {
  double length = 0.0;
  for (const float radius : world.network.radii) length += static_cast<double>(radius);
  world.fragments.typicalLength = length / static_cast<double>(world.network.nodeCount());
  noteFragmentBirths(world, 0.0);
  findSkippable(world);
}

void noteFragmentBirths(World& world, double time) {
  world.fragments.activity.noteBirths(world.components);
  std::vector<FragmentRecord>& records = world.fragments.records;
  const std::size_t known = records.size();
  records.resize(world.components.births().size());
  bool heldBroke = false;
  for (std::size_t fragment = known; fragment < records.size(); ++fragment) {
    FragmentRecord& record = records[fragment];
    record.stillSince = time;
    const FragmentId parent = world.components.births()[fragment].parent;
    if (parent == kNone) continue;
    record.past = records[parent].past = FragmentRecord::Past::broken;
    record.skippable = records[parent].skippable;
    // What broke off a held body may itself be free.
    heldBroke |= record.skippable == 0;
  }
  if (heldBroke) findSkippable(world);
}

void reviewFragments(World& world) {
  const double time = world.time();
  world.fragments.activity.listNodes(world.components);
  const std::vector<FragmentSums> sums = sumAndNotePeak(world);
  noteNeighbours(world, sums);
  meltStruck(world, time);
  if (world.settings.skip.sleep) {
    wakeByContact(world, sums, time);
    fallAsleep(world, sums, time);
  }
  if (world.settings.skip.rigid)
    freezeCalm(world, time, static_cast<double>(kStepsPerReview) * world.clock.step);
  refreshStates(world);
}

void noteNewRows(World& world) {
  const double time = world.time();
  meltStruck(world, time);
  if (world.fragments.activity.any(FragmentState::asleep)) {
    const std::vector<FragmentSums> sums = sumAndNotePeak(world);
    noteNeighbours(world, sums);
    wakeByContact(world, sums, time);
  }
  refreshStates(world);
}

void saveFragments(ByteWriter& writer, const FragmentMotions& fragments) {
  writer.putVector(fragments.activity.states());
  writer.putVector(fragments.records);
  writer.putVector(fragments.neighbours);
  writer.put<std::uint64_t>(fragments.bodies.size());
  for (const RigidBody& body : fragments.bodies) body.save(writer);
  writer.put(fragments.peakSpeed);
}

bool readFragments(ByteReader& reader, std::size_t nodes, std::size_t fragments, SavedFragments& saved) {
  reader.readVector(saved.states);
  reader.readVector(saved.records);
  reader.readVector(saved.neighbours);
  std::uint64_t bodies = 0;
  reader.read(bodies);
  const auto known = [](FragmentState state) { return static_cast<std::size_t>(state) < kFragmentStates; };
  const auto named = [&](const FragmentNeighbours& pair) { return pair.a < fragments && pair.b < fragments; };
  const auto rigid = std::ranges::count(saved.states, FragmentState::rigid);
  if (saved.states.size() != fragments || saved.records.size() != fragments ||
      !std::ranges::all_of(saved.neighbours, named) || bodies != static_cast<std::uint64_t>(rigid) ||
      !std::ranges::all_of(saved.states, known))
    return reader.fail();
  saved.bodies.resize(static_cast<std::size_t>(bodies));
  for (RigidBody& body : saved.bodies) {
    if (!body.load(reader, nodes) || body.fragment() >= fragments ||
        saved.states[body.fragment()] != FragmentState::rigid)
      return reader.fail();
  }
  return reader.read(saved.peakSpeed);
}

void restoreFragments(World& world, SavedFragments saved) {
  FragmentMotions& fragments = world.fragments;
  fragments.records = std::move(saved.records);
  fragments.neighbours = std::move(saved.neighbours);
  fragments.bodies = std::move(saved.bodies);
  fragments.peakSpeed = saved.peakSpeed;
  fragments.activity.restore(std::move(saved.states), world.components);
  fragments.activity.listNodes(world.components);
  fragments.bonds = {};
  for (FragmentId fragment = 0; fragment < fragments.records.size(); ++fragment) {
    const std::span<const NodeIndex> nodes = fragments.activity.nodesOf(fragment);
    releaseNodes(world, nodes);
    if (fragments.activity.deforms(fragment)) continue;
    fragments.bonds[static_cast<std::size_t>(fragments.activity.stateOf(fragment))] +=
        fragments.records[fragment].bonds;
    holdNodes(world, nodes);
  }
  placeTouched(world);
  fragments.stillElastic.reset();
}

}  // namespace sim
