#include "ui/viewport/collider_shape.h"

#include <cmath>
#include <numbers>

#include "ui/picture/drawn_mesh.h"
#include "ui/viewport/colour_map.h"

namespace ui {
namespace {

constexpr std::size_t kAround = 48;
/// A warm grey that is no material's: colliders stand back behind what breaks. sRGB.
constexpr Rgb kColliderColour{0.50F, 0.48F, 0.46F};
constexpr float kColliderGlaze = 0.25F;

using Segments = std::vector<std::array<sim::Vec3, 2>>;

void addCircle(const sim::Vec3& middle, const sim::Vec3& x, const sim::Vec3& y, Segments& segments) {
  const auto at = [&](std::size_t i) -> sim::Vec3 {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(kAround);
    return middle + std::cos(angle) * x + std::sin(angle) * y;
  };
  for (std::size_t i = 0; i < kAround; ++i) segments.push_back({at(i), at(i + 1)});
}

void addBox(const sim::Vec3& half, Segments& segments) {
  for (unsigned a = 0; a < 8; ++a) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if ((a >> axis) & 1U) continue;
      const auto corner = [&](unsigned c) -> sim::Vec3 {
        return {((c & 1U) ? 1.0 : -1.0) * half.x(), ((c & 2U) ? 1.0 : -1.0) * half.y(),
                ((c & 4U) ? 1.0 : -1.0) * half.z()};
      };
      segments.push_back({corner(a), corner(a | (1U << axis))});
    }
  }
}

void addCylinder(double radius, double half, Segments& segments) {
  const sim::Vec3 x = radius * sim::Vec3::UnitX();
  const sim::Vec3 y = radius * sim::Vec3::UnitY();
  for (const double side : {-1.0, 1.0}) addCircle(side * half * sim::Vec3::UnitZ(), x, y, segments);
  for (const sim::Vec3& at : {x, y, sim::Vec3(-x), sim::Vec3(-y)})
    segments.push_back(
        {sim::Vec3(at - half * sim::Vec3::UnitZ()), sim::Vec3(at + half * sim::Vec3::UnitZ())});
}

/// Each edge once, as far as it is drawn upwards by one of its triangles; those of a sheet's rim that are not
/// are left out, which an outline does not miss.
void addEdges(const sim::TriangleMesh& mesh, Segments& segments) {
  for (const auto& triangle : mesh.triangles()) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t from = triangle[c];
      const std::uint32_t to = triangle[(c + 1) % 3];
      if (from < to) segments.push_back({mesh.points()[from], mesh.points()[to]});
    }
  }
}

}  // namespace

LevelDraw colliderMesh(const sim::Collider& collider) {
  LevelDraw draw;
  if (collider.shape == sim::ColliderShape::floor) return draw;
  sim::Collider atOrigin = collider;
  atOrigin.position.setZero();
  atOrigin.rotation.setIdentity();
  DrawnMesh mesh;
  drawCollider(atOrigin, sim::Vec3::Zero(), mesh);
  const std::uint32_t colour = packed(kColliderColour, kColliderGlaze);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const auto& position = mesh.positions[v];
    draw.vertices.push_back({{position.x(), position.y(), position.z()},
                             packNormal(mesh.normals[v].cast<double>().matrix()),
                             colour});
  }
  for (const auto& quad : mesh.quads) {
    for (const std::size_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) draw.indices.push_back(quad[corner]);
  }
  return draw;
}

std::vector<std::array<sim::Vec3, 2>> colliderOutline(const sim::Collider& collider) {
  Segments segments;
  const double r = collider.radius;
  switch (collider.shape) {
    case sim::ColliderShape::floor:
      addBox({20.0, 20.0, 0.0}, segments);
      break;
    case sim::ColliderShape::box:
      addBox(collider.halfSize, segments);
      break;
    case sim::ColliderShape::sphere:
      addCircle(sim::Vec3::Zero(), r * sim::Vec3::UnitX(), r * sim::Vec3::UnitY(), segments);
      addCircle(sim::Vec3::Zero(), r * sim::Vec3::UnitY(), r * sim::Vec3::UnitZ(), segments);
      addCircle(sim::Vec3::Zero(), r * sim::Vec3::UnitZ(), r * sim::Vec3::UnitX(), segments);
      break;
    case sim::ColliderShape::cylinder:
      addCylinder(r, collider.halfHeight, segments);
      break;
    case sim::ColliderShape::mesh:
      addEdges(*collider.mesh, segments);
      break;
  }
  for (auto& segment : segments) {
    for (sim::Vec3& point : segment) point = collider.position + collider.rotation * point;
  }
  return segments;
}

Eigen::AlignedBox3d boxOf(const sim::Collider& collider) {
  Eigen::AlignedBox3d box;
  if (collider.shape == sim::ColliderShape::floor) return box;
  for (const auto& segment : colliderOutline(collider)) {
    for (const sim::Vec3& point : segment) box.extend(point);
  }
  return box;
}

bool sameShape(const sim::Collider& left, const sim::Collider& right) {
  return left.shape == right.shape && left.halfSize == right.halfSize && left.radius == right.radius &&
         left.halfHeight == right.halfHeight && left.mesh == right.mesh;
}

}  // namespace ui
