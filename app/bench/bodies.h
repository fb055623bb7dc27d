#pragma once

#include <string>
#include <vector>

#include "modeling/scene/scene.h"
#include "sim/dynamics/simulation.h"

namespace app {

/// A body that benchmarks measure: a scene, made in code where it is a plain shape, so that its size is
/// stated here.
struct Body {
  std::string name;
  modeling::Scene scene;
  double brokenShare = 0.0;  ///< of its bonds, to be reached before it is measured
};

/// A tube of one cell's wall: `around` cells around, `along` up, edge about 0.5 cm.
modeling::Scene tubeScene(int around, int along);
/// The same, spinning so fast that it bursts everywhere and its shards hit one another.
modeling::Scene burstingTubeScene(int around, int along);
/// A solid slab of this many cells of 0.5 cm.
modeling::Scene slabScene(int x, int y, int z);
/// Loose cubes of 2 x 2 x 2 cells, count^3 of them, that collide at once and on the floor: contact is most of
/// the work.
modeling::Scene looseCubesScene(int count);

/// From small to large; with the finer teapot of resources/scenes.
sim::Result<std::vector<Body>> throughputBodies();

/// The body, built and ready to step.
sim::Result<std::unique_ptr<sim::Simulation>> start(const modeling::Scene& scene, int threads);

}  // namespace app
