#pragma once

#include <vector>

#include "sim/network/network.h"

namespace app {

/// What anybody would write first: bonds in an array of structs, forces scattered to both nodes, a pass over
/// the nodes. The same physics (spring, damper, break test, integration) in double, one thread: the yardstick
/// of `bench throughput`.
class PlainLoop {
 public:
  explicit PlainLoop(const sim::Network& network);
  /// Steps of symplectic Euler without gravity.
  void run(int steps, double step);
  std::size_t bondCount() const { return bonds_.size(); }

 private:
  struct Node {
    sim::Vec3 position, velocity, force;
    double inverseMass;
  };
  struct Bond {
    sim::NodeIndex a, b;
    double stiffness, restLength, damping, threshold;
    bool broken;
  };
  std::vector<Node> nodes_;
  std::vector<Bond> bonds_;
};

}  // namespace app
