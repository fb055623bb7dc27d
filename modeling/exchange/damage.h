#pragma once

#include <vector>

#include "sim/network/network.h"
#include "sim/state/snapshot.h"

namespace modeling {

/// For each node the share of its bonds that are broken, 0 (whole) to 1 (loose); 0 for a node without bonds.
std::vector<double> damageOfNodes(const sim::Network& network, const sim::Snapshot& moment);

}  // namespace modeling
