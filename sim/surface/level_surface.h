#pragma once

#include <array>
#include <functional>
#include <vector>

#include "sim/surface/surface_mesh.h"

namespace sim {

/// One source of the potential field.
struct FieldSource {
  Vec3 position = Vec3::Zero();  ///< cm
  double reach = 0.0;            ///< cm: where its potential has fallen to 0
};

struct LevelSurface {
  std::vector<Vec3> points;                         ///< cm
  std::vector<Vec3> normals;                        ///< unit, outward, one a point
  std::vector<std::uint32_t> sources;               ///< one a point: that whose potential is strongest there
  std::vector<std::array<std::uint32_t, 4>> quads;  ///< points, counter-clockwise seen from outside
};

/// How finely the field is looked at.
struct LevelGrid {
  std::size_t mostCubes = 1'000'000;  ///< of the whole grid, whose cubes are as small as this allows
  double cubesInReach = 5.0;          ///< but no smaller than that of the smallest reach
};

/// The surface on which the sum of the sources' potentials has one value (paper, "Rendering"): each source's
/// falls smoothly from 1 to 0 at its reach, after B. and G. Wyvill and C. McPheeters, "Data structure for
/// soft objects" (1986). Found as one point in each cube of a grid that the surface passes through, in the
/// middle of where it crosses the cube's edges (surface nets, S. Gibson, 1998), which gives rounder faces
/// than marching cubes from a fraction of the rules. Stops early, with what is wrong left out, once
/// `cancelled` says so.
LevelSurface levelSurface(const std::vector<FieldSource>& sources, const LevelGrid& grid,
                          const std::function<bool()>& cancelled);

/// Reach of a node's potential: enough to close the surface over the middle of a cell, where eight nodes are
/// 0.87 edges away.
double potentialReach(const Network& network, NodeIndex node);

/// The surface on which all nodes' potentials add up to one value, for pictures and exports: whatever is near
/// enough flows together, as the paper shows what does not break. Points stand in `nodeOfPoint` with the node
/// that is strongest there, whose material, part and fragment a face has. There is nothing inside.
SurfaceMesh levelSurfaceOf(const Network& network, const Snapshot& moment, const LevelGrid& grid);

}  // namespace sim
