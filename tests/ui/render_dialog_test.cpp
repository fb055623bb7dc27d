#include "ui/editors/render_dialog.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QPushButton>
#include <QTest>
#include <chrono>
#include <filesystem>
#include <thread>

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

/// Reads an image of the environment as the program does, in a process of its own, but sleeps first.
sim::Result<ui::EnvironmentImage> readSlowly(const std::filesystem::path& path,
                                             const modeling::Attendance& attendance) {
  const auto sleep = [] {
    std::this_thread::sleep_for(std::chrono::seconds(50));
    return sim::ByteWriter();
  };
  const auto answer = modeling::readApart(path.filename().string(), sleep, {}, attendance);
  return answer ? sim::Problem{"", "it slept to the end", ""} : answer.problem();
}

TEST_CASE("A picture whose environment is read slowly says so, and is let go of at once") {
  tests::SessionFixture fixture;
  fixture.load(tests::breakingSlab());
  ui::PictureJob::Order order;
  order.frames.network = fixture.session.shown().network;
  order.frames.scene = tests::breakingSlab();
  order.frames.scene.view.picture.environment.image = "sky.hdr";
  order.frames.frame = [moment = fixture.session.shown().moment](std::size_t) {
    return sim::Result<sim::SnapshotPointer>(moment);
  };
  order.frames.readEnvironment = readSlowly;
  auto job = std::make_unique<ui::PictureJob>(order);
  REQUIRE(tests::becomesTrue([&] { return !job->view().doing.empty(); }));
  CHECK(job->view().doing.starts_with("reading sky.hdr"));
  CHECK_FALSE(job->view().ended);
  QElapsedTimer clock;
  clock.start();
  job->stop();
  CHECK(tests::becomesTrue([&] { return job->view().ended; }));
  CHECK_FALSE(job->view().problem);
  job.reset();
  CHECK(clock.elapsed() < 5000);  // ms; the reader wants ten times that
  // Without being asked to stop first, too.
  job = std::make_unique<ui::PictureJob>(order);
  REQUIRE(tests::becomesTrue([&] { return !job->view().doing.empty(); }));
  clock.restart();
  job.reset();
  CHECK(clock.elapsed() < 2000);
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
