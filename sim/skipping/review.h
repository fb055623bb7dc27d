#pragma once

#include "sim/base/bytes.h"
#include "sim/world/world.h"

/// When it is decided which fragments deform, go as rigid bodies or sleep (docs/numerics.md, "What is
/// skipped"). Raw networks, without cells, always deform: they are experiments with springs. So does what is
/// held.
namespace sim {

/// Fragments are looked at every so many steps.
inline constexpr std::uint64_t kStepsPerReview = 64;

/// A run begins: all fragments deform.
void beginSkipping(World& world);
/// Looks who has come to rest and who flies freely. To be called every kStepsPerReview steps, or more rarely.
void reviewFragments(World& world);
/// Fragments were born at `time`, s.
void noteFragmentBirths(World& world, double time);
/// The contact rows are new.
void noteNewRows(World& world);

void saveFragments(ByteWriter& writer, const FragmentMotions& fragments);
/// What a checkpoint holds of FragmentMotions.
struct SavedFragments {
  std::vector<FragmentState> states;
  std::vector<FragmentRecord> records;
  std::vector<FragmentNeighbours> neighbours;
  std::vector<RigidBody> bodies;
  double peakSpeed = 0.0;  ///< cm/s
};
/// False when it cannot have come from saveFragments() of such a network with so many fragments.
bool readFragments(ByteReader& reader, std::size_t nodes, std::size_t fragments, SavedFragments& saved);
/// After everything else in the World was restored.
void restoreFragments(World& world, SavedFragments saved);

}  // namespace sim
