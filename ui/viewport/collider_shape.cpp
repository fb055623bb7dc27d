#include "ui/viewport/collider_shape.h"

#include "ui/viewport/colour_map.h"

namespace ui {
namespace {

/// A warm grey that is no material's: colliders stand back behind what breaks. sRGB.
constexpr Rgb kColliderColour{0.50F, 0.48F, 0.46F};
constexpr float kColliderGlaze = 0.25F;

}  // namespace

LevelDraw colliderMesh(const sim::Collider& collider) {
  const sim::ColliderSurface surface = sim::surfaceOf(collider);
  const std::uint32_t colour = packed(kColliderColour, kColliderGlaze);
  LevelDraw draw;
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const Eigen::Vector3f point = surface.points[i].cast<float>();
    draw.vertices.push_back({{point.x(), point.y(), point.z()}, packNormal(surface.normals[i]), colour});
  }
  for (const auto& quad : surface.quads) {
    for (const std::size_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) draw.indices.push_back(quad[corner]);
  }
  return draw;
}

}  // namespace ui
