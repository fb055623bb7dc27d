#include "modeling/scene/field_info.h"

#include <set>

#include <catch2/catch.hpp>

#include "modeling/import/mesh_file.h"
#include "modeling/scene/scene_file.h"
#include "modeling/scene/scene_labels.h"
#include "modeling/scene/shape_fields.h"
#include "tests/modeling/scene_examples.h"

namespace {

using modeling::FieldInfo;

/// All fields below the struct, its groups' among them.
void collect(std::span<const FieldInfo> fields, std::vector<const FieldInfo*>& all) {
  for (const FieldInfo& info : fields) {
    all.push_back(&info);
    if (const auto* group = std::get_if<modeling::GroupAccess>(&info.access)) collect(group->fields(), all);
  }
}

std::vector<const FieldInfo*> fieldsOfAll() {
  std::vector<const FieldInfo*> all;
  const auto add = [&](std::span<const FieldInfo> fields) { collect(fields, all); };
  add(modeling::fieldsOf<modeling::Scene>());
  add(modeling::fieldsOf<modeling::Material>());
  add(modeling::fieldsOf<modeling::Part>());
  add(modeling::fieldsOf<modeling::SlabShape>());
  add(modeling::fieldsOf<modeling::BezierPatchShape>());
  add(modeling::fieldsOf<modeling::RevolutionShape>());
  add(modeling::fieldsOf<modeling::CurvedCylinderShape>());
  add(modeling::fieldsOf<modeling::NetworkShape>());
  add(modeling::fieldsOf<modeling::BondType>());
  add(modeling::fieldsOf<modeling::MeshShape>());
  add(modeling::fieldsOf<modeling::Gluing>());
  add(modeling::fieldsOf<modeling::SceneCollider>());
  add(modeling::fieldsOf<modeling::BoxShape>());
  add(modeling::fieldsOf<modeling::SphereShape>());
  add(modeling::fieldsOf<modeling::CylinderShape>());
  add(modeling::fieldsOf<modeling::MeshObstacle>());
  add(modeling::fieldsOf<modeling::SceneTrack>());
  return all;
}

TEST_CASE("Every field has a name for people and a sentence, and its step moves the number") {
  const std::vector<const FieldInfo*> all = fieldsOfAll();
  CHECK(all.size() > 100);
  for (const FieldInfo* info : all) {
    INFO(info->rule.key);
    CHECK_FALSE(info->display.label.empty());
    CHECK(info->rule.help.ends_with('.'));
    CHECK(info->display.step > 0.0);
    // A group that may be absent says what ticking its box does.
    const auto* group = std::get_if<modeling::GroupAccess>(&info->access);
    if (group != nullptr && group->setPresent != nullptr) CHECK_FALSE(info->display.present.empty());
    const bool mayBeAbsent =
        std::holds_alternative<modeling::ValueAccess<std::optional<double>>>(info->access) ||
        std::holds_alternative<modeling::ValueAccess<std::optional<modeling::Colour>>>(info->access);
    if (mayBeAbsent) CHECK_FALSE(info->display.absent.empty());
  }
}

TEST_CASE("What a field describes is the value in its struct") {
  modeling::SceneCollider collider;
  const auto fields = modeling::fieldsOf<modeling::SceneCollider>();
  const auto& friction =
      std::get<modeling::ValueAccess<double>>(modeling::findField(fields, "friction")->access);
  friction.of(&collider) = 0.75;
  CHECK(collider.friction == 0.75);
  CHECK(modeling::standardOf(*modeling::findField(fields, "friction"), friction) ==
        modeling::SceneCollider{}.friction);

  modeling::Material material;
  const FieldInfo* plastic = modeling::findField(modeling::fieldsOf<modeling::Material>(), "plastic");
  const auto& group = std::get<modeling::GroupAccess>(plastic->access);
  CHECK(group.of(&material) == nullptr);
  group.setPresent(&material, true);
  REQUIRE(material.plastic);
  CHECK(group.of(&material) == &*material.plastic);
  group.setPresent(&material, false);
  CHECK_FALSE(material.plastic);

  CHECK(modeling::findField(fields, "frictions") == nullptr);
}

TEST_CASE("A value that is not looked at says so") {
  modeling::CurvedCylinderShape sweep;
  const FieldInfo* wall =
      modeling::findField(modeling::fieldsOf<modeling::CurvedCylinderShape>(), "wallThickness");
  CHECK_FALSE(wall->counts(&sweep));
  sweep.section = modeling::SweepSection::ring;
  CHECK(wall->counts(&sweep));
}

TEST_CASE("Each choice has a name in files and a label of its own, and is found by its value") {
  std::size_t choices = 0;
  for (const FieldInfo* info : fieldsOfAll()) {
    const auto* access = std::get_if<modeling::ChoiceAccess>(&info->access);
    if (access == nullptr) continue;
    ++choices;
    std::set<std::string> names;
    std::set<std::string_view> labels;
    std::set<int> values;
    for (const modeling::ChoiceInfo& choice : access->choices()) {
      names.insert(choice.name);
      labels.insert(choice.label);
      values.insert(choice.value);
    }
    INFO(info->rule.key);
    CHECK(names.size() == access->choices().size());
    CHECK(labels.size() == access->choices().size());
    CHECK(values.size() == access->choices().size());
  }
  CHECK(choices > 10);
}

enum class Dish { cup, plate, bowl };

TEST_CASE("A list of labels that lacks a value is told from a whole one") {
  using Label = modeling::ChoiceLabel<Dish>;
  constexpr std::array<Label, 3> kWhole{{{Dish::bowl, "Bowl"}, {Dish::cup, "Cup"}, {Dish::plate, "Plate"}}};
  STATIC_REQUIRE(modeling::labelsEachValue(kWhole));
  constexpr std::array<Label, 2> kShort{{{Dish::bowl, "Bowl"}, {Dish::cup, "Cup"}}};
  STATIC_REQUIRE_FALSE(modeling::labelsEachValue(kShort));
  constexpr std::array<Label, 3> kTwice{{{Dish::bowl, "Bowl"}, {Dish::cup, "Cup"}, {Dish::cup, "Mug"}}};
  STATIC_REQUIRE_FALSE(modeling::labelsEachValue(kTwice));
  constexpr std::array<Label, 3> kEmpty{{{Dish::bowl, "Bowl"}, {Dish::cup, ""}, {Dish::plate, "Plate"}}};
  STATIC_REQUIRE_FALSE(modeling::labelsEachValue(kEmpty));
}

TEST_CASE("The files of meshes that can be chosen are those that can be read") {
  std::string patterns;
  for (const std::string& ending : modeling::meshFileEndings())
    patterns += (patterns.empty() ? "*" : " *") + ending;
  CHECK(modeling::kMeshFiles == patterns);
}

}  // namespace
