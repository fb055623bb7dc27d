#pragma once

#include <cstddef>
#include <cstdint>

#include "sim/base/blocks.h"

/// The inner loop: forces of intact bonds, and the step of the nodes they pull. This header and the kernels
/// include nothing of Eigen or the standard containers: the kernels are compiled for several instruction
/// sets, and an inline function shared with the rest of the program could be linked in the wrong one.
namespace sim {

/// Lane constants of a slot whose bonds differ.
struct SlotLanes {
  double stiffness[kBlockNodes];   ///< dyn/cm
  double restLength[kBlockNodes];  ///< cm; flows in plastic materials
  double damping[kBlockNodes];     ///< g/s
};

/// Constants that all bonds of a slot share.
struct SlotConstants {
  double stiffness = 0.0;   ///< dyn/cm
  double restLength = 0.0;  ///< cm
  double damping = 0.0;     ///< g/s
};

/// One direction of a block: at most one bond of each of its nodes, to the node at `where` behind it
/// (contiguous) or named lane by lane (gathered). Every bond appears twice, once from each end, so that each
/// node gathers the whole force on it in a fixed order and nothing is scattered. A quarter of a cache line:
/// large bodies are bound by reading these.
struct BondSlot {
  std::int32_t where = 0;       ///< offset of the neighbour's index; gathered: place of sixteen indices
  std::uint32_t constants = 0;  ///< index of SlotConstants; varied: of SlotLanes
  /// Rest length over the length at which the first of the lanes may break: at most 1, and 0 where nothing
  /// here can. Rounded so that no break is missed; the exact test follows.
  float breakRatio = 0.0F;
  std::uint16_t live = 0;  ///< bit a lane: its bond is there and whole
  std::uint8_t material = 0;
  bool gathered : 1;
  bool varied : 1;
  bool plastic : 1;
  bool damped : 1;  ///< some lane has a damper
  bool tested : 1;  ///< this end of the bonds tests them for breaking (the other end need not)
};
static_assert(sizeof(BondSlot) == 16);

/// How the present moment changes a material.
struct MaterialNow {
  double stiffnessScale = 1.0;
  double dampingScale = 1.0;
  double yieldStrain = 0.0;
  double flow = 0.0;  ///< share of the excess strain that flows in this step, at most 1
};

struct NodeArrays {
  const double* position[3];
  const double* velocity[3];
};

/// One step of the blocks [firstBlock, lastBlock): a = gravity + force / m; v' = v + kick a; x' = x + drift
/// w, where w is v' (Verlet, symplectic Euler) or v (forward Euler as the paper prints it).
struct KernelStep {
  const BondSlot* slots;
  const std::uint32_t* firstSlot;  ///< a block's slots are [firstSlot[b], firstSlot[b] + slotCount[b])
  const std::uint16_t* slotCount;
  const SlotConstants* constants;
  SlotLanes* lanes;
  const std::uint32_t* gathers;  ///< sixteen neighbour indices each

  NodeArrays now;
  double* nextPosition[3];
  double* nextVelocity[3];
  const double* inverseMass;        ///< 1/g; zero for held nodes and padding
  const double* external[3];        ///< dyn, of contacts and colliders
  const double* externalLossy[3];   ///< the part of `external` that is not conservative
  const std::uint8_t* hasExternal;  ///< one byte a block
  /// Bit a lane: its bonds are evaluated. Both ends of a bond are, or neither. A node that is not awake has
  /// no velocity here and an inverse mass of zero, so that it stays where it is.
  const std::uint16_t* awake;

  double gravity[3];
  double kick = 0.0;   ///< s
  double drift = 0.0;  ///< s
  bool driftByOldVelocity = false;
  bool flowing = false;           ///< let rest lengths flow in this pass
  bool accelerationOnly = false;  ///< write a (cm/s^2) to nextVelocity and leave positions alone
  const MaterialNow* materials;
};

/// What a block reports of a step.
struct BlockReport {
  double largestSpeedSquared = 0.0;  ///< cm^2/s^2 of v'; not finite when something blew up
  double dissipated =
      0.0;               ///< erg: work against dampers, friction and plastic flow; erg/s if accelerationOnly
  bool suspect = false;  ///< some bond is stretched past the smallest threshold of its slot
};

using StepBlocks = void (*)(const KernelStep& step, std::size_t firstBlock, std::size_t lastBlock,
                            BlockReport* reports);

/// Kernels: the same source compiled for plain x86-64 (or any processor), AVX2 and AVX-512. Each gives the
/// same bits whatever the number of threads; from one to the other results differ by rounding, since AVX2 and
/// AVX-512 multiply and add at once, and AVX-512 refines an estimate of 1 / r instead of dividing by a root.
enum class KernelKind { automatic, plain, avx2, avx512 };

/// The kernel of that kind, or null where this build or this processor has none. automatic: the fastest there
/// is.
StepBlocks stepBlocksFor(KernelKind kind);

const char* nameOfKernel(KernelKind kind);
/// What `automatic` stands for here.
KernelKind fastestKernel();

namespace kernel_plain {
void stepBlocks(const KernelStep& step, std::size_t firstBlock, std::size_t lastBlock, BlockReport* reports);
}  // namespace kernel_plain
namespace kernel_avx2 {
void stepBlocks(const KernelStep& step, std::size_t firstBlock, std::size_t lastBlock, BlockReport* reports);
}  // namespace kernel_avx2
namespace kernel_avx512 {
void stepBlocks(const KernelStep& step, std::size_t firstBlock, std::size_t lastBlock, BlockReport* reports);
}  // namespace kernel_avx512

}  // namespace sim
