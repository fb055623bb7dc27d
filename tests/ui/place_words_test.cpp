#include "ui/document/place_words.h"

#include <catch2/catch.hpp>

#include "tests/ui/window_scenes.h"

namespace {

TEST_CASE("Places of a scene are named as the window names them, others as they are") {
  modeling::Scene scene = tests::fallingSlab();
  const QString part = QString::fromStdString(scene.parts[0].name);
  const QString material = QString::fromStdString(scene.materials[0].name);
  scene.glue.push_back({});
  scene.glue[0].a = "handle";
  scene.glue[0].b = "cup";
  scene.tracks.push_back({{sim::TrackTarget::gravityScale, {}}, {}, {}});
  CHECK(ui::placeInWords(scene, "parts[0]") == QStringLiteral("Part “%1”").arg(part));
  CHECK(ui::placeInWords(scene, "parts[0].wallThickness") ==
        QStringLiteral("Part “%1”, wall thickness").arg(part));
  CHECK(ui::placeInWords(scene, "parts[0].outside[2].startAngle") ==
        QStringLiteral("Part “%1”, outside 3, start angle").arg(part));
  CHECK(ui::placeInWords(scene, "glue[0]") == QStringLiteral("Glue of handle to cup"));
  CHECK(ui::placeInWords(scene, "materials." + scene.materials[0].name + ".density") ==
        QStringLiteral("Material “%1”, density").arg(material));
  CHECK(ui::placeInWords(scene, "tracks[0].keys[1]") == QStringLiteral("Track “Gravity scale”, keys 2"));
  CHECK(ui::placeInWords(scene, "solver.step") == "Solver, step");
  for (const std::string other : {"parts[7]", "/home/me/cup.scene.json:3:4", "t = 0.01 s", ""})
    CHECK(ui::placeInWords(scene, other) == QString::fromStdString(other));
}

}  // namespace
