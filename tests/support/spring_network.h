#pragma once

#include <memory>

#include "sim/dynamics/simulation.h"

/// Networks of springs made by hand, for tests of what the simulation does with them. Each is a blueprint, so
/// that a test may bend it before it is built.
namespace tests {

/// Two nodes on the x axis, the first at the origin, and a spring between them.
struct Pair {
  double stiffness = 1000.0;
  double restLength = 1.0;
  double damping = 0.0;
  double distance = 1.0;  ///< at the start
  double approach = 0.0;  ///< cm/s towards each other, shared evenly
  double threshold = sim::kUnbreakable;
  double mass = 1.0;  ///< of each
};
sim::Blueprint twoNodes(const Pair& pair);

/// `count` nodes in a row along x at distance 1, a spring between neighbours.
sim::Blueprint chain(unsigned count, double stiffness = 1000.0, double damping = 0.0);

/// Which bonds a cell has (docs/numerics.md, "Bonds of a lattice of cubes").
enum class Pattern { edgesAndBody, edgesAndHalfFaces, edgesAndFaces, full };

/// A block of cells with uniform constants: k = 0.6, 0.2, 0.15 E h for edges, face and body diagonals.
struct Block {
  unsigned nx = 2, ny = 2, nz = 2;  ///< cells
  double spacing = 1.0;             ///< h, cm
  double youngsModulus = 1e5;       ///< E, dyn/cm^2
  double density = 1.0;             ///< g/cm^3
  double dampingTime = 0.0;         ///< d / k, s
  Pattern pattern = Pattern::full;
  double distortion = 0.0;  ///< of each corner, relative to h; rest lengths are those of the distorted cells
  std::uint64_t seed = 1;   ///< of the distortion
  sim::Material material{.name = "stuff"};
  sim::Vec3 corner = sim::Vec3::Zero();
  sim::Vec3 velocity = sim::Vec3::Zero();
};
/// Nodes in lattice order, the longest axis innermost.
sim::Blueprint block(const Block& block);

/// Two equal blocks, the second `gap` above the first, nearing each other at `speed`.
sim::Blueprint twoBlocks(const Block& block, double gap, double speed);

/// Random points in a cube of edge 4, bonds between those nearer than 1.6 with a chance of 0.7, random
/// masses, constants, velocities of the given size, and bonds up to `strain` away from their rest length.
sim::Blueprint randomNetwork(unsigned nodes, std::uint64_t seed, double speed = 1.0, double strain = 0.05);

/// Puts what `more` holds behind what is there, as a part and with materials of its own.
void append(sim::Blueprint& blueprint, const sim::Blueprint& more);

/// Builds what a test has made, which must be proper.
sim::Network built(sim::Blueprint blueprint, std::uint64_t seed = 1);

/// One thread, no friction, no contact damping: nothing is lost but what a test adds.
sim::Settings losslessSettings();
sim::Environment weightless();
/// Earth's gravity, and a floor at z = 0.
sim::Environment earth();

std::unique_ptr<sim::Simulation> simulation(sim::Blueprint blueprint, const sim::Settings& settings,
                                            sim::Environment environment = weightless(),
                                            std::vector<sim::Track> tracks = {});

/// Steps until `time`, expecting nothing to go wrong.
void run(sim::Simulation& simulation, double time);

}  // namespace tests
