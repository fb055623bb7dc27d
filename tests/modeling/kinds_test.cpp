#include <set>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/resources.h"
#include "modeling/scene/scene_file.h"

namespace {

using modeling::ColliderForm;
using modeling::PartShape;
using modeling::Scene;
using modeling::Vec2;
using sim::Vec3;

/// A part of each kind, which can be built. A kind without one does not compile.
struct Example {
  static PartShape of(const modeling::SlabShape& shape) { return shape; }
  static PartShape of(modeling::BezierPatchShape shape) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j)
        shape.net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = Vec3(i, j, 0.2 * i * j);
    }
    return shape;
  }
  static PartShape of(modeling::RevolutionShape shape) {
    shape.outside = {modeling::straightSegment(Vec2(2, 0), Vec2(3, 4))};
    shape.inside = {modeling::straightSegment(Vec2(1.5, 0), Vec2(2.5, 4))};
    return shape;
  }
  static PartShape of(modeling::CurvedCylinderShape shape) {
    shape.curve = {{Vec3(0, 0, 0), Vec3(1, 0, 1), Vec3(2, 0, 2), Vec3(4, 0, 2)}};
    return shape;
  }
  static PartShape of(modeling::NetworkShape shape) {
    shape.file = "tests/data/lammps-bar/caseA.data";
    for (const char* type : {"1", "2"})
      shape.bondTypes.push_back({type, {.stiffness = 1000.0, .restLength = 1.0}});
    return shape;
  }
  static PartShape of(modeling::MeshShape shape) {
    shape.file = "resources/scenes/meshes/dish.obj";
    shape.unit = modeling::MeshUnit::centimetre;
    shape.up = modeling::MeshUp::z;
    return shape;
  }
};

template <class Variant, class Visit>
void forEachKind(const Visit& visit) {
  [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    (visit(std::variant_alternative_t<kIndex, Variant>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>());
}

Scene sceneOf(const PartShape& shape) {
  Scene scene;
  scene.materials.push_back({.name = "clay", .preset = "", .values = {.name = "clay"}});
  scene.parts.push_back(
      {.name = "part", .shape = shape, .material = "clay", .worldFromPart = {}, .hold = {}});
  return scene;
}

void checkReadsBack(const Scene& scene) {
  const auto again = modeling::parseScene(modeling::writeScene(scene), "again");
  if (!again) FAIL(again.problem().line());
  CHECK(again->scene == scene);
}

}  // namespace

TEST_CASE("a part of each kind is written, read and built, within its box") {
  std::set<std::string_view> names;
  forEachKind<PartShape>([&](const auto& kind) {
    const PartShape shape = Example::of(kind);
    INFO(modeling::kindName(shape));
    CHECK(names.insert(modeling::kindName(shape)).second);
    const Scene scene = sceneOf(shape);
    checkReadsBack(scene);
    const auto built = modeling::build(scene, SMITHEREENS_SOURCE_DIR);
    if (!built) FAIL(built.problem().line());
    CHECK(built->network.nodeCount() > 0);
    CHECK(modeling::cellEdgeOf(shape).has_value() == (built->network.cellCount() > 0));
    Eigen::AlignedBox3d box = modeling::boxOf(scene.parts[0]);
    if (box.isEmpty()) return;
    box.min().array() -= 1e-9;
    box.max().array() += 1e-9;
    for (const Vec3& node : built->network.positions) REQUIRE(box.contains(node));
  });
}

TEST_CASE("a collider of each kind is written, read, simulated as that kind, and scaled") {
  std::set<std::string_view> names;
  forEachKind<ColliderForm>([&](const auto& kind) {
    const ColliderForm form = kind;
    INFO(modeling::kindName(form));
    CHECK(names.insert(modeling::kindName(form)).second);
    Scene scene = sceneOf(modeling::SlabShape{});
    scene.environment.colliders.push_back(
        {.name = "thing", .form = form, .rotation = {}, .stiffness = {}, .active = {}});
    modeling::SceneCollider& collider = scene.environment.colliders[0];
    if (auto* obstacle = std::get_if<modeling::MeshObstacle>(&collider.form)) obstacle->file = "dish.obj";
    checkReadsBack(scene);
    const sim::Collider simulated = modeling::colliderOf(collider);
    CHECK(simulated.shape.index() == form.index());
    CHECK(sim::kindName(simulated) == modeling::kindName(form));
    modeling::scale(collider.form, Vec3::Constant(2.0));
    const double reach = sim::reachOf(modeling::colliderOf(collider));
    if (collider.form != form)
      CHECK(reach == Approx(2.0 * sim::reachOf(simulated)));
    else
      CHECK(reach == sim::reachOf(simulated));
  });
}
