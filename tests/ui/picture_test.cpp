#include "ui/picture/picture.h"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "tests/support/grid_network.h"

namespace {

using sim::Collider;
using sim::Vec3;
using ui::Image;
using ui::PictureScene;
using ui::PictureSettings;

PictureSettings smallPicture(int threads = 0) {
  PictureSettings settings;
  settings.width = 96;
  settings.height = 72;
  settings.samples = 8;
  settings.threads = threads;
  return settings;
}

/// A ball of radius 3 that stands on the floor or floats above it, photographed from -y.
PictureScene ballScene(double height) {
  PictureScene scene;
  Collider floor;
  Collider ball;
  ball.shape = sim::SphereShape{3.0};
  ball.position = {0.0, 0.0, height};
  scene.colliders = {floor, ball};
  scene.subject = ui::Box(Vec3(-3, -3, 0), Vec3(3, 3, 6));
  scene.camera = ui::frameBox(scene.subject, 96.0 / 72.0, {.azimuth = -std::numbers::pi / 2.0});
  return scene;
}

double brightness(const Image& image, int x, int y) {
  const std::size_t first = 3 * static_cast<std::size_t>(y * image.width + x);
  return (image.samples[first] + image.samples[first + 1] + image.samples[first + 2]) / (3.0 * 65535.0);
}

/// Mean over a square of 7 pixels around a point of the world.
double brightnessAround(const Image& image, const PictureScene& scene, const Vec3& point) {
  const Vec3 ahead = (scene.camera.target - scene.camera.position).normalized();
  const Vec3 right = ahead.cross(Vec3::UnitZ()).normalized();
  const Vec3 offset = point - scene.camera.position;
  const double scale =
      image.height / 2.0 / std::tan(scene.camera.verticalFieldOfView / 2.0) / offset.dot(ahead);
  const int x = static_cast<int>(image.width / 2.0 + scale * offset.dot(right));
  const int y = static_cast<int>(image.height / 2.0 - scale * offset.dot(right.cross(ahead)));
  double sum = 0.0;
  for (int down = -3; down <= 3; ++down) {
    for (int across = -3; across <= 3; ++across) sum += brightness(image, x + across, y + down);
  }
  return sum / 49.0;
}

/// A block of cells, its middle layer broken, above the floor.
PictureScene brokenBlockScene() {
  const sim::Network network = tests::gridNetwork(5, 3, 3);
  sim::Snapshot moment = sim::momentAtRest(network);
  tests::breakBetween(network, 2.5, moment);
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node)
    moment.positions[node].x() += network.positions[node].x() < 2.5 ? -0.5 : 0.5;
  PictureScene scene;
  scene.surface = sim::SurfaceBuilder(network).build(moment);
  scene.colliders = {Collider{}};
  scene.subject = ui::Box(Vec3(0, 0, 0), Vec3(5, 3, 3));
  scene.camera = ui::frameBox(scene.subject, 96.0 / 72.0);
  return scene;
}

TEST_CASE("a picture is the same for any number of threads, and differs by seed") {
  const PictureScene scene = brokenBlockScene();
  const Image one = ui::renderPicture(scene, smallPicture(1)).value();
  CHECK(one == ui::renderPicture(scene, smallPicture(2)).value());
  CHECK(one == ui::renderPicture(scene, smallPicture(3)).value());
  PictureSettings otherSeed = smallPicture(2);
  otherSeed.seed = 2;
  CHECK(one.samples != ui::renderPicture(scene, otherSeed)->samples);
}

TEST_CASE("a ball is brighter towards the key light, at the left above") {
  const PictureScene scene = ballScene(3.0);
  const Image image = ui::renderPicture(scene, smallPicture()).value();
  const double lit = brightnessAround(image, scene, {-1.5, -1.8, 4.8});
  const double averted = brightnessAround(image, scene, {1.5, -1.8, 1.2});
  CHECK(lit > 1.25 * averted);
}

TEST_CASE("a ball casts its shadow to the right, and a contact shadow where it stands") {
  const PictureScene withBall = ballScene(3.0);
  PictureScene without = withBall;
  without.colliders.pop_back();
  const Image shadowed = ui::renderPicture(withBall, smallPicture()).value();
  const Image plain = ui::renderPicture(without, smallPicture()).value();
  const auto ratio = [&](const Vec3& point) {
    return brightnessAround(shadowed, withBall, point) / brightnessAround(plain, without, point);
  };
  CHECK(ratio({3.9, 0.6, 0.0}) < 0.85);
  CHECK(ratio({-6.0, -1.0, 0.0}) > 0.97);
  const Image floating = ui::renderPicture(ballScene(9.0), smallPicture()).value();
  const Vec3 underneath(0.0, -0.9, 0.0);
  CHECK(brightnessAround(shadowed, withBall, underneath) < brightnessAround(floating, withBall, underneath));
}

TEST_CASE("an invisible collider is not drawn") {
  PictureScene hidden = ballScene(3.0);
  hidden.colliders[1].visible = false;
  PictureScene without = hidden;
  without.colliders.pop_back();
  CHECK(ui::renderPicture(hidden, smallPicture()).value() ==
        ui::renderPicture(without, smallPicture()).value());
}

TEST_CASE("outsides and broken faces have their material's two colours") {
  PictureScene scene = brokenBlockScene();
  scene.looks = {modeling::Look{.outside = {0.0, 0.8, 0.0}, .inside = {0.8, 0.0, 0.0}, .glaze = 0.0}};
  const Image image = ui::renderPicture(scene, smallPicture()).value();
  std::size_t green = 0, red = 0;
  for (std::size_t i = 0; i < image.samples.size(); i += 3) {
    green += image.samples[i + 1] > 2U * image.samples[i] ? 1 : 0;
    red += image.samples[i] > 2U * image.samples[i + 1] ? 1 : 0;
  }
  CHECK(green > 500);
  CHECK(red > 50);
}

TEST_CASE("the camera sees the whole subject, from any side and in any format") {
  const ui::Box box(Vec3(-4, 1, 0), Vec3(7, 3, 12));
  for (const double aspect : {0.5, 1.0, 2.4}) {
    for (double azimuth = 0.0; azimuth < 6.2; azimuth += 0.7) {
      const ui::Camera camera = ui::frameBox(box, aspect, {.azimuth = azimuth});
      const Vec3 ahead = (camera.target - camera.position).normalized();
      const Vec3 right = ahead.cross(Vec3::UnitZ()).normalized();
      const double upTangent = std::tan(camera.verticalFieldOfView / 2.0);
      double fill = 0.0;
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 offset = box.corner(static_cast<ui::Box::CornerType>(corner)) - camera.position;
        const double depth = offset.dot(ahead);
        fill = std::max(fill, std::abs(offset.dot(right)) / depth / (upTangent * aspect));
        fill = std::max(fill, std::abs(offset.dot(right.cross(ahead))) / depth / upTangent);
      }
      CHECK(fill < 0.95);
      CHECK(fill > 0.7);
    }
  }
}

TEST_CASE("progress rises to one, and answering false cancels") {
  PictureSettings settings = smallPicture(2);
  double last = 0.0;
  settings.progress = [&](double share) {
    CHECK(share > last);
    last = share;
    return true;
  };
  REQUIRE(ui::renderPicture(brokenBlockScene(), settings).ok());
  CHECK(last == 1.0);
  int calls = 0;
  settings.progress = [&](double) { return ++calls < 3; };
  CHECK_FALSE(ui::renderPicture(brokenBlockScene(), settings).ok());
  CHECK(calls == 3);
}

TEST_CASE("a picture of impossible size is refused in words") {
  PictureSettings settings = smallPicture();
  settings.width = 0;
  CHECK_FALSE(ui::renderPicture(brokenBlockScene(), settings).ok());
  settings.width = 96;
  settings.samples = 0;
  CHECK_FALSE(ui::renderPicture(brokenBlockScene(), settings).ok());
}

TEST_CASE("nothing to draw is a picture, too") {
  PictureScene scene;
  scene.subject = ui::Box(Vec3::Zero(), Vec3::Ones());
  scene.camera = ui::frameBox(scene.subject, 1.0);
  CHECK(ui::renderPicture(scene, smallPicture()).ok());
}

}  // namespace
