#pragma once

#include "tests/support/spring_network.h"

/// One scene in which everything happens at once.
namespace tests {

struct CrashOptions {
  bool large = false;  ///< enough nodes to occupy several threads
  int threads = 1;
  std::uint64_t seed = 1;
  sim::Method method = sim::Settings{}.method;
  std::optional<double> tolerance = {};
  bool onSheet = false;  ///< it falls on a thin sheet of triangles instead of a floor
};

/// A brittle block falls onto a plastic one that lies on a moving floor, while gravity and stiffness are
/// changed by tracks: it breaks, touches, rubs and flows. All of it happens within 3 ms.
std::unique_ptr<sim::Simulation> crash(const CrashOptions& options);

}  // namespace tests
