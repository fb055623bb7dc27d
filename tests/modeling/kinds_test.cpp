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

/// Fills in what a part of each kind needs to be built. A kind that is missing does not compile.
struct Example {
  void operator()(modeling::SlabShape&) const {}
  void operator()(modeling::BezierPatchShape& shape) const {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        const auto u = static_cast<double>(i);
        const auto v = static_cast<double>(j);
        shape.net[i][j] = Vec3(u, v, 0.2 * u * v);
      }
    }
  }
  void operator()(modeling::RevolutionShape& shape) const {
    shape.outside = {modeling::straightSegment(Vec2(2, 0), Vec2(3, 4))};
    shape.inside = {modeling::straightSegment(Vec2(1.5, 0), Vec2(2.5, 4))};
  }
  void operator()(modeling::CurvedCylinderShape& shape) const {
    shape.curve = {{Vec3(0, 0, 0), Vec3(1, 0, 1), Vec3(2, 0, 2), Vec3(4, 0, 2)}};
  }
  void operator()(modeling::NetworkShape& shape) const {
    shape.file = "tests/data/lammps-bar/caseA.data";
    shape.bondTypes.resize(2);
    for (std::size_t type = 0; type < 2; ++type) {
      shape.bondTypes[type].type = std::to_string(type + 1);
      shape.bondTypes[type].constants.stiffness = 1000.0;
    }
  }
  void operator()(modeling::MeshShape& shape) const {
    shape.file = "resources/scenes/meshes/fluted-vase.obj";
    shape.unit = modeling::MeshUnit::centimetre;
    shape.up = modeling::MeshUp::z;
  }
};

/// One with the defaults of each kind.
template <class Variant, class Visit>
void forEachKind(const Visit& visit) {
  [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    (visit(Variant(std::in_place_index<kIndex>)), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>());
}

Scene sceneOf(const PartShape& shape) {
  Scene scene;
  scene.materials.resize(1);
  scene.materials[0].name = scene.materials[0].values.name = "clay";
  scene.parts.resize(1);
  scene.parts[0].name = "part";
  scene.parts[0].shape = shape;
  scene.parts[0].material = "clay";
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
  forEachKind<PartShape>([&](PartShape shape) {
    std::visit(Example(), shape);
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
  forEachKind<ColliderForm>([&](const ColliderForm& form) {
    INFO(modeling::kindName(form));
    CHECK(names.insert(modeling::kindName(form)).second);
    Scene scene = sceneOf(modeling::SlabShape{});
    scene.environment.colliders.resize(1);
    modeling::SceneCollider& collider = scene.environment.colliders[0];
    collider.name = "thing";
    collider.form = form;
    if (auto* obstacle = std::get_if<modeling::MeshObstacle>(&collider.form)) obstacle->file = "dish.obj";
    const ColliderForm before = collider.form;
    checkReadsBack(scene);
    const sim::Collider simulated = modeling::colliderOf(collider);
    CHECK(simulated.shape.index() == form.index());
    CHECK(sim::kindName(simulated) == modeling::kindName(form));
    modeling::scale(collider.form, Vec3::Constant(2.0));
    const double reach = sim::reachOf(modeling::colliderOf(collider));
    if (collider.form != before)
      CHECK(reach == Approx(2.0 * sim::reachOf(simulated)));
    else
      CHECK(reach == sim::reachOf(simulated));
  });
}
