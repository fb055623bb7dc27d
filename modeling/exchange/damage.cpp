#include "modeling/exchange/damage.h"

#include <cstdint>

namespace modeling {

std::vector<double> damageOfNodes(const sim::Network& network, const sim::Snapshot& moment) {
  std::vector<std::uint32_t> bonds(network.nodeCount(), 0);
  std::vector<std::uint32_t> broken(network.nodeCount(), 0);
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond) {
      const bool gone = moment.broken->hasLostBond(bond);
      for (const sim::NodeIndex node : {a, network.bondEnds[bond]}) {
        ++bonds[node];
        if (gone) ++broken[node];
      }
    }
  }
  std::vector<double> damage(network.nodeCount(), 0.0);
  for (std::size_t node = 0; node < damage.size(); ++node) {
    if (bonds[node] > 0) damage[node] = static_cast<double>(broken[node]) / bonds[node];
  }
  return damage;
}

}  // namespace modeling
