#include "app/bench/plain_loop.h"

namespace app {

PlainLoop::PlainLoop(const sim::Network& network) {
  for (std::size_t n = 0; n < network.nodeCount(); ++n) {
    nodes_.push_back(
        {network.positions[n], network.velocities[n], sim::Vec3::Zero(), 1.0 / network.masses[n]});
  }
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
      const sim::BondClass& bond = network.bond(b);
      bonds_.push_back({a, network.bondEnds[b], bond.stiffness, bond.restLength, bond.damping,
                        static_cast<double>(network.thresholds[b]), false});
    }
  }
}

void PlainLoop::run(int steps, double step) {
  for (int s = 0; s < steps; ++s) {
    for (Node& node : nodes_) node.force.setZero();
    for (Bond& bond : bonds_) {
      if (bond.broken) continue;
      Node& a = nodes_[bond.a];
      Node& b = nodes_[bond.b];
      const sim::Vec3 along = b.position - a.position;
      const double length = along.norm();
      const double extension = length - bond.restLength;
      if (extension > bond.threshold * bond.restLength) bond.broken = true;
      const double closing = (b.velocity - a.velocity).dot(along) / length;
      const sim::Vec3 force = (bond.stiffness * extension + bond.damping * closing) / length * along;
      a.force += force;
      b.force -= force;
    }
    for (Node& node : nodes_) {
      node.velocity += step * node.inverseMass * node.force;
      node.position += step * node.velocity;
    }
  }
}

}  // namespace app
