#pragma once

#include <span>
#include <vector>

#include "sim/surface/crack_net.h"

namespace sim {

/// Moves the vertices of cracks, each towards the middle of its neighbours along the interfaces, so that the
/// staircase of the cells does not show. What CrackNet says of how far they may go holds.
void smoothCracks(const CellComplex& complex, const WholeOutside& whole,
                  std::span<const CrackNet::Interface> interfaces, std::vector<CrackNet::Vertex>& vertices);

}  // namespace sim
