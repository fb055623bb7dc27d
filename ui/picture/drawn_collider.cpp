#include <cassert>
#include <cmath>
#include <numbers>

#include "ui/picture/drawn_mesh.h"

namespace ui {

namespace {

/// So fine that the polygon shows neither at the outline nor, with smooth normals, in the shading.
constexpr std::uint32_t kAround = 128;

/// Appends grids of vertices in the collider's own coordinates.
class ColliderDrawer {
 public:
  ColliderDrawer(const sim::Collider& collider, const sim::Vec3& middle, DrawnMesh& mesh)
      : collider_(collider),
        middle_(middle),
        mesh_(mesh),
        look_(static_cast<std::uint32_t>(mesh.looks.size())) {
    mesh.looks.push_back(
        {.colour = Light(0.30F, 0.27F, 0.245F), .glaze = 0.35F, .roughness = 0.22F, .grainy = false});
  }

  void drawBox() {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) drawBoxSide(axis, side);
    }
  }

  void drawSphere() {
    grid(kAround, kAround / 2, [&](double u, double v) {
      const double polar = std::numbers::pi * v;
      const sim::Vec3 normal(std::sin(polar) * std::cos(u), std::sin(polar) * std::sin(u), -std::cos(polar));
      addVertex(collider_.radius * normal, normal);
    });
  }

  void drawCylinder() {
    const double r = collider_.radius;
    const double h = collider_.halfHeight;
    grid(kAround, 1, [&](double u, double v) {
      const sim::Vec3 normal(std::cos(u), std::sin(u), 0.0);
      addVertex(r * normal + (2.0 * v - 1.0) * h * sim::Vec3::UnitZ(), normal);
    });
    for (const double side : {-1.0, 1.0}) {
      grid(kAround, 1, [&](double u, double v) {
        const double angle = side * u;
        const double reach = r * (1.0 - v);
        addVertex({reach * std::cos(angle), reach * std::sin(angle), side * h}, side * sim::Vec3::UnitZ());
      });
    }
  }

  /// Flat, each triangle as a quadrilateral whose last two corners are one.
  void drawTriangles() {
    const sim::TriangleMesh& triangles = *collider_.mesh;
    for (const auto& triangle : triangles.triangles()) {
      const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
      const sim::Vec3& a = triangles.points()[triangle[0]];
      const sim::Vec3& b = triangles.points()[triangle[1]];
      const sim::Vec3& c = triangles.points()[triangle[2]];
      const sim::Vec3 normal = (b - a).cross(c - a).stableNormalized();
      for (const sim::Vec3& corner : {a, b, c}) addVertex(corner, normal);
      mesh_.quads.push_back({first, first + 1, first + 2, first + 2});
      mesh_.lookOfQuad.push_back(look_);
    }
  }

 private:
  void addVertex(const sim::Vec3& point, const sim::Vec3& normal) {
    const sim::Vec3 world = collider_.position + collider_.rotation * point;
    mesh_.positions.push_back((world - middle_).cast<float>());
    mesh_.normals.push_back((collider_.rotation * normal).cast<float>());
    mesh_.restPoints.push_back(point.cast<float>());
  }

  void drawBoxSide(int axis, double side) {
    const int second = (axis + 1) % 3;
    const int third = (axis + 2) % 3;
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    sim::Vec3 normal = sim::Vec3::Zero();
    normal[axis] = side;
    for (const auto& [a, b] :
         {std::pair(-1.0, -1.0), std::pair(1.0, -1.0), std::pair(1.0, 1.0), std::pair(-1.0, 1.0)}) {
      sim::Vec3 corner = collider_.halfSize;
      corner[axis] *= side;
      corner[second] *= side * a;
      corner[third] *= b;
      addVertex(corner, normal);
    }
    mesh_.quads.push_back({first, first + 1, first + 2, first + 3});
    mesh_.lookOfQuad.push_back(look_);
  }

  /// addVertexAt(angle in [0, 2 pi], share in [0, 1]) appends one vertex.
  template <class AddVertexAt>
  void grid(std::uint32_t around, std::uint32_t along, const AddVertexAt& addVertexAt) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (std::uint32_t j = 0; j <= along; ++j) {
      for (std::uint32_t i = 0; i <= around; ++i) {
        addVertexAt(2.0 * std::numbers::pi * i / around, static_cast<double>(j) / along);
      }
    }
    const std::uint32_t row = around + 1;
    for (std::uint32_t j = 0; j < along; ++j) {
      for (std::uint32_t i = 0; i < around; ++i) {
        const std::uint32_t corner = first + j * row + i;
        mesh_.quads.push_back({corner, corner + 1, corner + row + 1, corner + row});
        mesh_.lookOfQuad.push_back(look_);
      }
    }
  }

  const sim::Collider& collider_;
  sim::Vec3 middle_;
  DrawnMesh& mesh_;
  std::uint32_t look_;
};

}  // namespace

void drawCollider(const sim::Collider& collider, const sim::Vec3& middle, DrawnMesh& mesh) {
  ColliderDrawer drawer(collider, middle, mesh);
  switch (collider.shape) {
    case sim::ColliderShape::box:
      return drawer.drawBox();
    case sim::ColliderShape::sphere:
      return drawer.drawSphere();
    case sim::ColliderShape::cylinder:
      return drawer.drawCylinder();
    case sim::ColliderShape::mesh:
      return drawer.drawTriangles();
    case sim::ColliderShape::floor:
      assert(false);
  }
}

}  // namespace ui
