#include "ui/kinds/new_things.h"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <optional>

#include "ui/document/new_scene.h"
#include "ui/document/part_boxes.h"
#include "ui/document/scene_edits.h"
#include "ui/kinds/collider_kinds.h"
#include "ui/kinds/part_kinds.h"

namespace ui {
namespace {

using modeling::Part;
using modeling::Scene;
using modeling::Vec3;

constexpr double kGap = 2.0;  ///< cm between neighbours: near, but nothing touches

/// Height of the highest floor that lies flat; 0 where there is none.
double floorHeight(const Scene& scene) {
  std::optional<double> height;
  for (const modeling::SceneCollider& collider : scene.environment.colliders) {
    if (!collider.isFloor() || collider.rotation != modeling::Rotation{}) continue;
    height = std::max(height.value_or(collider.position.z()), collider.position.z());
  }
  return height.value_or(0.0);
}

std::string materialFor(const Scene& scene, const std::vector<Item>& selected) {
  for (auto item = selected.rbegin(); item != selected.rend(); ++item) {
    if (item->kind == ItemKind::material && item->index < scene.materials.size())
      return scene.materials[item->index].name;
    const bool part = item->kind == ItemKind::part && item->index < scene.parts.size();
    if (part && !scene.parts[item->index].material.empty()) return scene.parts[item->index].material;
  }
  return scene.materials.front().name;
}

/// Where something with this extent stands beside all there is.
Vec3 placeBeside(const Scene& scene, const Eigen::AlignedBox3d& own) {
  const Eigen::AlignedBox3d there = boxOf(scene);
  Vec3 place = Vec3::Zero();
  place.z() = floorHeight(scene) - own.min().z();
  if (there.isEmpty()) return place;
  place.x() = there.max().x() + kGap - own.min().x();
  return place;
}

/// The body that was selected last, if it is one of revolution.
std::optional<std::size_t> bodyAmong(const Scene& scene, const std::vector<Item>& selected) {
  if (selected.empty() || selected.back().kind != ItemKind::part) return std::nullopt;
  const std::size_t index = selected.back().index;
  if (index >= scene.parts.size()) return std::nullopt;
  const bool turned = std::holds_alternative<modeling::RevolutionShape>(scene.parts[index].shape);
  return turned ? std::optional(index) : std::nullopt;
}

std::optional<Item> addToBody(Scene& scene, const NewThing& thing, const std::vector<Item>& selected) {
  const std::optional<std::size_t> body = bodyAmong(scene, selected);
  if (thing.atWall == nullptr || !body) return std::nullopt;
  const auto& shape = std::get<modeling::RevolutionShape>(scene.parts[*body].shape);
  const std::optional<modeling::PartShape> fitted = thing.atWall(shape);
  if (!fitted) return std::nullopt;
  Part part = scene.parts[*body];  // its place, motion and material
  part.name = uniqueName(thing.name, namesOf(scene, ItemKind::part));
  part.shape = *fitted;
  part.hold.clear();
  modeling::Gluing gluing;
  gluing.a = part.name;
  gluing.b = scene.parts[*body].name;
  // Half a diagonal of a face is the farthest a node can be from the nearest of a wall; a little less, and
  // the handle's second layer stays free.
  gluing.reach = 0.65 * shape.resolution.cellSize * part.worldFromPart.scale.factors.maxCoeff();
  scene.parts.push_back(std::move(part));
  scene.glue.push_back(std::move(gluing));
  return Item{ItemKind::part, scene.parts.size() - 1};
}

Item addCollider(Scene& scene, const NewThing& thing) {
  modeling::SceneCollider collider;
  collider.name = uniqueName(thing.name, namesOf(scene, ItemKind::collider));
  collider.form = std::get<modeling::ColliderForm>(thing.form);
  if (!collider.isFloor()) collider.position = placeBeside(scene, boxOf(collider));
  scene.environment.colliders.push_back(std::move(collider));
  return {ItemKind::collider, scene.environment.colliders.size() - 1};
}

void needMaterial(Scene& scene) {
  if (!scene.materials.empty()) return;
  const Scene fresh = newScene();
  if (scene.parts.empty() && scene.environment.colliders.empty())
    scene.environment.colliders = fresh.environment.colliders;
  scene.materials = fresh.materials;
}

/// Of the file without its ending.
std::string nameOfFile(const std::string& file) {
  const std::string stem = std::filesystem::path(file).stem().string();
  return stem.empty() ? "mesh" : stem;
}

}  // namespace

const std::vector<NewThing>& newThings() {
  static const std::vector<NewThing> things = [] {
    std::vector<NewThing> all = newParts();
    for (NewThing& collider : newColliders()) all.push_back(std::move(collider));
    return all;
  }();
  return things;
}

const NewThing& newThing(std::string_view name) {
  const auto found =
      std::ranges::find_if(newThings(), [name](const NewThing& thing) { return thing.name == name; });
  assert(found != newThings().end());
  return *found;
}

Item addThing(Scene& scene, const NewThing& thing, const std::vector<Item>& selected) {
  if (thing.isCollider()) return addCollider(scene, thing);
  needMaterial(scene);
  if (const std::optional<Item> item = addToBody(scene, thing, selected)) return *item;
  Part part;
  part.name = uniqueName(thing.name, namesOf(scene, ItemKind::part));
  part.shape = std::get<modeling::PartShape>(thing.form);
  part.material = materialFor(scene, selected);
  part.worldFromPart.position = placeBeside(scene, boxOf(part.shape));
  scene.parts.push_back(std::move(part));
  return {ItemKind::part, scene.parts.size() - 1};
}

Item addMesh(Scene& scene, const std::string& file, const std::vector<Item>& selected) {
  needMaterial(scene);
  modeling::MeshShape shape;
  shape.file = file;
  Part part;
  part.name = uniqueName(nameOfFile(file), namesOf(scene, ItemKind::part));
  part.shape = std::move(shape);
  part.material = materialFor(scene, selected);
  scene.parts.push_back(std::move(part));
  return {ItemKind::part, scene.parts.size() - 1};
}

Item addMeshObstacle(Scene& scene, const std::string& file) {
  modeling::MeshObstacle obstacle;
  obstacle.file = file;
  modeling::SceneCollider collider;
  collider.name = uniqueName(nameOfFile(file), namesOf(scene, ItemKind::collider));
  collider.form = std::move(obstacle);
  scene.environment.colliders.push_back(std::move(collider));
  return {ItemKind::collider, scene.environment.colliders.size() - 1};
}

Item addNetwork(Scene& scene, const std::string& file, int bondTypes) {
  Part part;
  part.name = uniqueName("network", namesOf(scene, ItemKind::part));
  modeling::NetworkShape shape;
  shape.file = file;
  constexpr double kStiffness = 1e5;
  for (int type = 1; type <= bondTypes; ++type)
    shape.bondTypes.push_back({std::to_string(type), {kStiffness, std::nullopt, 1.0, std::nullopt}});
  part.shape = std::move(shape);
  scene.parts.push_back(std::move(part));
  return {ItemKind::part, scene.parts.size() - 1};
}

}  // namespace ui
