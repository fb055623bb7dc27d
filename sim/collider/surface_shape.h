#pragma once

#include <memory>
#include <string_view>

#include "sim/collider/collider_drawing.h"
#include "sim/collider/intrusion.h"

namespace sim {

class TriangleMesh;

/// A surface of triangles. A closed one is solid; an open one is a sheet with two sides.
struct SurfaceShape {
  static constexpr std::string_view kName = "mesh";

  std::shared_ptr<const TriangleMesh> mesh;  ///< in the collider's own coordinates; never null
  double halfThickness = 0.0;                ///< cm: so far out is it on either side; above 0 for a sheet

  /// By distance, so that edges and corners are round where a sheet's thickness goes round them: nothing
  /// leaks in between two triangles. The way out is by what is nearest, whichever side of a sheet a node came
  /// from. `near`: a triangle that may be the nearest, from which it is found sooner.
  Intrusion intrusion(const Vec3& local, std::uint32_t near) const;
  double middleDepth() const;
  double reach() const;
  /// Flat, triangle by triangle.
  ColliderSurface surface() const;
  /// The edges, each once. An edge at a sheet's rim may be left out.
  ColliderOutline outline() const;

  bool operator==(const SurfaceShape& other) const;
};

}  // namespace sim
