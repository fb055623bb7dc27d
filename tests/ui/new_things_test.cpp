#include "ui/kinds/new_things.h"

#include <QFile>
#include <algorithm>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "sim/surface/surface_mesh.h"
#include "ui/document/part_boxes.h"
#include "ui/document/scene_edits.h"
#include "ui/kinds/collider_kinds.h"
#include "ui/kinds/part_kinds.h"

using namespace ui;
using modeling::Scene;

namespace {

modeling::BuiltScene built(const Scene& scene) {
  sim::Result<modeling::BuiltScene> result = modeling::build(scene, {});
  if (!result) FAIL(result.problem().line());
  return std::move(result).value();
}

/// Where the nodes of the scene's parts are, one box a part; parts that are glued have nodes in common.
Eigen::AlignedBox3d extentOf(const Scene& scene, std::size_t part) {
  Scene alone = scene;
  alone.glue.clear();
  alone.parts = {scene.parts[part]};
  Eigen::AlignedBox3d box;
  for (const sim::Vec3& position : sim::momentAtRest(built(alone).network).positions) box.extend(position);
  return box;
}

template <class Variant, class Visit>
void forEachKind(const Visit& visit) {
  [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    (visit(Variant(std::in_place_index<kIndex>)), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>());
}

/// Whether the add menu has one of the kind.
template <class Variant>
bool isOffered(const Variant& kind) {
  return std::ranges::any_of(newThings(), [&](const NewThing& thing) {
    const auto* form = std::get_if<Variant>(&thing.form);
    return form != nullptr && form->index() == kind.index();
  });
}

bool hasDrawing(const QString& icon) {
  return QFile::exists(QStringLiteral(SMITHEREENS_SOURCE_DIR "/resources/icons/") + icon +
                       QStringLiteral(".svg"));
}

}  // namespace

TEST_CASE("Each kind has a title and an icon, and is offered unless it stands in a file", "[new-things]") {
  forEachKind<modeling::PartShape>([](const modeling::PartShape& shape) {
    INFO(modeling::kindName(shape));
    const PartKind kind = kindOf(shape);
    CHECK_FALSE(kind.title.isEmpty());
    CHECK(hasDrawing(kind.icon));
    CHECK((kind.editor == ShapeEditor::points) == (kind.points != nullptr));
    const bool inFile = std::holds_alternative<modeling::NetworkShape>(shape) ||
                        std::holds_alternative<modeling::MeshShape>(shape);
    CHECK(isOffered(shape) != inFile);
    CHECK(kind.axes[0].isEmpty() == inFile);
  });
  forEachKind<modeling::ColliderForm>([](const modeling::ColliderForm& form) {
    INFO(modeling::kindName(form));
    const ColliderKind kind = kindOf(form);
    CHECK_FALSE(kind.title.isEmpty());
    CHECK_FALSE(kind.help.isEmpty());
    CHECK(hasDrawing(kind.icon));
    CHECK(isOffered(form) != std::holds_alternative<modeling::MeshObstacle>(form));
  });
  for (const NewThing& thing : newThings()) {
    INFO(thing.name);
    CHECK(hasDrawing(thing.icon));
    CHECK(&newThing(thing.name) == &thing);
  }
}

TEST_CASE("Everything that can be added can be built, of good cells", "[new-things]") {
  for (const NewThing& thing : newThings()) {
    if (thing.isCollider()) continue;
    INFO(thing.name);
    Scene scene;
    addThing(scene, thing, {});
    const modeling::BuiltScene result = built(scene);
    REQUIRE(result.parts.size() == 1);
    CHECK(result.parts[0].quality.minScaledJacobian > 0.35);
    CHECK(result.parts[0].quality.maxAspect < 5.0);
    CHECK(result.parts[0].nodes > 80);
    CHECK(result.parts[0].nodes < 6000);
    const sim::Result<modeling::SceneFile> again = modeling::parseScene(modeling::writeScene(scene), "again");
    REQUIRE(again);
    CHECK(again->scene == scene);
  }
}

TEST_CASE("The first thing brings a material and a floor, and stands on it", "[new-things]") {
  Scene scene;
  const Item cup = addThing(scene, newThings().front(), {});
  CHECK(cup == Item{ItemKind::part, 0});
  CHECK(scene.materials.size() == 1);
  REQUIRE(scene.environment.colliders.size() == 1);
  CHECK(std::holds_alternative<modeling::FloorShape>(scene.environment.colliders[0].form));
  CHECK(extentOf(scene, 0).min().z() == Approx(0.0).margin(1e-9));
}

TEST_CASE("What is added stands on the floor beside what is there, and touches nothing", "[new-things]") {
  Scene scene;
  modeling::SceneCollider table;
  table.name = "table";
  table.form = modeling::FloorShape{};
  table.position = sim::Vec3(0, 0, 70);
  scene.environment.colliders.push_back(table);
  for (const NewThing& thing : newThings()) addThing(scene, thing, {});
  const sim::Status whole = modeling::checkScene(scene);
  REQUIRE(whole);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    boxes.push_back(extentOf(scene, i));
    INFO(scene.parts[i].name);
    CHECK(boxes.back().min().z() > 70.0 - 1e-6);
    CHECK(boxes.back().min().z() < 71.5);
    // The outline that placing relies on holds all nodes.
    Eigen::AlignedBox3d outline = boxOf(scene.parts[i]);
    outline.min().array() -= 1e-6;
    outline.max().array() += 1e-6;
    CHECK(outline.contains(boxes.back()));
    for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(boxes[i].intersects(boxes[j]));
  }
  CHECK(built(scene).warnings.empty());
}

TEST_CASE("A handle and a spout come to stand at the wall of the dish that is selected", "[new-things]") {
  for (const ProfilePreset preset : {ProfilePreset::cup, ProfilePreset::vase, ProfilePreset::teapotBody}) {
    INFO(nameOf(preset).toStdString());
    Scene scene;
    const Item body = addThing(scene, newThing(nameInScene(preset)), {});
    scene.parts[0].worldFromPart.position = sim::Vec3(3, 4, 5);
    for (const char* name : {"handle", "spout"}) addThing(scene, newThing(name), {body});
    REQUIRE(scene.glue.size() == 2);
    const modeling::BuiltScene result = built(scene);
    for (const modeling::GlueReport& glue : result.glue) {
      INFO(glue.a);
      CHECK(glue.nodesMerged >= 4);
      CHECK(glue.worstScaledJacobian > 0.2);
    }
  }
}

TEST_CASE("A network has constants for each type of bond", "[new-things]") {
  Scene scene;
  const Item item = addNetwork(scene, "bar.data", 2);
  const auto& shape = std::get<modeling::NetworkShape>(scene.parts[item.index].shape);
  CHECK(shape.bondTypes.size() == 2);
  CHECK(shape.bondTypes[1].type == "2");
  CHECK(modeling::checkScene(scene).ok());
}
