#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <fstream>
#include <iterator>

#include <catch2/catch.hpp>

#include "modeling/scene/scene_file.h"
#include "tests/ui/left_behind.h"
#include "tests/ui/whole_window.h"
#include "tests/ui/window_scenes.h"
#include "ui/panels/number_field.h"
#include "ui/panels/outliner.h"
#include "ui/panels/outliner_tree.h"
#include "ui/panels/plain_fields.h"

/// Two that save one scene.
namespace {

namespace fs = std::filesystem;
using tests::answer;
using tests::becomesTrue;

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

modeling::Scene named(const std::string& name) {
  modeling::Scene scene = tests::fallingSlab();
  scene.name = name;
  return scene;
}

/// A window with a scene that was edited, and a file that somebody else changed meanwhile.
struct Contest : tests::WholeWindow {
  fs::path file = root / "slab.scene.json";
  std::string said;

  Contest() {
    REQUIRE(modeling::saveScene(named("first"), file));
    QObject::connect(&session, &ui::Session::problemFound, &window,
                     [this](const sim::Problem& problem) { said = problem.line(); });
    window.files().open(file);
    session.document().edit("Rename", [](modeling::Scene& scene) { scene.name = "mine"; });
  }
  void othersSave() { REQUIRE(modeling::saveScene(named("theirs"), file)); }
};

TEST_CASE("A file that somebody else changed is not saved over without asking, and both are kept",
          "[saving]") {
  Contest contest;
  contest.othersSave();
  const std::string theirs = textOf(contest.file);
  QString asked;
  answer("Cancel", &asked);
  CHECK_FALSE(contest.window.files().save());
  CHECK(asked.contains("changed by somebody else"));
  CHECK(asked.contains("name"));
  CHECK(textOf(contest.file) == theirs);
  answer("Save Anyway");
  CHECK(contest.window.files().save());
  CHECK(modeling::loadScene(contest.file)->scene.name == "mine");
  CHECK(textOf(contest.root / "slab.other-1.scene.json") == theirs);
  // Now it is ours.
  contest.session.document().edit("Rename", [](modeling::Scene& scene) { scene.name = "again"; });
  CHECK(contest.window.files().save());
}

TEST_CASE("What somebody else saved can be taken over, and what was edited comes back by undo", "[saving]") {
  Contest contest;
  contest.othersSave();
  answer("Reload");
  CHECK_FALSE(contest.window.files().save());
  CHECK(contest.scene().name == "theirs");
  CHECK_FALSE(contest.session.document().isModified());
  contest.session.document().undoStack().undo();
  CHECK(contest.scene().name == "mine");
  CHECK(contest.session.document().isModified());
  CHECK(contest.window.files().save());
}

TEST_CASE("A change of the same size and time is a change; a file written anew with the same text is none",
          "[saving]") {
  Contest contest;
  const auto time = fs::last_write_time(contest.file);
  std::string text = textOf(contest.file);
  text.replace(text.find("first"), 5, "other");
  std::ofstream(contest.file) << text;
  fs::last_write_time(contest.file, time);
  answer("Cancel");
  CHECK_FALSE(contest.window.files().save());
  text.replace(text.find("other"), 5, "first");
  std::ofstream(contest.file) << text;
  CHECK(contest.window.files().save());
}

TEST_CASE("A file that was deleted or renamed is told of, and is there again when one says so", "[saving]") {
  Contest contest;
  fs::rename(contest.file, contest.root / "elsewhere.scene.json");
  CHECK(becomesTrue([&] { return contest.said.find("deleted or renamed") != std::string::npos; }));
  answer("Cancel");
  CHECK_FALSE(contest.window.files().save());
  CHECK_FALSE(fs::exists(contest.file));
  answer("Save Anyway");
  CHECK(contest.window.files().save());
  CHECK(fs::exists(contest.file));
}

TEST_CASE("While a scene is open, a change of its file is told of once, and nothing else happens",
          "[saving]") {
  Contest contest;
  contest.othersSave();
  CHECK(becomesTrue([&] { return contest.said.find("changed by somebody else") != std::string::npos; }));
  CHECK(contest.scene().name == "mine");
  contest.said.clear();
  QTest::qWait(800);
  CHECK(contest.said.empty());
  contest.session.document().edit("Rename", [](modeling::Scene& scene) { scene.name = "more"; });
  // Our own saving is no change.
  answer("Save Anyway");
  CHECK(contest.window.files().save());
  QTest::qWait(800);
  CHECK(contest.said.empty());
}

TEST_CASE("A scene is saved through a link, with the permissions that its file has", "[saving]") {
  Contest contest;
  fs::permissions(contest.file, fs::perms::owner_read | fs::perms::owner_write);
  const fs::path link = contest.root / "link.scene.json";
  fs::create_symlink(contest.file, link);
  REQUIRE(contest.session.document().saveTo(link));
  CHECK(fs::is_symlink(link));
  CHECK(modeling::loadScene(contest.file)->scene.name == "mine");
  CHECK(fs::status(contest.file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("A scene that comes with the program stays as it is, unless its file is chosen to be saved over",
          "[saving]") {
  tests::WholeWindow whole;
  const fs::path scenes = whole.root / "resources" / "scenes";
  fs::create_directories(scenes);
  const fs::path file = scenes / "slab.scene.json";
  REQUIRE(modeling::saveScene(named("shipped"), file));
  const std::string before = textOf(file);
  qputenv("SMITHEREENS_RESOURCES", QByteArray::fromStdString((whole.root / "resources").string()));
  whole.window.files().open(file);
  whole.session.document().edit("Rename", [](modeling::Scene& scene) { scene.name = "mine"; });
  fs::path asked;
  const fs::path elsewhere = whole.root / "mine.scene.json";
  QTimer::singleShot(100, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    REQUIRE(dialog != nullptr);
    asked = dialog->directory().absolutePath().toStdString();
    dialog->selectFile(QString::fromStdString(elsewhere.string()));
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(QString::fromStdString(elsewhere.string()));
    QMetaObject::invokeMethod(dialog, "accept");
  });
  CHECK(whole.window.files().save());
  qunsetenv("SMITHEREENS_RESOURCES");
  CHECK(asked != scenes);
  CHECK(textOf(file) == before);
  CHECK(modeling::loadScene(elsewhere)->scene.name == "mine");
  CHECK(whole.session.document().file() == elsewhere);
}

TEST_CASE("What is typed and not confirmed is rehearsed, and stays typed", "[saving]") {
  tests::WholeWindow whole;
  whole.session.document().reset(tests::fallingSlab(), {});
  whole.window.showViewport();
  whole.session.selection().select({ui::ItemKind::part, 0});
  whole.raise("properties");
  ui::Autosave autosave(whole.session, whole.folder);
  const fs::path aside = whole.folder / "autosave.scene.json";
  SECTION("a number") {
    auto* field = whole.window.findChild<ui::NumberField*>("worldFromPart.position.z");
    const auto fields = whole.window.findChildren<ui::NumberField*>();
    for (ui::NumberField* each : fields) {
      if (!field && each->isVisible() && each->format().dimension == ui::Dimension::length) field = each;
    }
    REQUIRE(field != nullptr);
    field->beginEditing();
    auto* editor = field->findChild<QLineEdit*>("number-editor");
    REQUIRE(editor != nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, "7.25");
    autosave.write();
    CHECK(editor->text() == "7.25");
    CHECK(field->isEditing());
    CHECK_FALSE(whole.session.document().isModified());
    CHECK(textOf(aside).find("7.25") != std::string::npos);
    QTest::keyClick(editor, Qt::Key_Escape);
    CHECK_FALSE(whole.session.document().isModified());
  }
  SECTION("a name") {
    ui::TextField* field = nullptr;
    for (auto* each : whole.window.findChildren<ui::TextField*>()) {
      if (each->isVisible() && each->text() == "slab") field = each;
    }
    REQUIRE(field != nullptr);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "saucer");
    autosave.write();
    CHECK(field->text() == "saucer");
    CHECK_FALSE(whole.session.document().isModified());
    CHECK(textOf(aside).find("saucer") != std::string::npos);
    QTest::keyClick(field, Qt::Key_Return);
    CHECK(whole.scene().parts[0].name == "saucer");
  }
  SECTION("a name in the outliner") {
    auto* outliner = whole.window.findChild<ui::Outliner*>();
    REQUIRE(outliner != nullptr);
    outliner->renameSelected();
    auto* editor = outliner->tree().viewport()->findChild<QLineEdit*>();
    REQUIRE(editor != nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, "saucer");
    autosave.write();
    CHECK(editor->text() == "saucer");
    CHECK(textOf(aside).find("saucer") != std::string::npos);
  }
}

TEST_CASE("Edits that go on and on are written aside all the same", "[saving]") {
  const QTemporaryDir place;
  const fs::path folder = ui::Autosave::newFolder(place.path().toStdString());
  ui::Session session(folder);
  const ui::Autosave autosave(session, folder);
  session.document().reset(tests::fallingSlab(), {});
  // Longer than it waits, with less than that between two edits.
  for (int edit = 0; edit < 8; ++edit) {
    session.document().edit("Rename",
                            [&](modeling::Scene& scene) { scene.name = "edit " + std::to_string(edit); });
    QTest::qWait(1000);
  }
  CHECK(textOf(folder / "autosave.scene.json").find("\"edit ") != std::string::npos);
}

}  // namespace
