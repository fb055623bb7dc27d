#pragma once

#include <span>
#include <vector>

#include "sim/surface/crack_net.h"

namespace sim {

/// Moves the vertices in which pieces meet towards the middle of their neighbours, as far as each may go
/// (CrackNet), so that a crack does not show the staircase of the cells. Those on the outside end on the
/// outside as CurvedFaces curves it.
void smoothCracks(const CellComplex& complex, const WholeOutside& whole,
                  std::span<const CrackNet::Interface> interfaces, std::vector<CrackNet::Vertex>& vertices);

}  // namespace sim
