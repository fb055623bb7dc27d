#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "sim/surface/surface_mesh.h"
#include "tests/support/grid_network.h"
#include "ui/picture/picture.h"

namespace {

using sim::Vec3;
using ui::Image;
using ui::PictureRun;
using ui::PictureScene;
using ui::PictureSettings;

/// Odd, so that a pixel is in the middle.
PictureSettings smallPicture() {
  PictureSettings settings;
  settings.width = 97;
  settings.height = 73;
  settings.samples = 12;
  return settings;
}

/// A cube of 2 cm before the backdrop, photographed from -y.
PictureScene cubeScene() {
  const sim::Network network = tests::gridNetwork(2, 2, 2);
  PictureScene scene;
  scene.surface = sim::SurfaceBuilder(network).build(sim::momentAtRest(network));
  scene.looks = {modeling::Look{}};
  scene.subject = ui::Box(Vec3::Zero(), Vec3::Constant(2.0));
  scene.camera = {.position = Vec3(1.0, -12.0, 1.0), .target = Vec3(1.0, 0.0, 1.0)};
  return scene;
}

double brightness(const Image& image, int x, int y) {
  const std::size_t first = 3 * static_cast<std::size_t>(y * image.width + x);
  return (image.samples[first] + image.samples[first + 1] + image.samples[first + 2]) / (3.0 * 65535.0);
}

/// Over how many pixels the row through the middle passes from dark to bright, at the cube's left edge.
double edgeWidth(const Image& image) {
  const int y = image.height / 2;
  const double dark = brightness(image, 1, y);
  const double bright = brightness(image, image.width / 2, y);
  int width = 0;
  for (int x = 0; x < image.width / 2; ++x) {
    const double share = (brightness(image, x, y) - dark) / (bright - dark);
    if (share > 0.1 && share < 0.9) ++width;
  }
  return width;
}

TEST_CASE("a wide lens blurs what is not as far as it is focused, and nothing else") {
  PictureScene scene = cubeScene();
  const double sharp = edgeWidth(ui::renderPicture(scene, smallPicture()).value());
  scene.camera.aperture = 2.0;
  scene.camera.focus = 12.0;
  const double focused = edgeWidth(ui::renderPicture(scene, smallPicture()).value());
  scene.camera.focus = 30.0;
  const double blurred = edgeWidth(ui::renderPicture(scene, smallPicture()).value());
  CHECK(sharp <= 2);
  CHECK(focused <= 4);
  CHECK(blurred > focused + 4);
}

TEST_CASE("what moves while the shutter is open is blurred along its way") {
  PictureScene scene = cubeScene();
  const double still = edgeWidth(ui::renderPicture(scene, smallPicture()).value());
  scene.endPoints = scene.surface.points;
  for (Vec3& point : scene.endPoints) point.x() += 0.8;
  scene.endNormals = scene.surface.normals;
  const double moving = edgeWidth(ui::renderPicture(scene, smallPicture()).value());
  CHECK(moving > still + 4);
  // Half of the time it has passed a place 0.4 cm behind where it began.
  for (Vec3& point : scene.endPoints) point.x() -= 0.8;
  CHECK(edgeWidth(ui::renderPicture(scene, smallPicture()).value()) == still);
}

TEST_CASE("glass lets through what stands behind it") {
  PictureScene scene = cubeScene();
  sim::Collider ball;
  ball.shape = sim::SphereShape{0.6};
  ball.position = {1.0, 5.0, 1.0};
  const auto middle = [&](bool withBall) {
    scene.colliders.clear();
    if (withBall) scene.colliders.push_back(ball);
    const Image image = ui::renderPicture(scene, smallPicture()).value();
    return brightness(image, image.width / 2, image.height / 2);
  };
  CHECK(middle(true) == Approx(middle(false)).margin(1e-3));
  scene.looks[0].finish = modeling::Finish::glass;
  CHECK(std::abs(middle(true) - middle(false)) > 0.05);
}

TEST_CASE("a matte look has no highlight that moves with the eye") {
  PictureScene scene = cubeScene();
  scene.looks[0].glaze = 1.0;
  const Image glazed = ui::renderPicture(scene, smallPicture()).value();
  scene.looks[0].finish = modeling::Finish::matte;
  const Image matte = ui::renderPicture(scene, smallPicture()).value();
  scene.looks[0].finish = modeling::Finish::glazed;
  scene.looks[0].glaze = 0.0;
  CHECK(matte == ui::renderPicture(scene, smallPicture()).value());
  CHECK(matte.samples != glazed.samples);
}

TEST_CASE("a picture that is interrupted, kept and gone on with is the same to the last bit") {
  const PictureScene scene = cubeScene();
  const Image whole = ui::renderPicture(scene, smallPicture()).value();
  PictureSettings settings = smallPicture();
  int calls = 0;
  settings.progress = [&](double) { return ++calls < 20; };
  const auto first = PictureRun::create(scene, settings).value();
  CHECK(first->advanceTo(5) == false);
  const auto kept = first->kept("cube");
  settings.progress = nullptr;
  const auto second = PictureRun::create(scene, settings).value();
  REQUIRE(second->goOnFrom(kept, "cube"));
  CHECK(second->advanceTo(7));
  CHECK(second->samples() == 7);
  CHECK(second->advanceTo(12));
  CHECK(second->image() == whole);
}

TEST_CASE("what was kept of another picture, or is damaged, is refused") {
  const PictureScene scene = cubeScene();
  PictureSettings settings = smallPicture();
  settings.samples = 1;
  const auto run = PictureRun::create(scene, settings).value();
  REQUIRE(run->advanceTo(1));
  const auto kept = run->kept("cube");
  CHECK_FALSE(run->goOnFrom(kept, "ball"));
  for (std::size_t size = 0; size < kept.size(); size += 997)
    CHECK_FALSE(run->goOnFrom(std::span(kept).first(size), "cube"));
  settings.width = 96;
  CHECK_FALSE(PictureRun::create(scene, settings).value()->goOnFrom(kept, "cube"));
}

}  // namespace
