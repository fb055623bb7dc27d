#pragma once

// The kernel's source, included by bond_kernel_plain.cpp, _avx2.cpp and _avx512.cpp, each compiled for its
// own instruction set, with SMITHEREENS_KERNEL the namespace.
//
// Force on a node from its neighbour (paper, "Dynamics"): along e = (x_j - x_i) / r,
//   f = k (r - l) + d (v_j - v_i) . e.
// The dampers' force is summed apart so that the work done against them over the step, f_d . (v + v') / 2
// kick, is exact in the discrete motion, and the energy ledger closes.

#include <experimental/simd>
#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include "sim/kernel/bond_kernel.h"

/// What a slot adds to must stay in registers, which a call would end.
#if defined(__GNUC__)
#define SMITHEREENS_INLINE [[gnu::always_inline]] inline
#else
#define SMITHEREENS_INLINE inline
#endif

namespace sim::SMITHEREENS_KERNEL {
namespace {

namespace stdx = std::experimental;
using Real = stdx::native_simd<double>;
using Mask = Real::mask_type;
constexpr std::size_t kWidth = Real::size();
/// cm^2: lost in the rounding of any distance but none at all, which what is pressed flat may have. Such a
/// bond has no direction and no force.
constexpr double kNoDistance = 1e-30;
constexpr unsigned kAllLanes = (1U << kWidth) - 1U;

/// 1 in the lanes whose bit is set: masks are made by comparing a row of this.
template <class Number, std::size_t kLanes>
struct LaneTable {
  alignas(64) Number row[1U << kLanes][kLanes];
  constexpr LaneTable() : row() {
    for (std::size_t bits = 0; bits < (1U << kLanes); ++bits) {
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        row[bits][lane] = static_cast<Number>((bits >> lane) & 1U);
    }
  }
};
constexpr LaneTable<double, kWidth> kLaneTable;

SMITHEREENS_INLINE Real load(const double* from) {
  return Real(from, stdx::element_aligned);
}

/// a b + c, rounded once where the processor can.
SMITHEREENS_INLINE Real multiplyAdd(const Real& a, const Real& b, const Real& c) {
#if defined(__AVX512F__)
  return Real(_mm512_fmadd_pd(static_cast<__m512d>(a), static_cast<__m512d>(b), static_cast<__m512d>(c)));
#elif defined(__FMA__)
  return Real(_mm256_fmadd_pd(static_cast<__m256d>(a), static_cast<__m256d>(b), static_cast<__m256d>(c)));
#else
  return a * b + c;
#endif
}

/// c - a b.
SMITHEREENS_INLINE Real subtractProduct(const Real& a, const Real& b, const Real& c) {
#if defined(__AVX512F__)
  return Real(_mm512_fnmadd_pd(static_cast<__m512d>(a), static_cast<__m512d>(b), static_cast<__m512d>(c)));
#elif defined(__FMA__)
  return Real(_mm256_fnmadd_pd(static_cast<__m256d>(a), static_cast<__m256d>(b), static_cast<__m256d>(c)));
#else
  return c - a * b;
#endif
}

/// 1 / sqrt(x). Root and division are the slowest things a processor does; from an estimate y good to 2^-14,
/// with e = 1 - x y^2, four terms of 1 / sqrt(x) = y (1 - e)^(-1/2) leave an error of 35/128 e^4, below
/// rounding.
SMITHEREENS_INLINE Real inverseRoot(const Real& x) {
#if defined(__AVX512F__)
  const Real y(_mm512_rsqrt14_pd(static_cast<__m512d>(x)));
  const Real error = subtractProduct(x * y, y, 1.0);
  const Real series = multiplyAdd(error, multiplyAdd(error, 0.3125, 0.375), 0.5);
  return multiplyAdd(y * error, series, y);
#else
  return 1.0 / stdx::sqrt(x);
#endif
}

struct Triple {
  Real x, y, z;
};

SMITHEREENS_INLINE Triple loadTriple(const double* const arrays[3], std::size_t at) {
  return {load(arrays[0] + at), load(arrays[1] + at), load(arrays[2] + at)};
}

SMITHEREENS_INLINE Triple gatherTriple(const double* const arrays[3], const std::uint32_t* nodes) {
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

SMITHEREENS_INLINE Constants constantsOf(const KernelStep& step, const BondSlot& slot, std::size_t lane) {
  const MaterialNow& material = step.materials[slot.material];
  if (!slot.varied) {
    const SlotConstants& shared = step.constants[slot.constants];
    return {shared.stiffness * material.stiffnessScale, shared.restLength,
            shared.damping * material.dampingScale};
  }
  const SlotLanes& lanes = step.lanes[slot.constants];
  return {load(lanes.stiffness + lane) * material.stiffnessScale, load(lanes.restLength + lane),
          load(lanes.damping + lane) * material.dampingScale};
}

/// Viscoplastic flow: the rest length moves towards the present length by a share of the strain beyond
/// yield. Both ends compute the same length from the same numbers, so their two copies stay equal.
SMITHEREENS_INLINE Real flow(const KernelStep& step, const BondSlot& slot, std::size_t lane, const Mask& live,
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
  restLength.copy_to(step.lanes[slot.constants].restLength + lane, stdx::element_aligned);
  return restLength;
}

/// Lets the bonds flow; sum.flowed gets the energy that this takes.
SMITHEREENS_INLINE void flowSlot(const KernelStep& step, const BondSlot& slot, std::size_t lane,
                                 const Mask& live, const Real& length, Constants& constants, Gathered& sum) {
  const Real before = length - constants.restLength;
  constants.restLength = flow(step, slot, lane, live, length, constants);
  const Real after = length - constants.restLength;
  Real taken = 0.25 * constants.stiffness * (before * before - after * after);
  where(!live, taken) = 0.0;
  sum.flowed += taken;
}

SMITHEREENS_INLINE void addDampers(const Triple& apart, const Triple& movesThere, const Triple& velocity,
                                   const Real& damping, const Real& inverse, Gathered& sum) {
  const Real approach =
      multiplyAdd(movesThere.z - velocity.z, apart.z,
                  multiplyAdd(movesThere.y - velocity.y, apart.y, (movesThere.x - velocity.x) * apart.x));
  const Real lossy = damping * approach * (inverse * inverse);
  sum.lossyX = multiplyAdd(lossy, apart.x, sum.lossyX);
  sum.lossyY = multiplyAdd(lossy, apart.y, sum.lossyY);
  sum.lossyZ = multiplyAdd(lossy, apart.z, sum.lossyZ);
}

template <bool kGathered>
SMITHEREENS_INLINE void addSlot(const KernelStep& step, const BondSlot& slot, std::size_t node,
                                std::size_t lane, unsigned bits, const Triple& position,
                                const Triple& velocity, Gathered& sum) {
  const auto loadThere = [&](const double* const arrays[3]) {
    if constexpr (kGathered) {
      return gatherTriple(arrays, step.gathers + slot.where + lane);
    } else {
      return loadTriple(arrays, static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + slot.where));
    }
  };
  const Triple there = loadThere(step.now.position);
  Constants constants = constantsOf(step, slot, lane);
  const Triple apart{there.x - position.x, there.y - position.y, there.z - position.z};
  const Real squared = multiplyAdd(apart.z, apart.z,
                                   multiplyAdd(apart.y, apart.y, multiplyAdd(apart.x, apart.x, kNoDistance)));
  Real inverse = inverseRoot(squared);
  if (slot.plastic && step.flowing)
    flowSlot(step, slot, lane, load(kLaneTable.row[bits]) > 0.5, squared * inverse, constants, sum);
  if (bits != kAllLanes) {
    const Mask live = load(kLaneTable.row[bits]) > 0.5;
    where(!live, inverse) = 0.0;
    where(!live, constants.stiffness) = 0.0;
  }
  // k (r - l) / r = k (1 - l / r).
  const Real restShare = constants.restLength * inverse;
  const Real elastic = subtractProduct(constants.stiffness, restShare, constants.stiffness);
  if (slot.tested) {
    const Mask stretched = restShare < static_cast<double>(slot.breakRatio) && elastic > 0.0;
    sum.suspect |= stdx::any_of(stretched);
  }
  sum.forceX = multiplyAdd(elastic, apart.x, sum.forceX);
  sum.forceY = multiplyAdd(elastic, apart.y, sum.forceY);
  sum.forceZ = multiplyAdd(elastic, apart.z, sum.forceZ);
  if (slot.damped) addDampers(apart, loadThere(step.now.velocity), velocity, constants.damping, inverse, sum);
}

SMITHEREENS_INLINE void addExternal(const KernelStep& step, std::size_t node, Gathered& sum) {
  sum.lossyX += load(step.externalLossy[0] + node);
  sum.lossyY += load(step.externalLossy[1] + node);
  sum.lossyZ += load(step.externalLossy[2] + node);
  sum.forceX += load(step.external[0] + node) - load(step.externalLossy[0] + node);
  sum.forceY += load(step.external[1] + node) - load(step.externalLossy[1] + node);
  sum.forceZ += load(step.external[2] + node) - load(step.externalLossy[2] + node);
}

/// Kick and drift of one coordinate, which move position and velocity on; returns the work done against lossy
/// forces, or its rate where only accelerations are wanted.
SMITHEREENS_INLINE Real moveAxis(const KernelStep& step, int axis, std::size_t node, Real& position,
                                 Real& velocity, const Real& force, const Real& lossy,
                                 const Real& inverseMass) {
  Real acceleration = (force + lossy) * inverseMass + step.gravity[axis];
  where(inverseMass == 0.0, acceleration) = 0.0;
  if (step.accelerationOnly) {
    acceleration.copy_to(step.nextVelocity[axis] + node, stdx::element_aligned);
    return -lossy * velocity;
  }
  const Real before = velocity;
  velocity = multiplyAdd(step.kick, acceleration, before);
  position = multiplyAdd(step.drift, step.driftByOldVelocity ? before : velocity, position);
  velocity.copy_to(step.nextVelocity[axis] + node, stdx::element_aligned);
  position.copy_to(step.nextPosition[axis] + node, stdx::element_aligned);
  return -0.5 * step.kick * lossy * (before + velocity);
}

/// Moves position and velocity on, here and in the arrays.
SMITHEREENS_INLINE void moveLanes(const KernelStep& step, std::size_t block, std::size_t node,
                                  Triple& position, Triple& velocity, Gathered& sum, BlockReport& report) {
  if (step.hasExternal[block] != 0) addExternal(step, node, sum);
  const Real inverseMass = load(step.inverseMass + node);
  Real work = sum.flowed;
  work += moveAxis(step, 0, node, position.x, velocity.x, sum.forceX, sum.lossyX, inverseMass);
  work += moveAxis(step, 1, node, position.y, velocity.y, sum.forceY, sum.lossyY, inverseMass);
  work += moveAxis(step, 2, node, position.z, velocity.z, sum.forceZ, sum.lossyZ, inverseMass);

  report.dissipated += stdx::reduce(work);
  report.suspect |= sum.suspect;
  if (step.accelerationOnly) return;
  const Real squared = velocity.x * velocity.x + velocity.y * velocity.y + velocity.z * velocity.z;
  // The largest of numbers among which there is one that is none would be any of them.
  // NOLINTNEXTLINE(misc-redundant-expression): not so for what is no number.
  const double largest = stdx::all_of(squared == squared) ? stdx::hmax(squared) : stdx::reduce(squared);
  if (!(largest <= report.largestSpeedSquared)) report.largestSpeedSquared = largest;
}

SMITHEREENS_INLINE void stepLanes(const KernelStep& step, std::size_t block, std::size_t lane,
                                  BlockReport& report) {
  const std::size_t node = block * kBlockNodes + lane;
  Triple position = loadTriple(step.now.position, node);
  Triple velocity = loadTriple(step.now.velocity, node);
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
  moveLanes(step, block, node, position, velocity, sum, report);
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
