#include "ui/files/recovery.h"

#include <QTemporaryDir>
#include <QTest>
#include <fstream>

#include <catch2/catch.hpp>

#include "modeling/scene/scene_file.h"
#include "tests/ui/left_behind.h"
#include "tests/ui/whole_window.h"
#include "tests/ui/window_scenes.h"

/// What killed windows left behind.
namespace {

namespace fs = std::filesystem;
using tests::answer;
using tests::becomesTrue;
using tests::leaveBehind;

modeling::Scene named(const std::string& name) {
  modeling::Scene scene = tests::fallingSlab();
  scene.name = name;
  return scene;
}

/// A computer on which windows were killed and another is started.
struct Killed {
  QTemporaryDir place;
  fs::path data = place.path().toStdString();
  fs::path root = data / "sessions";
  fs::path file = data / "a.scene.json";

  /// A window that opens the file, or a new scene where it has no name, does something and is killed.
  template <class Deed>
  fs::path kill(const fs::path& opened, const modeling::Scene& scene, const std::string& as, Deed deed) {
    const fs::path folder = ui::Autosave::newFolder(root);
    ui::Session session(folder);
    ui::Autosave autosave(session, folder);
    const ui::KeptTakes kept(session, data / "takes");
    session.document().reset(scene, opened);
    deed(session);
    autosave.write();
    return leaveBehind(folder, root, as);
  }
};

void simulate(ui::Session& session) {
  session.simulate();
  REQUIRE(
      becomesTrue([&] { return session.run()->phase == ui::RunPhase::done && !session.takes().empty(); }));
}

void rename(ui::Session& session, const std::string& name) {
  session.document().edit("Rename", [&](modeling::Scene& scene) { scene.name = name; });
}

struct NextWindow {
  explicit NextWindow(const Killed& killed)
      : folder(ui::Autosave::newFolder(killed.root)),
        session(folder),
        autosave(session, folder),
        kept(session, killed.data / "takes"),
        window(session),
        recovery(session, kept, autosave, killed.root, &window) {
    window.show();
    REQUIRE(QTest::qWaitForWindowExposed(&window));
  }
  fs::path folder;
  ui::Session session;
  ui::Autosave autosave;
  ui::KeptTakes kept;
  ui::MainWindow window;
  ui::Recovery recovery;
};

TEST_CASE("A scene that was saved is not offered: its take is there when it is opened", "[recovery]") {
  Killed killed;
  REQUIRE(modeling::saveScene(named("a"), killed.file));
  killed.kill(killed.file, named("a"), "left", simulate);
  NextWindow next(killed);
  next.recovery.offer();  // would wait for an answer
  CHECK(next.session.document().scene().parts.empty());
  CHECK_FALSE(fs::exists(killed.root / "left"));
  next.window.files().open(killed.file);
  REQUIRE(becomesTrue([&] { return next.session.takes().size() == 1; }));
  CHECK_FALSE(next.window.isWindowModified());
}

TEST_CASE("What is recovered has its own takes once and those of no other scene, and opened files no star",
          "[recovery]") {
  Killed killed;
  REQUIRE(modeling::saveScene(named(""), killed.file));
  REQUIRE(modeling::saveScene(named("b"), killed.data / "b.scene.json"));
  killed.kill(killed.file, named(""), "left", [&](ui::Session& session) {
    simulate(session);
    // Another scene was open before in the same window.
    session.document().reset(named("b"), killed.data / "b.scene.json");
    simulate(session);
    session.document().reset(named(""), killed.file);
    simulate(session);
    session.document().edit("Longer", [](modeling::Scene& scene) { scene.output.fps += 1.0; });
  });
  NextWindow next(killed);
  QString asked;
  answer("Recover", &asked);
  next.recovery.offer();
  CHECK(asked.contains(u"“a”"));
  CHECK(next.session.document().file() == killed.file);
  CHECK(next.window.isWindowModified());
  const fs::path aKept = next.kept.folderOf(killed.file);
  const fs::path bKept = next.kept.folderOf(killed.data / "b.scene.json");
  QTest::qWait(300);
  CHECK(next.session.takes().size() == ui::KeptList(aKept).read().size());
  CHECK(ui::KeptList(bKept).read().size() == 1);
  for (const ui::IndexedTake& take : ui::KeptList(bKept).read()) CHECK_FALSE(fs::exists(aKept / take.file));
  CHECK_FALSE(fs::exists(killed.root / "left"));
  REQUIRE(next.window.files().save());
  next.window.files().open(killed.data / "b.scene.json");
  CHECK_FALSE(next.window.isWindowModified());
  REQUIRE(becomesTrue([&] { return next.session.takes().size() == 1; }));
}

TEST_CASE("What was saved by somebody else since is not saved over without asking", "[recovery]") {
  Killed killed;
  REQUIRE(modeling::saveScene(named("a"), killed.file));
  killed.kill(killed.file, named("a"), "left", [](ui::Session& session) { rename(session, "mine"); });
  REQUIRE(modeling::saveScene(named("theirs"), killed.file));
  NextWindow next(killed);
  answer("Recover");
  next.recovery.offer();
  CHECK(next.session.document().scene().name == "mine");
  answer("Cancel");
  CHECK_FALSE(next.window.files().save());
  CHECK(modeling::loadScene(killed.file)->scene.name == "theirs");
}

TEST_CASE("A file that was opened stays where something is recovered, and what is put off is offered again",
          "[recovery]") {
  Killed killed;
  REQUIRE(modeling::saveScene(named("opened"), killed.file));
  killed.kill({}, named("lost"), "left", [](ui::Session& session) { rename(session, "lost and found"); });
  NextWindow next(killed);
  next.window.files().open(killed.file);
  QString asked;
  answer("Later", &asked);
  next.recovery.offer();
  CHECK(asked.contains("lost and found"));
  CHECK(asked.contains("a window of its own"));
  CHECK(next.session.document().scene().name == "opened");
  CHECK(ui::leftoversIn(killed.root).size() == 1);
  // As that other window does.
  NextWindow beside(killed);
  beside.recovery.takeUp(killed.root / "left");
  CHECK(beside.session.document().scene().name == "lost and found");
  CHECK(beside.window.isWindowModified());
  CHECK(ui::leftoversIn(killed.root).empty());
}

TEST_CASE("While one window asks about what was left behind, another does not", "[recovery]") {
  Killed killed;
  killed.kill({}, named("lost"), "left", [](ui::Session& session) { rename(session, "found"); });
  const std::vector<ui::Leftover> held = ui::leftoversIn(killed.root);
  REQUIRE(held.size() == 1);
  CHECK(ui::leftoversIn(killed.root).empty());
}

TEST_CASE("What is recovered is kept again before it is removed", "[recovery]") {
  Killed killed;
  killed.kill({}, named("lost"), "left", [](ui::Session& session) {
    rename(session, "found");
    simulate(session);
  });
  NextWindow next(killed);
  answer("Recover");
  next.recovery.offer();
  CHECK_FALSE(fs::exists(killed.root / "left"));
  // Killed at once.
  leaveBehind(next.folder, killed.root, "again");
  const std::vector<ui::Leftover> again = ui::leftoversIn(killed.root);
  REQUIRE(again.size() == 1);
  CHECK(again[0].scene.name == "found");
  CHECK(again[0].takes.size() == 1);
}

TEST_CASE("What is damaged is said and kept, and asked about once", "[recovery]") {
  Killed killed;
  const fs::path left =
      killed.kill({}, named("lost"), "left", [](ui::Session& session) { rename(session, "found"); });
  const bool some = GENERATE(true, false);
  fs::resize_file(left / "autosave.scene.json",
                  some ? fs::file_size(left / "autosave.scene.json") * 9 / 10 : 3);
  NextWindow next(killed);
  QString asked, told;
  answer(some ? "Recover" : "OK", some ? &asked : &told);
  // The second question ends the offer, so that this is over before `told` is.
  if (some) QTimer::singleShot(600, [&] { answer("OK", &told); });
  next.recovery.offer();
  CHECK(told.contains("damaged"));
  CHECK(told.contains(QString::fromStdString((killed.data / "damaged").string())));
  CHECK(fs::exists(killed.data / "damaged" / "left" / "autosave.scene.json"));
  CHECK(ui::leftoversIn(killed.root).empty());
  CHECK(next.session.document().scene().parts.empty() == !some);
}

}  // namespace
