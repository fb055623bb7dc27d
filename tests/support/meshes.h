#pragma once

#include "sim/collider/triangle_mesh.h"

namespace tests {

/// Twelve triangles about the origin.
sim::TriangleMesh boxMesh(const sim::Vec3& halfSize);

/// A ball about the origin, of `rings` rows of triangles from pole to pole and twice as many around; its
/// corners are on the sphere.
sim::TriangleMesh ballMesh(double radius, unsigned rings);

/// A square sheet in z = 0 about the origin, of two triangles.
sim::TriangleMesh sheetMesh(double halfSize);

}  // namespace tests
