#pragma once

#include <array>
#include <vector>

#include "sim/surface/surface_topology.h"

namespace modeling {

/// A surface as triangles, curved faces divided along the patches that pictures draw (sim::CurvedFaces) until
/// nothing turns by more than kRoundAngle from one triangle to the next. Faces that share an edge divide it
/// alike, so what was closed stays closed.
struct RoundedSurface {
  struct Corner {
    std::uint32_t point = 0;
    std::uint32_t normal = 0;
    std::array<float, 4> weights{};  ///< shares of the face's corners, sum 1: for what varies over it
  };
  struct Triangle {
    std::uint32_t face = 0;  ///< of the surface it was made of
    std::array<Corner, 3> corners;
  };
  std::vector<sim::Vec3> points;    ///< cm; those of the surface come first
  std::vector<float> damage;        ///< one a point
  std::vector<sim::Vec3> normals;   ///< unit, outward; those of the surface come first
  std::vector<Triangle> triangles;  ///< in the order of the faces; counter-clockwise seen from outside
};

/// What has thirty sides looks round.
inline constexpr double kRoundAngle = 12.0;  // degrees

RoundedSurface roundedSurface(const sim::SurfaceMesh& surface);

}  // namespace modeling
