#pragma once

#include <vector>

#include "sim/state/snapshot.h"
#include "sim/surface/cell_cuts.h"
#include "sim/surface/crack_net.h"
#include "sim/surface/surface_topology.h"

namespace sim {

/// The surface of one body in one state of breaking.
SurfaceTopology bodySurface(const CellComplex& complex, const WholeOutside& whole, const CellCuts& cuts,
                            const CellComplex::Body& body, const Broken& broken, LooseNodes looseNodes,
                            const std::vector<float>& damage);

/// What is drawn at a loose node in place of its material: an irregular tetrahedron, turned at random by the
/// node's index, or a sphere, of that volume (cm^3); a node without any, which no cell has, is drawn by its
/// radius.
void addLooseBody(const Network& network, const Broken& broken, NodeIndex node, bool sphere, double volume,
                  float damage, SurfaceTopology& topology);

/// cm^3: an eighth of each cell a node is a corner of, at rest.
std::vector<double> volumesOfNodes(const Network& network);

/// Of each node, the share of its bonds that are broken; 0 where it has none.
std::vector<float> damageOfNodes(const Network& network, const Broken& gone);

/// Sorts the faces by fragment, then by cell, and groups their normals.
void finishTopology(SurfaceTopology& topology);

}  // namespace sim
