#include "ui/document/new_parts.h"

#include <QCoreApplication>
#include <filesystem>

#include "modeling/shapes/measured_chain.h"
#include "ui/document/new_scene.h"
#include "ui/document/part_boxes.h"
#include "ui/document/scene_edits.h"

namespace ui {
namespace {

using modeling::Part;
using modeling::Scene;
using modeling::Vec3;
using Kind = NewThing::Kind;

constexpr double kGap = 2.0;  ///< cm between neighbours: near, but nothing touches

QString translated(const char* text) {
  return QCoreApplication::translate("new parts", text);
}

modeling::SlabShape slab() {
  modeling::SlabShape shape;
  shape.size = Vec3(8.0, 8.0, 1.0);
  shape.resolution.cellSize = 0.5;
  return shape;
}

/// A solid disc: where the inside runs along the axis, nothing is hollow.
modeling::RevolutionShape turnedSolid() {
  using modeling::Vec2;
  modeling::RevolutionShape shape;
  shape.outside = {modeling::straightSegment(Vec2(0, 0), Vec2(2.5, 0)),
                   modeling::straightSegment(Vec2(2.5, 0), Vec2(2.5, 8)),
                   modeling::straightSegment(Vec2(2.5, 8), Vec2(0, 8))};
  shape.inside = {modeling::straightSegment(Vec2(0, 0), Vec2(0, 8))};
  shape.resolution.cellSize = 0.8;
  return shape;
}

/// A tile that is arched like a leaf, its edges on the ground.
modeling::BezierPatchShape patch() {
  modeling::BezierPatchShape shape;
  const double along[4] = {-4.0, -1.4, 1.4, 4.0};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const bool inner = j == 1 || j == 2;
      shape.net[i][j] = Vec3(along[i], along[j], inner ? 2.4 : 0.3);
    }
  }
  shape.thickness = 0.5;
  shape.resolution.cellSize = 0.5;
  return shape;
}

/// A point of a wall and the way out of it, in the plane of x and z.
struct Hold {
  Vec3 point = Vec3::Zero();
  Vec3 out = Vec3::UnitX();  ///< unit
};

/// From one hold out and back to a lower one.
modeling::CurvedCylinderShape handle(const Hold& upper, const Hold& lower, double cellSize) {
  modeling::CurvedCylinderShape shape;
  const double reach = 0.75 * (upper.point.z() - lower.point.z());
  shape.curve = {{upper.point, upper.point + reach * (upper.out + Vec3(0.0, 0.0, 0.15)),
                  lower.point + reach * (1.05 * lower.out - Vec3(0.0, 0.0, 0.1)), lower.point}};
  shape.section = modeling::SweepSection::rectangle;
  shape.firstAxis = Vec3::UnitZ();
  shape.halfWidth = modeling::constantValue(0.35);
  shape.halfDepth = modeling::constantValue(0.55);
  shape.resolution.cellSize = cellSize;
  return shape;
}

/// Out of the wall and up, narrower as it rises.
modeling::CurvedCylinderShape spout(const Hold& foot, double height, double cellSize) {
  modeling::CurvedCylinderShape shape;
  const double side = foot.out.x() < 0.0 ? -1.0 : 1.0;
  const Vec3 tip = foot.point + height * Vec3(0.62 * side, 0.0, 1.0);
  shape.curve = {{foot.point, foot.point + 0.5 * height * foot.out,
                  foot.point + height * Vec3(0.3 * side, 0.0, 0.75), tip}};
  shape.section = modeling::SweepSection::ring;
  shape.halfWidth = {{1.35, 1.1, 0.9, 0.8}};
  shape.halfDepth = {{1.35, 1.1, 0.9, 0.8}};
  shape.wallThickness = 0.4;
  shape.resolution.cellSize = cellSize;
  shape.resolution.counts[2] = 1;
  return shape;
}

modeling::PartShape shapeOf(const NewThing& thing) {
  constexpr double kHandleCell = 0.5;
  switch (thing.kind) {
    case Kind::profile:
      return shapeOf(thing.preset.value_or(ProfilePreset::cup));
    case Kind::turnedSolid:
      return turnedSolid();
    case Kind::patch:
      return patch();
    case Kind::handle:
      return handle({Vec3(0, 0, 6), Vec3::UnitX()}, {Vec3(0, 0, 2), Vec3::UnitX()}, kHandleCell);
    case Kind::spout:
      return spout({Vec3(0, 0, 1.5), Vec3::UnitX()}, 6.0, kHandleCell);
    default:
      return slab();
  }
}

const char* nameInScene(const NewThing& thing) {
  switch (thing.kind) {
    case Kind::profile: {
      constexpr const char* kNames[] = {"cup", "bowl", "plate", "vase", "bottle", "teapot"};
      return kNames[static_cast<std::size_t>(thing.preset.value_or(ProfilePreset::cup))];
    }
    case Kind::turnedSolid:
      return "solid";
    case Kind::slab:
      return "slab";
    case Kind::patch:
      return "patch";
    case Kind::handle:
      return "handle";
    case Kind::spout:
      return "spout";
    case Kind::floor:
      return "floor";
    case Kind::box:
      return "box";
    case Kind::sphere:
      return "sphere";
    case Kind::cylinder:
      return "cylinder";
  }
  return "part";
}

/// Height of the highest floor that lies flat; 0 where there is none.
double floorHeight(const Scene& scene) {
  std::optional<double> height;
  for (const modeling::SceneCollider& collider : scene.environment.colliders) {
    if (!std::holds_alternative<modeling::FloorShape>(collider.form) ||
        collider.rotation != modeling::Rotation{})
      continue;
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

/// At the wall of a body, in the body's coordinates; nothing where its wall is too low.
std::optional<modeling::PartShape> fitted(const modeling::RevolutionShape& body, Kind kind) {
  const Eigen::AlignedBox3d box = boxOf(modeling::PartShape(body));
  const double height = box.sizes().z();
  const double cell = std::min(body.resolution.cellSize, 0.6);
  // A handle is on the left, a spout on the right, as of a teapot.
  const auto onWall = [&](double share, double side) -> std::optional<Hold> {
    const double z = box.min().z() + share * height;
    const double near = 0.02 * height;
    const std::optional<double> below = outsideRadiusAt(body, z - near);
    const std::optional<double> here = outsideRadiusAt(body, z);
    const std::optional<double> above = outsideRadiusAt(body, z + near);
    if (!below || !here || !above) return std::nullopt;
    const double slope = (*above - *below) / (2.0 * near);
    return Hold{Vec3(side * *here, 0.0, z), Vec3(side, 0.0, -slope).normalized()};
  };
  // A tube needs more height than a bar, or it would fold where it turns up.
  const double least = kind == Kind::handle ? 2.5 : 7.0;
  if (height < least) return std::nullopt;
  if (kind == Kind::handle) {
    const std::optional<Hold> upper = onWall(0.8, -1.0);
    const std::optional<Hold> lower = onWall(0.3, -1.0);
    if (!upper || !lower) return std::nullopt;
    return handle(*upper, *lower, cell);
  }
  const std::optional<Hold> foot = onWall(0.35, 1.0);
  if (!foot) return std::nullopt;
  return spout(*foot, 0.65 * height, cell);
}

std::optional<Item> addToBody(Scene& scene, const NewThing& thing, const std::vector<Item>& selected) {
  if (thing.kind != Kind::handle && thing.kind != Kind::spout) return std::nullopt;
  const std::optional<std::size_t> body = bodyAmong(scene, selected);
  if (!body) return std::nullopt;
  const auto& shape = std::get<modeling::RevolutionShape>(scene.parts[*body].shape);
  const std::optional<modeling::PartShape> form = fitted(shape, thing.kind);
  if (!form) return std::nullopt;
  Part part = scene.parts[*body];  // its place, motion and material
  part.name = uniqueName(nameInScene(thing), namesOf(scene, ItemKind::part));
  part.shape = *form;
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
  collider.name = uniqueName(nameInScene(thing), namesOf(scene, ItemKind::collider));
  Vec3 half = Vec3::Constant(4.0);
  if (thing.kind == Kind::box) collider.form = modeling::BoxShape{half};
  if (thing.kind == Kind::sphere) collider.form = modeling::SphereShape{half.x()};
  if (thing.kind == Kind::cylinder) {
    half = Vec3(3.0, 3.0, 4.0);
    collider.form = modeling::CylinderShape{half.x(), half.z()};
  }
  if (thing.kind != Kind::floor) collider.position = placeBeside(scene, Eigen::AlignedBox3d(-half, half));
  scene.environment.colliders.push_back(std::move(collider));
  return {ItemKind::collider, scene.environment.colliders.size() - 1};
}

}  // namespace

const std::vector<NewThing>& newThings() {
  static const std::vector<NewThing> things = [] {
    std::vector<NewThing> all;
    for (const ProfilePreset preset : kProfilePresets) all.push_back({Kind::profile, preset});
    for (const Kind kind : {Kind::handle, Kind::spout, Kind::slab, Kind::patch, Kind::turnedSolid,
                            Kind::floor, Kind::box, Kind::sphere, Kind::cylinder})
      all.push_back({kind, std::nullopt});
    return all;
  }();
  return things;
}

QString nameOf(const NewThing& thing) {
  switch (thing.kind) {
    case Kind::profile:
      return nameOf(thing.preset.value_or(ProfilePreset::cup));
    case Kind::turnedSolid:
      return translated("Solid of Revolution");
    case Kind::slab:
      return translated("Slab");
    case Kind::patch:
      return translated("Patch");
    case Kind::handle:
      return translated("Handle");
    case Kind::spout:
      return translated("Spout");
    case Kind::floor:
      return translated("Floor");
    case Kind::box:
      return translated("Box");
    case Kind::sphere:
      return translated("Sphere");
    case Kind::cylinder:
      return translated("Cylinder");
  }
  return {};
}

QString helpOf(const NewThing& thing) {
  switch (thing.kind) {
    case Kind::profile:
      return translated("A dish turned from two profiles, which stay editable");
    case Kind::turnedSolid:
      return translated("A full body turned from a profile");
    case Kind::slab:
      return translated("A flat block: pane, tile, board");
    case Kind::patch:
      return translated("A wall along a curved surface with 16 control points");
    case Kind::handle:
      return translated("A curved bar; at the wall of the dish that is selected, and glued to it");
    case Kind::spout:
      return translated("A curved tube; at the wall of the dish that is selected, and glued to it");
    case Kind::floor:
      return translated("An endless plane that nothing passes");
    case Kind::box:
    case Kind::sphere:
    case Kind::cylinder:
      return translated("Something rigid that stands in the way and never moves by itself");
  }
  return {};
}

QString iconNameOf(const NewThing& thing) {
  switch (thing.kind) {
    case Kind::profile:
    case Kind::turnedSolid:
      return QStringLiteral("revolution");
    case Kind::slab:
      return QStringLiteral("slab");
    case Kind::patch:
      return QStringLiteral("patch");
    case Kind::handle:
      return QStringLiteral("curved-cylinder");
    case Kind::spout:
      return QStringLiteral("spout");
    case Kind::floor:
      return QStringLiteral("floor");
    case Kind::box:
      return QStringLiteral("box");
    case Kind::sphere:
      return QStringLiteral("sphere");
    case Kind::cylinder:
      return QStringLiteral("cylinder");
  }
  return {};
}

bool isCollider(const NewThing& thing) {
  return thing.kind == Kind::floor || thing.kind == Kind::box || thing.kind == Kind::sphere ||
         thing.kind == Kind::cylinder;
}

std::optional<double> outsideRadiusAt(const modeling::RevolutionShape& shape, double z) {
  constexpr int kSteps = 64;
  std::optional<double> radius;
  for (const auto& segment : shape.outside) {
    modeling::Vec2 before = segment[0];
    for (int i = 1; i <= kSteps; ++i) {
      const modeling::Vec2 after = modeling::evaluate(segment, static_cast<double>(i) / kSteps);
      const double low = std::min(before.y(), after.y());
      const double high = std::max(before.y(), after.y());
      if (z >= low && z <= high && high > low) {
        const double share = (z - before.y()) / (after.y() - before.y());
        const double here = before.x() + share * (after.x() - before.x());
        radius = std::max(radius.value_or(here), here);
      }
      before = after;
    }
  }
  return radius;
}

namespace {

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

Item addThing(Scene& scene, const NewThing& thing, const std::vector<Item>& selected) {
  if (isCollider(thing)) return addCollider(scene, thing);
  needMaterial(scene);
  if (const std::optional<Item> item = addToBody(scene, thing, selected)) return *item;
  Part part;
  part.name = uniqueName(nameInScene(thing), namesOf(scene, ItemKind::part));
  part.shape = shapeOf(thing);
  part.material = materialFor(scene, selected);
  part.worldFromPart.position = placeBeside(scene, boxOf(part.shape));
  scene.parts.push_back(std::move(part));
  return {ItemKind::part, scene.parts.size() - 1};
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
