#include "ui/panels/preflight_dialog.h"

#include <QLabel>
#include <QPushButton>

#include <catch2/catch.hpp>

#include "tests/ui/window_scenes.h"

namespace {

QLabel* overlapsOf(ui::PreflightDialog& dialog) {
  dialog.look();
  dialog.show();
  REQUIRE(tests::becomesTrue([&] { return dialog.isDone(); }));
  auto* label = dialog.findChild<QLabel*>(QStringLiteral("overlaps"));
  REQUIRE(label != nullptr);
  return label;
}

TEST_CASE(
    "The pre-flight dialog says what begins in an obstacle and how to mend it, and nothing where nothing "
    "does") {
  tests::SessionFixture fixture;
  modeling::Scene scene = tests::fallingSlab();
  fixture.load(scene);
  {
    ui::PreflightDialog dialog(fixture.session);
    CHECK(overlapsOf(dialog)->isHidden());
  }
  REQUIRE_FALSE(scene.environment.colliders.empty());
  // The floor comes up to a millimetre above the slab's lowest nodes.
  const modeling::BuiltScene& built = *fixture.session.preview()->built;
  double lowest = built.network.positions[0].z();
  for (const sim::Vec3& position : built.network.positions) lowest = std::min(lowest, position.z());
  scene.environment.colliders[0].position.z() = lowest + 0.1;
  fixture.load(scene);
  ui::PreflightDialog dialog(fixture.session);
  const QLabel* label = overlapsOf(dialog);
  CHECK_FALSE(label->isHidden());
  CHECK(label->text().contains(QStringLiteral("begins 0.1 cm inside the obstacle")));
  CHECK(label->text().contains(QStringLiteral("up by 0.1 cm")));
}

TEST_CASE(
    "A button of the pre-flight dialog moves out what begins inside something, and undo moves it back") {
  tests::SessionFixture fixture;
  modeling::Scene scene = tests::fallingSlab();
  REQUIRE_FALSE(scene.environment.colliders.empty());
  fixture.load(scene);
  const double before = fixture.session.document().scene().parts[0].worldFromPart.position.z();
  scene.environment.colliders[0].position.z() = before + 0.1;
  fixture.load(scene);
  ui::PreflightDialog dialog(fixture.session);
  CHECK_FALSE(overlapsOf(dialog)->isHidden());
  auto* button = dialog.findChild<QPushButton*>(QStringLiteral("moveOut"));
  REQUIRE(button != nullptr);
  REQUIRE_FALSE(button->isHidden());
  button->click();
  const auto heightNow = [&] {
    return fixture.session.document().scene().parts[0].worldFromPart.position.z();
  };
  CHECK(heightNow() > before);
  REQUIRE(tests::becomesTrue([&] { return dialog.isDone(); }));
  CHECK(dialog.findChild<QLabel*>(QStringLiteral("overlaps"))->isHidden());
  CHECK(button->isHidden());
  fixture.session.document().undoStack().undo();
  CHECK(heightNow() == before);
}

}  // namespace
