#pragma once

// The kernel's source, included by bond_kernel_plain.cpp, _avx2.cpp and _avx512.cpp, each compiled for its
// own instruction set, with SMITHEREENS_KERNEL the namespace.
//
// Force on a node from its neighbour (paper, "Internal forces"; P3): along e = (x_j - x_i) / r,
//   f = k (r - l) + d (v_j - v_i) . e.
// The dampers' force is summed apart so that the work done against them over the step, f_d . (v + v') / 2
// kick, is exact in the discrete motion, and the energy ledger closes.

#include <experimental/simd>

#include "sim/dynamics/bond_kernel.h"

namespace sim::SMITHEREENS_KERNEL {
namespace {

namespace stdx = std::experimental;
using Real = stdx::native_simd<double>;
using Mask = Real::mask_type;
constexpr std::size_t kWidth = Real::size();
constexpr unsigned kAllLanes = (1U << kWidth) - 1U;

/// 1 in the lanes whose bit is set: masks are made by comparing a row of this.
struct LaneTable {
  alignas(64) double row[1U << kWidth][kWidth];
  constexpr LaneTable() : row() {
    for (std::size_t bits = 0; bits < (1U << kWidth); ++bits) {
      for (std::size_t lane = 0; lane < kWidth; ++lane)
        row[bits][lane] = ((bits >> lane) & 1U) != 0 ? 1.0 : 0.0;
    }
  }
};
constexpr LaneTable kLaneTable;

inline Real load(const double* from) {
  return Real(from, stdx::element_aligned);
}

struct Triple {
  Real x, y, z;
};

inline Triple loadTriple(const double* const arrays[3], std::size_t at) {
  return {load(arrays[0] + at), load(arrays[1] + at), load(arrays[2] + at)};
}

inline Triple gatherTriple(const double* const arrays[3], const std::uint32_t* nodes) {
  return {Real([&](auto lane) { return arrays[0][nodes[lane]]; }),
          Real([&](auto lane) { return arrays[1][nodes[lane]]; }),
          Real([&](auto lane) { return arrays[2][nodes[lane]]; })};
}

/// Everything a run of lanes gathers from its slots.
struct Gathered {
  Real forceX = 0.0, forceY = 0.0, forceZ = 0.0;  ///< elastic
  Real lossyX = 0.0, lossyY = 0.0, lossyZ = 0.0;  ///< of the dampers
  Real flowed = 0.0;                              ///< erg that plastic flow took, this end's half
  bool suspect = false;
};

struct Constants {
  Real stiffness, restLength, damping;
};

inline Constants constantsOf(const KernelStep& step, const BondSlot& slot, std::size_t lane) {
  const MaterialNow& material = step.materials[slot.material];
  if (!slot.varied) {
    return {slot.stiffness * material.stiffnessScale, slot.restLength, slot.damping * material.dampingScale};
  }
  const SlotLanes& lanes = step.lanes[slot.lanes];
  return {load(lanes.stiffness + lane) * material.stiffnessScale, load(lanes.restLength + lane),
          load(lanes.damping + lane) * material.dampingScale};
}

/// Viscoplastic flow (P2): the rest length moves towards the present length by a share of the strain beyond
/// yield. Both ends compute the same length from the same numbers, so their two copies stay equal.
inline Real flow(const KernelStep& step, const BondSlot& slot, std::size_t lane, const Mask& live,
                 const Real& length, const Constants& constants) {
  const MaterialNow& material = step.materials[slot.material];
  const Real extension = length - constants.restLength;
  const Real excess = stdx::fabs(extension) - material.yieldStrain * constants.restLength;
  const Mask yields = live && excess > 0.0;
  if (!stdx::any_of(yields)) return constants.restLength;
  Real change = excess * material.flow;
  where(extension < 0.0, change) = -change;
  where(!yields, change) = 0.0;
  const Real restLength = constants.restLength + change;
  restLength.copy_to(step.lanes[slot.lanes].restLength + lane, stdx::element_aligned);
  return restLength;
}

template <bool kGathered>
inline void addSlot(const KernelStep& step, const BondSlot& slot, std::size_t node, std::size_t lane,
                    unsigned bits, const Triple& position, const Triple& velocity, Gathered& sum) {
  Triple there;
  Triple movesThere;
  if constexpr (kGathered) {
    const std::uint32_t* nodes = step.gathers + slot.gather + lane;
    there = gatherTriple(step.now.position, nodes);
    movesThere = gatherTriple(step.now.velocity, nodes);
  } else {
    const auto neighbour = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + slot.offset);
    there = loadTriple(step.now.position, neighbour);
    movesThere = loadTriple(step.now.velocity, neighbour);
  }
  Constants constants = constantsOf(step, slot, lane);
  const Real dx = there.x - position.x;
  const Real dy = there.y - position.y;
  const Real dz = there.z - position.z;
  const Real squared = dx * dx + dy * dy + dz * dz;
  const Real length = stdx::sqrt(squared);
  Real inverse = 1.0 / length;
  const Mask live = load(kLaneTable.row[bits]) > 0.5;
  if (bits != kAllLanes) where(!live, inverse) = 0.0;

  if (slot.plastic && step.flowing) {
    const Real before = length - constants.restLength;
    constants.restLength = flow(step, slot, lane, live, length, constants);
    const Real after = length - constants.restLength;
    Real taken = 0.25 * constants.stiffness * (before * before - after * after);
    where(!live, taken) = 0.0;
    sum.flowed += taken;
  }
  const Real extension = length - constants.restLength;
  if (slot.tested) {
    const Mask stretched = extension > static_cast<double>(slot.thresholdFloor) * constants.restLength;
    sum.suspect |= stdx::any_of(stretched && live);
  }
  const Real elastic = constants.stiffness * extension * inverse;
  const Real approach =
      (movesThere.x - velocity.x) * dx + (movesThere.y - velocity.y) * dy + (movesThere.z - velocity.z) * dz;
  const Real lossy = constants.damping * approach * inverse * inverse;
  sum.forceX += elastic * dx;
  sum.forceY += elastic * dy;
  sum.forceZ += elastic * dz;
  sum.lossyX += lossy * dx;
  sum.lossyY += lossy * dy;
  sum.lossyZ += lossy * dz;
}

inline void addExternal(const KernelStep& step, std::size_t node, Gathered& sum) {
  sum.lossyX += load(step.externalLossy[0] + node);
  sum.lossyY += load(step.externalLossy[1] + node);
  sum.lossyZ += load(step.externalLossy[2] + node);
  sum.forceX += load(step.external[0] + node) - load(step.externalLossy[0] + node);
  sum.forceY += load(step.external[1] + node) - load(step.externalLossy[1] + node);
  sum.forceZ += load(step.external[2] + node) - load(step.externalLossy[2] + node);
}

/// Kick and drift of one coordinate; returns the work done against lossy forces, or
/// its rate where only accelerations are wanted.
inline Real moveAxis(const KernelStep& step, int axis, std::size_t node, const Real& position,
                     const Real& velocity, const Real& force, const Real& lossy, const Real& inverseMass,
                     Real& speedSquared) {
  Real acceleration = (force + lossy) * inverseMass + step.gravity[axis];
  where(inverseMass == 0.0, acceleration) = 0.0;
  if (step.accelerationOnly) {
    acceleration.copy_to(step.nextVelocity[axis] + node, stdx::element_aligned);
    return -lossy * velocity;
  }
  const Real next = velocity + step.kick * acceleration;
  const Real moved = position + step.drift * (step.driftByOldVelocity ? velocity : next);
  next.copy_to(step.nextVelocity[axis] + node, stdx::element_aligned);
  moved.copy_to(step.nextPosition[axis] + node, stdx::element_aligned);
  speedSquared += next * next;
  return -0.5 * step.kick * lossy * (velocity + next);
}

inline void stepLanes(const KernelStep& step, std::size_t block, std::size_t lane, BlockReport& report) {
  const std::size_t node = block * kBlockNodes + lane;
  const Triple position = loadTriple(step.now.position, node);
  const Triple velocity = loadTriple(step.now.velocity, node);
  Gathered sum;
  const BondSlot* slot = step.slots + step.firstSlot[block];
  const BondSlot* const end = slot + step.slotCount[block];
  const unsigned awake = step.awake[block];
  for (; slot != end; ++slot) {
    const unsigned bits = ((slot->live & awake) >> lane) & kAllLanes;
    if (bits == 0) continue;
    if (slot->gathered) {
      addSlot<true>(step, *slot, node, lane, bits, position, velocity, sum);
    } else {
      addSlot<false>(step, *slot, node, lane, bits, position, velocity, sum);
    }
  }
  if (step.hasExternal[block] != 0) addExternal(step, node, sum);
  const Real inverseMass = load(step.inverseMass + node);
  Real speedSquared = 0.0;
  Real work = sum.flowed;
  work += moveAxis(step, 0, node, position.x, velocity.x, sum.forceX, sum.lossyX, inverseMass, speedSquared);
  work += moveAxis(step, 1, node, position.y, velocity.y, sum.forceY, sum.lossyY, inverseMass, speedSquared);
  work += moveAxis(step, 2, node, position.z, velocity.z, sum.forceZ, sum.lossyZ, inverseMass, speedSquared);

  // Lane by lane in fixed order: the width of the vectors must not show in the sum. A comparison with NaN is
  // false, so the largest is kept only where it is shown to be the larger.
  for (std::size_t l = 0; l < kWidth; ++l) {
    report.dissipated += work[l];
    if (!(speedSquared[l] <= report.largestSpeedSquared)) report.largestSpeedSquared = speedSquared[l];
  }
  report.suspect |= sum.suspect;
}

}  // namespace

void stepBlocks(const KernelStep& step, std::size_t firstBlock, std::size_t lastBlock, BlockReport* reports) {
  for (std::size_t block = firstBlock; block < lastBlock; ++block) {
    BlockReport report;
    for (std::size_t lane = 0; lane < kBlockNodes; lane += kWidth) stepLanes(step, block, lane, report);
    reports[block] = report;
  }
}

}  // namespace sim::SMITHEREENS_KERNEL
