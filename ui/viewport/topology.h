#pragma once

#include "sim/network/surface_mesh.h"
#include "ui/viewport/draw_data.h"

namespace ui {

/// The surface, shards and bonds of one state of breaking. `hidden`: one byte a part, nonzero: left out.
TopologyDraw topologyOf(const sim::Network& network, const sim::SurfaceBuilder& surface,
                        const sim::Snapshot& moment, const std::vector<std::uint8_t>& hidden);

/// Of every corner of the topology's faces, packed: those that share a normal get the mean of their faces',
/// weighted by the angle at the corner.
std::vector<std::uint32_t> cornerNormals(const TopologyDraw& topology,
                                         const std::vector<std::array<float, 4>>& positions);

}  // namespace ui
