#pragma once

#include <memory>
#include <vector>

#include "sim/state/snapshot.h"
#include "sim/surface/cell_cuts.h"
#include "sim/surface/surface_topology.h"

namespace sim {

/// Makes the surface of any moment of one network. Outside and broken faces are told apart (`inside`); the
/// fragments' surfaces are closed, and at rest they fill exactly what the whole bodies filled: cells that
/// broke are divided among the fragments their corners belong to (CellCuts), along smoothed cracks
/// (CrackNet). Outside faces far from cracks are the sides of cells; near cracks they are divided.
///
/// A body in which nothing has broken since the last call is taken over from it. One thread at a time.
class SurfaceBuilder {
 public:
  /// Tetrahedra and spheres have the volume of the node's share of its cells. Of nodes that no cell has, they
  /// are inside the sphere of kLooseReach times the node's radius: two that touch are one radius apart, 0.75
  /// lets irregular ones nearly meet and rarely overlap.
  static constexpr double kLooseReach = 0.75;

  /// Keeps a reference to the network.
  explicit SurfaceBuilder(const Network& network, LooseNodes looseNodes = LooseNodes::shards);
  ~SurfaceBuilder();
  SurfaceBuilder(SurfaceBuilder&&) noexcept;
  SurfaceBuilder& operator=(SurfaceBuilder&&) noexcept;

  /// How everything hangs together once this has broken: for placeSurface(). What is returned is the
  /// builder's own, and stands until the next call.
  const SurfaceTopology& topology(const BrokenPointer& broken);

  /// placeSurface() of its topology.
  SurfaceMesh build(const Snapshot& moment);

  /// Bodies whose surface topology() made anew the last time, rather than taking it over.
  std::size_t bodiesRebuilt() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The network before anything moved, as a moment: positions at rest, nothing broken, one fragment a
/// connected component, numbered in order of their first nodes. For drawing what has not been simulated.
Snapshot momentAtRest(const Network& network);

}  // namespace sim
