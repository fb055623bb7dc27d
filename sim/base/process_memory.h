#pragma once

#include <cstddef>

namespace sim {

/// Bytes of memory that the program has now, as the system counts them; 0 where it does not say.
std::size_t residentMemory();
/// The most it has had so far.
std::size_t peakMemory();

}  // namespace sim
