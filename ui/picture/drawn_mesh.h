#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "modeling/material/glass.h"
#include "ui/picture/linear.h"
#include "ui/picture/picture.h"

namespace ui {

/// What a ray that meets a surface needs to know of it.
struct DrawnLook {
  Light colour = Light::Constant(0.5F);  ///< of diffuse reflection
  float glaze = 0.0F;                    ///< share of the surface under the glossy coat
  float roughness = 0.3F;                ///< GGX alpha of the coat
  bool grainy = false;                   ///< broken: fine bumps that stick to the material
  bool glass = false;                    ///< clear: `colour` is what passes through modeling::kGlassDepth
};

inline Light glassColour(const DrawnLook& look, float depth) {
  return look.colour.pow(depth / static_cast<float>(modeling::kGlassDepth));
}

/// Everything a picture shows except floors, as quadrilaterals (a triangle repeats its last corner), relative
/// to the middle of the subject.
struct DrawnMesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> endPositions;  ///< when the shutter closes, one a position; empty: nothing moves
  std::vector<Vec3f> normals;       ///< one a position
  std::vector<Vec3f> restPoints;    ///< one a position: what bumps stick to
  std::vector<std::array<std::uint32_t, 4>> quads;
  std::vector<std::uint32_t> lookOfQuad;
  std::vector<DrawnLook> looks;
};

/// The surface, curved, in its tints, and the visible colliders but floors. Where the scene tells how
/// things move, endPositions are filled in.
DrawnMesh drawMesh(const PictureScene& scene);

/// Appends a visible collider that is no floor.
void drawCollider(const sim::Collider& collider, const sim::Vec3& middle, DrawnMesh& mesh);

}  // namespace ui
