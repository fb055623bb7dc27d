#pragma once

#include <vector>

#include <tbb/cache_aligned_allocator.h>

namespace sim {

/// A vector whose data begins on a cache line, as wide loads like it.
template <class Value>
using AlignedVector = std::vector<Value, tbb::cache_aligned_allocator<Value>>;

}  // namespace sim
