#pragma once

#include <functional>

#include "ui/viewport/draw_data.h"

namespace ui {

/// One source of the potential field.
struct FieldNode {
  sim::Vec3 position = sim::Vec3::Zero();  ///< cm
  double reach = 0.0;                      ///< cm: where its potential has fallen to 0
  std::uint32_t colour = 0;
};

/// The surface on which the sum of the nodes' potentials has one value (paper, "Rendering"): each node's
/// falls smoothly from 1 to 0 at its reach, after B. and G. Wyvill and C. McPheeters, "Data structure for
/// soft objects" (1986). Found as one vertex in each cube of a grid that the surface passes through, in the
/// middle of where it crosses the cube's edges (surface nets, S. Gibson, 1998), which gives rounder triangles
/// than marching cubes from a fraction of the rules. The grid is as fine as fits `mostCubes`. Stops early,
/// with what is wrong left out, once `cancelled` says so.
LevelDraw levelSurface(const std::vector<FieldNode>& nodes, std::size_t mostCubes,
                       const std::function<bool()>& cancelled);

}  // namespace ui
