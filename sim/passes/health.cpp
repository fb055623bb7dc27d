#include "sim/passes/health.h"

#include <cmath>

namespace sim {

Problem blowUp(const World& world, const char* what) {
  const Network& network = world.network;
  NodeIndex worst = 0;
  double fastest = -1.0;
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const double speed = world.next.velocity.get(node).norm();
    if (speed <= fastest) continue;
    worst = node;
    fastest = speed;
    if (!std::isfinite(speed)) break;
  }
  const std::string& part = network.partNames[network.nodeParts[worst]];
  const std::string& material = network.materials[network.nodeMaterials[worst]].name;
  return {"t = " + std::to_string(world.time()) + " s",
          "the motion blew up: node " + std::to_string(worst) + " of part '" + part + "' (material '" +
              material + "') " + what,
          "take a smaller step, or leave the step automatic"};
}

Result<double> fastestReported(const World& world) {
  double squared = 0.0;
  for (const std::uint32_t block : world.fragments.activity.activeBlocks()) {
    const double ofBlock = world.reports[block].largestSpeedSquared;
    if (!(ofBlock <= squared)) squared = ofBlock;
    if (!(ofBlock < kLightSpeedSquared)) return blowUp(world, "is faster than light");
  }
  return std::sqrt(squared);
}

}  // namespace sim
