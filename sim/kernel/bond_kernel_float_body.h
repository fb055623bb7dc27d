#pragma once

// The kernel whose forces are float (FloatReference in bond_kernel.h), included behind bond_kernel_body.h. It
// moves nodes in double by the same code, and evaluates `exact` slots by it.

#include "sim/kernel/bond_kernel_body.h"

namespace sim::SMITHEREENS_KERNEL {
namespace {

using Single = stdx::native_simd<float>;
using SingleMask = Single::mask_type;
constexpr std::size_t kSingleWidth = Single::size();
constexpr unsigned kAllSingleLanes = (1U << kSingleWidth) - 1U;
static_assert(kBlockNodes % kSingleWidth == 0);

SMITHEREENS_INLINE Single load(const float* from) {
  return Single(from, stdx::element_aligned);
}

SMITHEREENS_INLINE Single multiplyAdd(const Single& a, const Single& b, const Single& c) {
#if defined(__AVX512F__)
  return Single(_mm512_fmadd_ps(static_cast<__m512>(a), static_cast<__m512>(b), static_cast<__m512>(c)));
#elif defined(__FMA__)
  return Single(_mm256_fmadd_ps(static_cast<__m256>(a), static_cast<__m256>(b), static_cast<__m256>(c)));
#else
  return a * b + c;
#endif
}

/// 1 / sqrt(x): one step of Newton's method makes an estimate good to 2^-14 good to rounding.
SMITHEREENS_INLINE Single inverseRoot(const Single& x) {
#if defined(__AVX512F__)
  const Single y(_mm512_rsqrt14_ps(static_cast<__m512>(x)));
  const Single error = multiplyAdd(-(x * y), y, 1.0F);
  return multiplyAdd(y * 0.5F, error, y);
#else
  return 1.0F / stdx::sqrt(x);
#endif
}

SMITHEREENS_INLINE Single quotient(const Single& a, const Single& b) {
#if defined(__AVX512F__)
  const Single y(_mm512_rcp14_ps(static_cast<__m512>(b)));
  return a * multiplyAdd(y, multiplyAdd(-b, y, 1.0F), y);
#else
  return a / b;
#endif
}

struct SingleTriple {
  Single x, y, z;
};

SMITHEREENS_INLINE SingleTriple loadTriple(const float* const arrays[3], std::size_t at) {
  return {load(arrays[0] + at), load(arrays[1] + at), load(arrays[2] + at)};
}

SMITHEREENS_INLINE SingleTriple gatherTriple(const float* const arrays[3], const std::uint32_t* nodes) {
  return {Single([&](auto lane) { return arrays[0][nodes[lane]]; }),
          Single([&](auto lane) { return arrays[1][nodes[lane]]; }),
          Single([&](auto lane) { return arrays[2][nodes[lane]]; })};
}

SMITHEREENS_INLINE SingleTriple difference(const SingleTriple& a, const SingleTriple& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

SMITHEREENS_INLINE Single dot(const SingleTriple& a, const SingleTriple& b) {
  return multiplyAdd(a.z, b.z, multiplyAdd(a.y, b.y, a.x * b.x));
}

#if !defined(__AVX512F__)
constexpr LaneTable<float, kSingleWidth> kSingleLaneTable;
#endif

/// The lanes whose bit is set.
SMITHEREENS_INLINE SingleMask maskOf(unsigned bits) {
#if defined(__AVX512F__)
  return Single(_mm512_maskz_mov_ps(static_cast<__mmask16>(bits), _mm512_set1_ps(1.0F))) > 0.5F;
#else
  return load(kSingleLaneTable.row[bits]) > 0.5F;
#endif
}

struct SingleConstants {
  Single stiffness, restLength, damping;
};

SMITHEREENS_INLINE SingleConstants singleConstantsOf(const KernelStep& step, const BondSlot& slot,
                                                     std::size_t lane) {
  const auto stiffnessScale = static_cast<float>(step.materials[slot.material].stiffnessScale);
  const auto dampingScale = static_cast<float>(step.materials[slot.material].dampingScale);
  if (!slot.varied) {
    const FloatConstants& shared = step.reference->constants[slot.constants];
    return {shared.stiffness * stiffnessScale, shared.restLength, shared.damping * dampingScale};
  }
  const FloatLanes& lanes = step.reference->lanes[slot.constants];
  return {load(lanes.stiffness + lane) * stiffnessScale, load(lanes.restLength + lane),
          load(lanes.damping + lane) * dampingScale};
}

/// Of one run of lanes, in the axes of the reference.
struct SingleNode {
  SingleTriple displacement, velocity;
};

struct SingleSums {
  Single forceX = 0.0F, forceY = 0.0F, forceZ = 0.0F;  ///< elastic
  Single lossyX = 0.0F, lossyY = 0.0F, lossyZ = 0.0F;  ///< of the dampers
  bool suspect = false;
};

/// Slots are suspect by so much less than their thresholds: rounding of L / r.
constexpr float kSuspectSlack = 5e-7F;

enum class Reach { straight, bent, gathered };

template <Reach kReach>
SMITHEREENS_INLINE SingleTriple loadNeighbours(const KernelStep& step, const BondSlot& slot, std::size_t node,
                                               std::size_t lane, const float* const arrays[3]) {
  if constexpr (kReach == Reach::gathered) return gatherTriple(arrays, step.gathers + slot.where + lane);
  return loadTriple(arrays, static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + slot.where));
}

/// The bonds in the reference.
template <Reach kReach>
SMITHEREENS_INLINE SingleTriple loadBonds(const KernelStep& step, const BondSlot& slot, std::size_t node,
                                          std::size_t lane) {
  const FloatReference& reference = *step.reference;
  if constexpr (kReach == Reach::straight) {
    const float* const shared = reference.constants[slot.constants].bond;
    return {shared[0], shared[1], shared[2]};
  }
  return difference(loadNeighbours<kReach>(step, slot, node, lane, reference.position),
                    loadTriple(reference.position, node));
}

template <Reach kReach>
SMITHEREENS_INLINE void addSingleSlot(const KernelStep& step, const BondSlot& slot, std::size_t node,
                                      std::size_t lane, unsigned bits, const SingleNode& here,
                                      SingleSums& sum) {
  const FloatReference& reference = *step.reference;
  const SingleTriple moved =
      difference(loadNeighbours<kReach>(step, slot, node, lane, reference.displacement), here.displacement);
  const SingleTriple bond = loadBonds<kReach>(step, slot, node, lane);
  const SingleTriple apart{bond.x + moved.x, bond.y + moved.y, bond.z + moved.z};
  const SingleTriple both{apart.x + bond.x, apart.y + bond.y, apart.z + bond.z};
  const SingleConstants constants = singleConstantsOf(step, slot, lane);
  const Single change = dot(moved, both);
  // What is pressed to a thousandth of its length or less is rounding.
  const Single squared = stdx::max(multiplyAdd(constants.restLength, constants.restLength, change),
                                   1e-6F * constants.restLength * constants.restLength);
  Single inverse = inverseRoot(squared);
  Single elastic =
      quotient(constants.stiffness * change * inverse, multiplyAdd(squared, inverse, constants.restLength));
  if (bits != kAllSingleLanes) {
    const SingleMask live = maskOf(bits);
    where(!live, inverse) = 0.0F;
    where(!live, elastic) = 0.0F;
  }
  if (slot.tested) {
    const SingleMask stretched =
        constants.restLength * inverse < slot.breakRatio + kSuspectSlack && elastic > 0.0F;
    sum.suspect |= stdx::any_of(stretched);
  }
  sum.forceX = multiplyAdd(elastic, apart.x, sum.forceX);
  sum.forceY = multiplyAdd(elastic, apart.y, sum.forceY);
  sum.forceZ = multiplyAdd(elastic, apart.z, sum.forceZ);
  if (!slot.damped) return;
  const SingleTriple velocity = loadNeighbours<kReach>(step, slot, node, lane, reference.velocity);
  const Single approach = dot(difference(velocity, here.velocity), apart);
  const Single lossy = constants.damping * approach * (inverse * inverse);
  sum.lossyX = multiplyAdd(lossy, apart.x, sum.lossyX);
  sum.lossyY = multiplyAdd(lossy, apart.y, sum.lossyY);
  sum.lossyZ = multiplyAdd(lossy, apart.z, sum.lossyZ);
}

/// Forces on a block's nodes, in the axes of the reference: elastic, then lossy.
struct BlockForces {
  alignas(64) float axis[6][kBlockNodes];
  bool suspect = false;
};

SMITHEREENS_INLINE void gatherSingles(const KernelStep& step, std::size_t block, std::size_t lane,
                                      BlockForces& forces) {
  const FloatReference& reference = *step.reference;
  const std::size_t node = block * kBlockNodes + lane;
  const SingleNode here{loadTriple(reference.displacement, node), loadTriple(reference.velocity, node)};
  SingleSums sum;
  const BondSlot* slot = step.slots + step.firstSlot[block];
  const BondSlot* const end = slot + step.slotCount[block];
  const unsigned awake = step.awake[block];
  for (; slot != end; ++slot) {
    const unsigned bits = ((slot->live & awake) >> lane) & kAllSingleLanes;
    if (bits == 0 || slot->exact) continue;
    if (slot->straight) {
      addSingleSlot<Reach::straight>(step, *slot, node, lane, bits, here, sum);
    } else if (slot->gathered) {
      addSingleSlot<Reach::gathered>(step, *slot, node, lane, bits, here, sum);
    } else {
      addSingleSlot<Reach::bent>(step, *slot, node, lane, bits, here, sum);
    }
  }
  const Single* const sums[6] = {&sum.forceX, &sum.forceY, &sum.forceZ,
                                 &sum.lossyX, &sum.lossyY, &sum.lossyZ};
  for (std::size_t k = 0; k < 6; ++k) sums[k]->copy_to(forces.axis[k] + lane, stdx::element_aligned);
  forces.suspect |= sum.suspect;
}

struct Frame {
  Real rotation[9];
  Real origin[3];
  Real centre[3];
};

SMITHEREENS_INLINE Frame frameOf(const FloatReference& reference, std::size_t block, std::size_t node) {
  Frame frame;
  const std::uint32_t* const ids = reference.frameOfNode + node;
  if (reference.mixed[block] == 0) {
    const ReferenceFrame& shared = reference.frames[*ids];
    for (std::size_t k = 0; k < 9; ++k) frame.rotation[k] = shared.rotation[k];
    for (std::size_t k = 0; k < 3; ++k) frame.origin[k] = shared.origin[k];
    for (std::size_t k = 0; k < 3; ++k) frame.centre[k] = shared.centre[k];
    return frame;
  }
  for (std::size_t k = 0; k < 9; ++k)
    frame.rotation[k] = Real([&](auto lane) { return reference.frames[ids[lane]].rotation[k]; });
  for (std::size_t k = 0; k < 3; ++k)
    frame.origin[k] = Real([&](auto lane) { return reference.frames[ids[lane]].origin[k]; });
  for (std::size_t k = 0; k < 3; ++k)
    frame.centre[k] = Real([&](auto lane) { return reference.frames[ids[lane]].centre[k]; });
  return frame;
}

SMITHEREENS_INLINE Real loadDouble(const float* from) {
  return Real(from, stdx::element_aligned);
}

SMITHEREENS_INLINE Triple toWorld(const Frame& frame, const float (*axis)[kBlockNodes], std::size_t lane) {
  const Real x = loadDouble(axis[0] + lane);
  const Real y = loadDouble(axis[1] + lane);
  const Real z = loadDouble(axis[2] + lane);
  const Real* const r = frame.rotation;
  return {multiplyAdd(r[2], z, multiplyAdd(r[1], y, r[0] * x)),
          multiplyAdd(r[5], z, multiplyAdd(r[4], y, r[3] * x)),
          multiplyAdd(r[8], z, multiplyAdd(r[7], y, r[6] * x))};
}

SMITHEREENS_INLINE void addExactSlots(const KernelStep& step, std::size_t block, std::size_t lane,
                                      const Triple& position, const Triple& velocity, Gathered& sum) {
  const BondSlot* slot = step.slots + step.firstSlot[block];
  const BondSlot* const end = slot + step.slotCount[block];
  const unsigned awake = step.awake[block];
  const std::size_t node = block * kBlockNodes + lane;
  for (; slot != end; ++slot) {
    const unsigned bits = ((slot->live & awake) >> lane) & kAllLanes;
    if (bits == 0 || !slot->exact) continue;
    if (slot->gathered) {
      addSlot<true>(step, *slot, node, lane, bits, position, velocity, sum);
    } else {
      addSlot<false>(step, *slot, node, lane, bits, position, velocity, sum);
    }
  }
}

SMITHEREENS_INLINE void storeSingle(const Real& value, float* to) {
  value.copy_to(to, stdx::element_aligned);
}

/// Displacement and velocity in the axes of the reference, for the float kernel.
SMITHEREENS_INLINE void displaceLanes(const FloatReference& reference, const Frame& frame, std::size_t node,
                                      const Triple& position, const Triple& velocity,
                                      float* const displacements[3], float* const velocities[3]) {
  const Real armX = position.x - frame.origin[0];
  const Real armY = position.y - frame.origin[1];
  const Real armZ = position.z - frame.origin[2];
  for (std::size_t k = 0; k < 3; ++k) {
    const Real x = frame.rotation[k];
    const Real y = frame.rotation[3 + k];
    const Real z = frame.rotation[6 + k];
    const Real rest = loadDouble(reference.position[k] + node) - frame.centre[k] +
                      loadDouble(reference.remainder[k] + node);
    storeSingle(multiplyAdd(z, armZ, multiplyAdd(y, armY, x * armX)) - rest, displacements[k] + node);
    storeSingle(multiplyAdd(z, velocity.z, multiplyAdd(y, velocity.y, x * velocity.x)), velocities[k] + node);
  }
}

SMITHEREENS_INLINE void finishLanes(const KernelStep& step, std::size_t block, std::size_t lane,
                                    const BlockForces& forces, BlockReport& report) {
  const FloatReference& reference = *step.reference;
  const std::size_t node = block * kBlockNodes + lane;
  Triple position = loadTriple(step.now.position, node);
  Triple velocity = loadTriple(step.now.velocity, node);
  Gathered sum;
  sum.suspect = forces.suspect;
  if (reference.anyExact) addExactSlots(step, block, lane, position, velocity, sum);
  const Frame frame = frameOf(reference, block, node);
  const Triple elastic = toWorld(frame, forces.axis, lane);
  const Triple lossy = toWorld(frame, forces.axis + 3, lane);
  sum.forceX += elastic.x;
  sum.forceY += elastic.y;
  sum.forceZ += elastic.z;
  sum.lossyX += lossy.x;
  sum.lossyY += lossy.y;
  sum.lossyZ += lossy.z;
  moveLanes(step, block, node, position, velocity, sum, report);
  if (reference.nextDisplacement[0] == nullptr) return;
  displaceLanes(reference, frame, node, position, velocity, reference.nextDisplacement,
                reference.nextVelocity);
}

}  // namespace

void displaceBlocks(const KernelStep& step, std::size_t firstBlock, std::size_t lastBlock) {
  const FloatReference& reference = *step.reference;
  for (std::size_t block = firstBlock; block < lastBlock; ++block) {
    for (std::size_t lane = 0; lane < kBlockNodes; lane += kWidth) {
      const std::size_t node = block * kBlockNodes + lane;
      displaceLanes(reference, frameOf(reference, block, node), node, loadTriple(step.now.position, node),
                    loadTriple(step.now.velocity, node), reference.displacement, reference.velocity);
    }
  }
}

void stepBlocksInFloat(const KernelStep& step, std::size_t firstBlock, std::size_t lastBlock,
                       BlockReport* reports) {
  for (std::size_t block = firstBlock; block < lastBlock; ++block) {
    BlockReport report;
    BlockForces forces;
    for (std::size_t lane = 0; lane < kBlockNodes; lane += kSingleWidth)
      gatherSingles(step, block, lane, forces);
    for (std::size_t lane = 0; lane < kBlockNodes; lane += kWidth)
      finishLanes(step, block, lane, forces, report);
    reports[block] = report;
  }
}

}  // namespace sim::SMITHEREENS_KERNEL
