#include "ui/picture/drawn_mesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <tuple>

#include "sim/base/random.h"
#include "sim/surface/curved_faces.h"

namespace ui {

namespace {

/// Quads a side of a drawn face: enough that no polygon shows at the outline, as long as memory stays small.
constexpr std::size_t kFinest = 6;
constexpr std::size_t kMostQuads = 800'000;

constexpr std::uint64_t kTintSeed = 0x71f7;
/// Largest change of a fragment's brightness and of the balance between its red and its blue.
constexpr double kTintBrightness = 0.10;
constexpr double kTintWarmth = 0.035;

std::size_t subdivision(std::size_t faceCount) {
  std::size_t parts = kFinest;
  while (parts > 1 && parts * parts * faceCount > kMostQuads) --parts;
  return parts;
}

/// The material's colour as this fragment has it. Fragment 0 is what most was at the start: it keeps its
/// colour.
Light tinted(const Light& colour, sim::FragmentId fragment) {
  if (fragment == 0) return colour;
  const double brightness = 1.0 - kTintBrightness * sim::uniformAt(kTintSeed, 2ULL * fragment);
  const double warmth = kTintWarmth * (2.0 * sim::uniformAt(kTintSeed, 2ULL * fragment + 1) - 1.0);
  const Light factor(static_cast<float>(brightness * (1.0 + warmth)), static_cast<float>(brightness),
                     static_cast<float>(brightness * (1.0 - warmth)));
  return (colour * factor).min(1.0F);
}

DrawnLook drawnLook(const modeling::Look& look, bool inside, sim::FragmentId fragment) {
  DrawnLook drawn;
  drawn.glass = look.finish == modeling::Finish::glass;
  if (drawn.glass) {
    drawn.colour = linearFromSrgb(look.outside);
    return drawn;
  }
  drawn.colour = tinted(linearFromSrgb(inside ? look.inside : look.outside), fragment);
  drawn.grainy = inside;
  if (inside || look.finish == modeling::Finish::matte) return drawn;
  const auto glaze = static_cast<float>(std::clamp(look.glaze, 0.0, 1.0));
  drawn.glaze = std::sqrt(glaze);
  drawn.roughness = 0.015F + 0.25F * (1.0F - glaze) * (1.0F - glaze) * (1.0F - glaze);
  return drawn;
}

class LookTable {
 public:
  LookTable(const PictureScene& scene, DrawnMesh& mesh) : scene_(scene), mesh_(mesh) {}

  std::uint32_t lookOf(const sim::SurfaceMesh::Face& face) {
    const auto [entry, isNew] = table_.try_emplace(std::tuple(face.fragment, face.material, face.inside),
                                                   static_cast<std::uint32_t>(mesh_.looks.size()));
    if (isNew) {
      const bool known = face.material < scene_.looks.size();
      mesh_.looks.push_back(
          drawnLook(known ? scene_.looks[face.material] : modeling::Look{}, face.inside, face.fragment));
    }
    return entry->second;
  }

 private:
  const PictureScene& scene_;
  DrawnMesh& mesh_;
  std::map<std::tuple<sim::FragmentId, sim::MaterialIndex, bool>, std::uint32_t> table_;
};

class SurfaceDrawer {
 public:
  SurfaceDrawer(const sim::SurfaceMesh& surface, const PictureScene& scene, const sim::Vec3& middle,
                DrawnMesh& mesh)
      : surface_(surface),
        middle_(middle),
        curved_(surface),
        parts_(subdivision(surface.faces.size())),
        looks_(scene, mesh),
        mesh_(mesh) {}

  void drawFace(std::size_t face) {
    if (surface_.faces[face].cornerCount == 3 && surface_.faces[face].inside) {
      drawTriangle(face);
    } else {
      drawPatch(face);
    }
  }

 private:
  void addVertex(const sim::Vec3& point, const sim::Vec3& normal, const sim::Vec3& restPoint) {
    mesh_.positions.push_back((point - middle_).cast<float>());
    mesh_.normals.push_back(normal.cast<float>());
    mesh_.restPoints.push_back(restPoint.cast<float>());
  }

  void drawTriangle(std::size_t f) {
    const auto& face = surface_.faces[f];
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (unsigned c = 0; c < 3; ++c) {
      const std::uint32_t point = face.points[c];
      addVertex(surface_.points[point], surface_.normals[face.normals[c]], surface_.restPoints[point]);
    }
    mesh_.quads.push_back({first, first + 1, first + 2, first + 2});
    mesh_.lookOfQuad.push_back(looks_.lookOf(face));
  }

  void drawPatch(std::size_t f) {
    const auto& face = surface_.faces[f];
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (std::size_t j = 0; j <= parts_; ++j) {
      for (std::size_t i = 0; i <= parts_; ++i) addPatchVertex(f, i, j);
    }
    const std::uint32_t look = looks_.lookOf(face);
    const auto row = static_cast<std::uint32_t>(parts_ + 1);
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      for (std::uint32_t i = 0; i + 1 < row; ++i) {
        const std::uint32_t corner = first + j * row + i;
        mesh_.quads.push_back({corner, corner + 1, corner + row + 1, corner + row});
        mesh_.lookOfQuad.push_back(look);
      }
    }
  }

  void addPatchVertex(std::size_t f, std::size_t i, std::size_t j) {
    const auto& face = surface_.faces[f];
    const double u = static_cast<double>(i) / static_cast<double>(parts_);
    const double v = static_cast<double>(j) / static_cast<double>(parts_);
    const std::array<double, 4> weights{(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
    sim::Vec3 normal = sim::Vec3::Zero();
    sim::Vec3 restPoint = sim::Vec3::Zero();
    for (unsigned c = 0; c < 4; ++c) {
      normal += weights[c] * surface_.normals[face.normals[c]];
      restPoint += weights[c] * surface_.restPoints[face.points[c]];
    }
    addVertex(curved_.point(f, u, v), normal.stableNormalized(), restPoint);
  }

  const sim::SurfaceMesh& surface_;
  sim::Vec3 middle_;
  sim::CurvedFaces curved_;
  std::size_t parts_;
  LookTable looks_;
  DrawnMesh& mesh_;
};

/// What passes through glass meets covered faces too: it leaves one part there and enters the other.
bool isSeen(const PictureScene& scene, const sim::SurfaceMesh::Face& face) {
  return !face.covered ||
         (face.material < scene.looks.size() && scene.looks[face.material].finish == modeling::Finish::glass);
}

DrawnMesh drawnAt(const PictureScene& scene, const sim::SurfaceMesh& surface,
                  const std::vector<sim::Collider>& colliders) {
  DrawnMesh mesh;
  const sim::Vec3 middle = scene.subject.center();
  SurfaceDrawer drawer(surface, scene, middle, mesh);
  for (std::size_t face = 0; face < surface.faces.size(); ++face) {
    if (isSeen(scene, surface.faces[face])) drawer.drawFace(face);
  }
  for (const sim::Collider& collider : colliders) {
    if (collider.visible && !collider.isFloor()) drawCollider(collider, middle, mesh);
  }
  return mesh;
}

}  // namespace

DrawnMesh drawMesh(const PictureScene& scene) {
  DrawnMesh mesh = drawnAt(scene, scene.surface, scene.colliders);
  if (!scene.endPoints.empty()) {
    sim::SurfaceMesh end = scene.surface;
    end.points = scene.endPoints;
    end.normals = scene.endNormals;
    mesh.endPositions = drawnAt(scene, end, scene.endColliders).positions;
    assert(mesh.endPositions.size() == mesh.positions.size());
  }
  return mesh;
}

}  // namespace ui
