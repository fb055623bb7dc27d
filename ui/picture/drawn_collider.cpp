#include "ui/picture/drawn_mesh.h"

namespace ui {

void drawCollider(const sim::Collider& collider, const sim::Vec3& middle, DrawnMesh& mesh) {
  const auto look = static_cast<std::uint32_t>(mesh.looks.size());
  mesh.looks.push_back(
      {.colour = Light(0.30F, 0.27F, 0.245F), .glaze = 0.35F, .roughness = 0.22F, .grainy = false});
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const sim::ColliderSurface surface = sim::surfaceOf(collider);
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const sim::Vec3 world = collider.position + collider.rotation * surface.points[i];
    mesh.positions.push_back((world - middle).cast<float>());
    mesh.normals.push_back((collider.rotation * surface.normals[i]).cast<float>());
    mesh.restPoints.push_back(surface.points[i].cast<float>());
  }
  for (std::array<std::uint32_t, 4> quad : surface.quads) {
    for (std::uint32_t& corner : quad) corner += first;
    mesh.quads.push_back(quad);
    mesh.lookOfQuad.push_back(look);
  }
}

}  // namespace ui
