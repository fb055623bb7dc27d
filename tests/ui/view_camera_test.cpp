#include "ui/viewport/view_camera.h"

#include <numbers>

#include <catch2/catch.hpp>

#include "ui/viewport/navigator.h"
#include "ui/viewport/transform.h"

namespace {

const QSizeF kSize(640.0, 400.0);

ui::ViewCamera someCamera(bool orthographic) {
  ui::ViewCamera camera;
  camera.look({1.0, -2.0, 3.0}, 40.0, 0.7, -0.3);
  camera.setOrthographic(orthographic);
  return camera;
}

TEST_CASE("A line of sight leads through what is seen at its pixel") {
  for (const bool orthographic : {false, true}) {
    const ui::ViewCamera camera = someCamera(orthographic);
    for (const sim::Vec3& point : {sim::Vec3(0, 0, 0), sim::Vec3(4, -6, 5), sim::Vec3(-3, 2, 8)}) {
      const auto pixel = camera.project(point, kSize);
      REQUIRE(pixel);
      const ui::Ray ray = camera.rayThrough(*pixel, kSize);
      const sim::Vec3 offset = point - ray.origin;
      CHECK((offset - offset.dot(ray.direction) * ray.direction).norm() < 1e-9);
    }
  }
}

TEST_CASE("What the card draws is where the camera says") {
  for (const bool orthographic : {false, true}) {
    const ui::ViewCamera camera = someCamera(orthographic);
    const Eigen::AlignedBox3d all(sim::Vec3(-10, -10, -10), sim::Vec3(10, 10, 10));
    const QVector3D clip = (camera.clipFromView(kSize, all) * camera.viewFromWorld()).map(QVector3D(3, 4, 5));
    const auto pixel = camera.project({3, 4, 5}, kSize);
    REQUIRE(pixel);
    CHECK(0.5 * (1.0 + clip.x()) * kSize.width() == Approx(pixel->x()).margin(0.01));
    CHECK(0.5 * (1.0 - clip.y()) * kSize.height() == Approx(pixel->y()).margin(0.01));
    CHECK(std::abs(clip.z()) < 1.0F);
  }
}

TEST_CASE("A framed box is in the picture and fills most of it") {
  const Eigen::AlignedBox3d box(sim::Vec3(-3, 2, 10), sim::Vec3(9, 5, 12));
  ui::ViewCamera camera = someCamera(false);
  camera.frame(box, kSize);
  CHECK(camera.sees(box, kSize));
  camera.look(camera.target(), 0.5 * camera.distance(), camera.azimuth(), camera.elevation());
  CHECK_FALSE(camera.sees(box, kSize));
}

TEST_CASE("Zooming keeps what is under the pointer where it is") {
  ui::ViewCamera camera = someCamera(false);
  const QPointF pointer(500.0, 120.0);
  const ui::Ray ray = camera.rayThrough(pointer, kSize);
  const sim::Vec3 point = ray.origin + (camera.target() - ray.origin).dot(camera.forward()) /
                                           ray.direction.dot(camera.forward()) * ray.direction;
  camera.zoom(0.6, pointer, kSize);
  const auto after = camera.project(point, kSize);
  REQUIRE(after);
  CHECK((*after - pointer).manhattanLength() < 1e-6);
}

TEST_CASE("The presets take the buttons of the programs they are named after") {
  ui::ViewCamera camera;
  ui::Navigator navigator(camera);
  const auto takes = [&](Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    const bool taken = navigator.press({{}, button, modifiers});
    navigator.release();
    return taken;
  };
  CHECK(takes(Qt::MiddleButton, Qt::NoModifier));
  CHECK(takes(Qt::MiddleButton, Qt::ShiftModifier));
  CHECK_FALSE(takes(Qt::LeftButton, Qt::AltModifier));
  navigator.setPreset(ui::NavigationPreset::maya);
  CHECK(takes(Qt::LeftButton, Qt::AltModifier));
  CHECK(takes(Qt::RightButton, Qt::AltModifier));
  CHECK_FALSE(takes(Qt::LeftButton, Qt::NoModifier));
  CHECK_FALSE(takes(Qt::MiddleButton, Qt::NoModifier));
}

TEST_CASE("Degrees that were typed stay degrees when a thing is turned") {
  modeling::Rotation rotation;
  rotation.value = sim::Vec3(20.0, -35.0, 110.0);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.8, sim::Vec3(1, 2, -1).normalized()));
  const modeling::Rotation result = ui::turned(rotation, turn);
  REQUIRE(std::holds_alternative<sim::Vec3>(result.value));
  CHECK(result.quaternion().angularDistance(turn * rotation.quaternion()) < 1e-5);
  // Upright, where two of the angles turn about one axis.
  rotation.value = sim::Vec3(0.0, 90.0, 30.0);
  CHECK(ui::turned(rotation, Eigen::Quaterniond::Identity())
            .quaternion()
            .angularDistance(rotation.quaternion()) < 1e-5);
}

TEST_CASE("A transform moves what is selected, about its pivot, and nothing else") {
  modeling::Scene scene;
  scene.parts.resize(2);
  scene.parts[0].worldFromPart.position = sim::Vec3(2, 0, 0);
  scene.environment.colliders.resize(1);
  scene.environment.colliders[0].form = modeling::BoxShape{};
  const modeling::Scene before = scene;
  const ui::TransformStart start(scene, {{ui::ItemKind::part, 0}, {ui::ItemKind::collider, 0}});
  CHECK(start.middle() == sim::Vec3(1, 0, 0));

  ui::Transform turn;
  turn.mode = ui::TransformMode::rotate;
  turn.angle = std::numbers::pi / 2.0;
  turn.pivot = sim::Vec3(1, 0, 0);
  start.apply(turn, scene);
  CHECK((scene.parts[0].worldFromPart.position - sim::Vec3(1, 1, 0)).norm() < 1e-12);
  CHECK((scene.environment.colliders[0].position - sim::Vec3(1, -1, 0)).norm() < 1e-12);
  CHECK(std::get<sim::Vec3>(scene.parts[0].worldFromPart.rotation.value) == sim::Vec3(0, 0, 90));
  CHECK(scene.parts[1] == before.parts[1]);

  ui::Transform larger;
  larger.mode = ui::TransformMode::scale;
  larger.pivot = sim::Vec3(1, 0, 0);
  larger.factors = sim::Vec3(2, 1, 1);
  start.apply(larger, scene);
  CHECK(scene.parts[0].worldFromPart.position == sim::Vec3(3, 0, 0));
  CHECK(scene.parts[0].worldFromPart.scale.factors == sim::Vec3(2, 1, 1));
  CHECK(std::get<modeling::BoxShape>(scene.environment.colliders[0].form).halfSize == sim::Vec3(2, 1, 1));

  start.apply({}, scene);
  CHECK(scene == before);
}

}  // namespace
