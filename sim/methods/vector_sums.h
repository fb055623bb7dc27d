#pragma once

#include "sim/base/parallel.h"
#include "sim/state/motion.h"

namespace sim {

struct WeightedVectors {
  double weight;
  const NodeVectors* vectors;
};

/// sum = base + the weighted ones, each number by itself in the order given, so that the result does not
/// depend on who computes it. `sum` may be one of the others.
template <class... Terms>
void addWeighted(NodeVectors& sum, const NodeVectors& base, const Terms&... terms) {
  constexpr std::size_t kGrain = 2048;
  parallelRanges(NodeVectors::paddedCount(base.size()), kGrain, Sharing::even,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t k = 0; k < 3; ++k) {
                     double* const to = sum.axis(k);
                     const double* const from = base.axis(k);
                     for (std::size_t n = begin; n < end; ++n)
                       to[n] = (from[n] + ... + (terms.weight * terms.vectors->axis(k)[n]));
                   }
                 });
}

}  // namespace sim
