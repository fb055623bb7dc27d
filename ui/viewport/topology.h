#pragma once

#include "sim/surface/surface_mesh.h"
#include "ui/viewport/draw_data.h"

namespace ui {

/// The surface, loose bodies and bonds of one state of breaking. `hidden`: one byte a part, nonzero: left
/// out.
TopologyDraw topologyOf(const sim::Network& network, sim::SurfaceBuilder& surface,
                        const sim::BrokenPointer& broken, const std::vector<std::uint8_t>& hidden);

/// Where the topology's corners are: the nodes, and behind them the points of cracks, cm.
std::vector<std::array<float, 4>> cornerPositions(const TopologyDraw& topology,
                                                  const std::vector<sim::Vec3>& nodePositions);

/// Of every corner of the topology's faces, packed: those that share a normal get the mean of their faces',
/// weighted by the angle at the corner.
std::vector<std::uint32_t> cornerNormals(const TopologyDraw& topology,
                                         const std::vector<std::array<float, 4>>& positions);

}  // namespace ui
