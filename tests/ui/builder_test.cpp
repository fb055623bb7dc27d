#include "ui/session/builder.h"

#include <QTemporaryDir>
#include <cmath>
#include <fstream>
#include <numbers>

#include <catch2/catch.hpp>

#include "tests/ui/window_scenes.h"

/// Building while a file is read that takes long.
namespace {

using tests::becomesTrue;
using tests::fallingSlab;

/// A disc of so many corners that taking it apart takes many seconds: valid, and slow.
void writeSlowMesh(const std::filesystem::path& file) {
  constexpr int kCorners = 150'000;
  std::ofstream text(file);
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    text << "v " << 5.0 * std::cos(angle) << ' ' << 5.0 * std::sin(angle) << " 0\n";
  }
  text << 'f';
  for (int i = 1; i <= kCorners; ++i) text << ' ' << i;
  text << '\n';
}

struct SlowScene {
  SlowScene() {
    writeSlowMesh(path() / "disc.obj");
    modeling::SceneCollider& obstacle = scene.environment.colliders.emplace_back();
    obstacle.name = "disc";
    obstacle.form = modeling::MeshObstacle{.file = "disc.obj", .surface = {}};
  }
  std::filesystem::path path() const { return folder.path().toStdString(); }

  QTemporaryDir folder;
  modeling::Scene scene = fallingSlab();
};

TEST_CASE("A file that takes long to read is told of, and can be given up") {
  const SlowScene slow;
  ui::Builder builder;
  builder.request(slow.scene, slow.path());
  REQUIRE(becomesTrue([&] { return builder.waitingFor().rfind("reading disc.obj, ", 0) == 0; }));
  builder.giveUp();
  REQUIRE(becomesTrue([&] { return !builder.isBusy(); }));
  CHECK(builder.waitingFor().empty());
  const auto preview = builder.newest();
  CHECK_FALSE(preview->built);
  REQUIRE(preview->problem);
  CHECK_THAT(preview->problem->what, Catch::Contains("disc.obj") && Catch::Contains("given up"));
}

TEST_CASE("A file that is being read is given up when the scene changes, and nothing of it is shown") {
  const SlowScene slow;
  ui::Builder builder;
  builder.request(slow.scene, slow.path());
  REQUIRE(becomesTrue([&] { return !builder.waitingFor().empty(); }));
  const auto before = builder.newest();
  builder.request(fallingSlab(), slow.path());
  bool hasShownOther = false;
  REQUIRE(becomesTrue([&] {
    const auto newest = builder.newest();
    hasShownOther = hasShownOther || (newest != before && !newest->built);
    return newest->built != nullptr;
  }));
  CHECK_FALSE(hasShownOther);
}

}  // namespace
