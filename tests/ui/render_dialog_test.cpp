#include "ui/editors/render_dialog.h"

#include <QComboBox>
#include <QPushButton>
#include <QTest>
#include <filesystem>

#include <catch2/catch.hpp>

#include "tests/ui/window_scenes.h"
#include "ui/panels/number_field.h"
#include "ui/viewport/viewport.h"

namespace {

struct Fixture : tests::SessionFixture {
  QWidget window;
  ui::Viewport viewport{session, &window};
  ui::RenderDialog* dialog = nullptr;

  Fixture() {
    load(tests::breakingSlab());
    dialog = new ui::RenderDialog(session, viewport, &window);
    dialog->setAttribute(Qt::WA_DeleteOnClose, false);
    set("render-width", 64);
    set("render-height", 40);
  }
  void set(const char* name, double value) {
    auto* field = dialog->findChild<ui::NumberField*>(QString::fromLatin1(name));
    REQUIRE(field != nullptr);
    field->setValue(value);
  }
  std::filesystem::path file(const char* name) const {
    return std::filesystem::path(folder.path().toStdString()) / name;
  }
};

TEST_CASE("The render dialog shows a preview, and writes a picture of the size that was asked for") {
  Fixture fixture;
  REQUIRE(tests::becomesTrue([&] { return fixture.dialog->view().image != nullptr; }));
  fixture.set("render-samples", 3);
  const auto path = fixture.file("slab.png");
  fixture.dialog->render(path);
  CHECK(fixture.dialog->isRendering());
  REQUIRE(tests::becomesTrue([&] { return !fixture.dialog->isRendering(); }));
  CHECK_FALSE(fixture.dialog->view().problem);
  CHECK(fixture.dialog->view().share == 1.0);
  const QImage written(QString::fromStdString(path.string()));
  CHECK(written.size() == QSize(64, 40));
}

TEST_CASE("What stands in place of the scene's ground and backdrop is seen in the preview") {
  Fixture fixture;
  const auto drawn = [&] { return fixture.dialog->view().ended && fixture.dialog->view().image; };
  // A choice takes a moment to settle, in which the preview before it is still there.
  const auto after = [&](const char* name, int choice) {
    const auto before = fixture.dialog->view().image;
    fixture.dialog->findChild<QComboBox*>(QString::fromLatin1(name))->setCurrentIndex(choice);
    REQUIRE(tests::becomesTrue([&] { return fixture.dialog->view().image != before && drawn(); }));
    return fixture.dialog->view().image->samples;
  };
  REQUIRE(tests::becomesTrue(drawn));
  const auto plain = fixture.dialog->view().image->samples;
  const auto checkered = after("render-ground", 1 + static_cast<int>(modeling::GroundKind::checker));
  CHECK(checkered != plain);
  const auto gradient = after("render-backdrop", 1 + static_cast<int>(modeling::BackdropKind::gradient));
  CHECK(gradient != checkered);
  CHECK(after("render-surface", 1 + static_cast<int>(modeling::PictureSurface::level)) != gradient);
  after("render-surface", 0);
  after("render-backdrop", 0);
  CHECK(after("render-ground", 0) == plain);
}

TEST_CASE("A backdrop of an image that nobody named is told of") {
  Fixture fixture;
  auto* backdrop = fixture.dialog->findChild<QComboBox*>(QStringLiteral("render-backdrop"));
  backdrop->setCurrentIndex(1 + static_cast<int>(modeling::BackdropKind::environment));
  CHECK(tests::becomesTrue([&] { return fixture.dialog->view().problem.has_value(); }));
}

TEST_CASE("A picture that is stopped leaves no file, and the dialog is ready for the next") {
  Fixture fixture;
  fixture.set("render-samples", 60000);
  const auto path = fixture.file("slab.png");
  fixture.dialog->render(path);
  REQUIRE(tests::becomesTrue([&] { return fixture.dialog->view().image != nullptr; }));
  QTest::mouseClick(fixture.dialog->findChild<QPushButton*>(QStringLiteral("render-start")), Qt::LeftButton);
  REQUIRE(tests::becomesTrue([&] { return !fixture.dialog->isRendering(); }));
  CHECK_FALSE(fixture.dialog->view().problem);
  CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("A picture that cannot be written is told of") {
  Fixture fixture;
  fixture.set("render-samples", 1);
  fixture.dialog->render(fixture.file("no such folder/slab.png"));
  REQUIRE(tests::becomesTrue([&] { return !fixture.dialog->isRendering(); }));
  CHECK(fixture.dialog->view().problem);
}

}  // namespace
