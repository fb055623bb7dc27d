#pragma once

#include <cstddef>

/// Included by the kernels, so that nothing of Eigen or the standard containers may be included here.
namespace sim {

/// Nodes are worked on in blocks of sixteen consecutive ones (SELL-16), which fills two AVX-512 vectors of
/// doubles.
inline constexpr std::size_t kBlockNodes = 16;

}  // namespace sim
