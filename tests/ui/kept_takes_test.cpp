#include "ui/files/kept_takes.h"

#include <QTemporaryDir>
#include <fstream>

#include <catch2/catch.hpp>

#include "modeling/scene/scene_file.h"
#include "tests/ui/window_scenes.h"

namespace {

namespace fs = std::filesystem;
using tests::becomesTrue;

/// A program that keeps takes, as often as it is started.
struct Started {
  explicit Started(const fs::path& root) : keeper(fixture.session, root / "takes") {}

  void open(const fs::path& file) {
    const auto scene = modeling::loadScene(file);
    REQUIRE(scene);
    fixture.session.document().reset(scene->scene, file);
    REQUIRE(becomesTrue([&] { return fixture.session.shown().moment != nullptr; }));
  }
  ui::Session& session() { return fixture.session; }

  tests::SessionFixture fixture;
  ui::KeptTakes keeper;
};

struct Desk {
  QTemporaryDir folder;
  fs::path root = folder.path().toStdString();
  fs::path file = root / "slab.scene.json";

  Desk() { REQUIRE(modeling::saveScene(tests::fallingSlab(), file).ok()); }
};

TEST_CASE("Takes of a scene with a file are there again when it is opened by another program") {
  const Desk desk;
  std::uint64_t hash = 0;
  {
    Started first(desk.root);
    first.open(desk.file);
    first.fixture.simulateToEnd();
    hash = first.session().run()->stateHash;
    first.session().takes().rename(0, "The good one");
    first.session().takes().setNote(0, "lands flat");
    QImage picture(8, 5, QImage::Format_RGB32);
    picture.fill(Qt::red);
    first.session().takes().setThumbnail(0, picture);
  }
  Started second(desk.root);
  second.open(desk.file);
  REQUIRE(becomesTrue([&] { return second.session().takes().size() == 1; }));
  const ui::Take& take = second.session().takes()[0];
  CHECK(take.name == "The good one");
  CHECK(take.note == "lands flat");
  CHECK(take.thumbnail.size() == QSize(8, 5));
  CHECK_FALSE(take.stale);
  CHECK(take.footage->frameCount() == 11);
  // It is up to date, so it is what the space bar plays.
  REQUIRE(becomesTrue([&] { return second.session().takes().current() == std::size_t{0}; }));
  const auto last = take.footage->frame(10);
  REQUIRE(last);
  CHECK((*last)->stepCount > 0);
  CHECK(hash != 0);

  // Another scene has none of them.
  const fs::path other = desk.root / "other.scene.json";
  REQUIRE(modeling::saveScene(tests::fallingSlab(), other).ok());
  second.open(other);
  CHECK(second.session().takes().empty());
  second.open(desk.file);
  CHECK(becomesTrue([&] { return second.session().takes().size() == 1; }));
}

TEST_CASE("Takes made before the scene had a file are kept once it has one") {
  const Desk desk;
  const fs::path file = desk.root / "late.scene.json";
  {
    Started first(desk.root);
    first.session().document().reset(tests::fallingSlab(), {});
    first.fixture.simulateToEnd();
    CHECK(first.session().takes().hasOwn());
    CHECK_FALSE(fs::exists(desk.root / "takes"));
    REQUIRE(first.session().document().saveTo(file).ok());
  }
  Started second(desk.root);
  second.open(file);
  CHECK(becomesTrue([&] { return second.session().takes().size() == 1; }));
}

TEST_CASE("A take that is deleted stays deleted, and the others stay") {
  const Desk desk;
  fs::path kept;
  {
    Started first(desk.root);
    first.open(desk.file);
    first.fixture.simulateToEnd();
    first.session().simulate();
    REQUIRE(becomesTrue([&] {
      return first.session().takes().size() == 2 && first.session().run()->phase == ui::RunPhase::done;
    }));
    kept = first.keeper.folderOf(desk.file) / first.session().takes()[0].footage->file().filename();
    CHECK(fs::exists(kept));
    first.session().takes().remove(0);
    CHECK_FALSE(fs::exists(kept));
  }
  {
    Started second(desk.root);
    second.open(desk.file);
    REQUIRE(becomesTrue([&] { return second.session().takes().size() == 1; }));
    CHECK(second.session().takes()[0].name == "Take 2");
    second.session().takes().remove(0);
  }
  Started third(desk.root);
  third.open(desk.file);
  CHECK(third.session().takes().empty());
  CHECK_FALSE(fs::exists(kept));
}

TEST_CASE("Two windows on one scene: the takes of both are listed, and what one says of its own counts") {
  const Desk desk;
  Started first(desk.root), second(desk.root);
  first.open(desk.file);
  second.open(desk.file);
  first.fixture.simulateToEnd();
  second.fixture.simulateToEnd();
  first.session().takes().rename(0, "of the first");
  second.session().takes().rename(0, "of the second");
  first.session().takes().setNote(0, "still the first");
  Started third(desk.root);
  third.open(desk.file);
  REQUIRE(becomesTrue([&] { return third.session().takes().size() == 2; }));
  CHECK(third.session().takes()[0].name == "of the first");
  CHECK(third.session().takes()[0].note == "still the first");
  CHECK(third.session().takes()[1].name == "of the second");
  // One deletes its own: it is gone, and the other's stays.
  first.session().takes().remove(0);
  second.session().takes().setNote(0, "alone");
  Started fourth(desk.root);
  fourth.open(desk.file);
  REQUIRE(becomesTrue([&] { return fourth.session().takes().size() == 1; }));
  CHECK(fourth.session().takes()[0].name == "of the second");
}

TEST_CASE("A take that no list has is listed under the name of its file") {
  const Desk desk;
  fs::path folder;
  {
    Started first(desk.root);
    first.open(desk.file);
    first.fixture.simulateToEnd();
    folder = first.keeper.folderOf(desk.file);
  }
  const bool damaged = GENERATE(true, false);
  if (damaged) {
    std::ofstream(folder / "takes.json") << "[{";
  } else {
    fs::remove(folder / "takes.json");
  }
  Started second(desk.root);
  second.open(desk.file);
  REQUIRE(becomesTrue([&] { return second.session().takes().size() == 1; }));
  second.session().takes().rename(0, "found");
  Started third(desk.root);
  third.open(desk.file);
  REQUIRE(becomesTrue([&] { return third.session().takes().size() == 1; }));
  CHECK(third.session().takes()[0].name == "found");
  std::size_t aside = 0;
  for (const auto& entry : fs::directory_iterator(folder))
    aside += entry.path().filename().string().starts_with("takes.damaged-") ? 1 : 0;
  CHECK(aside == (damaged ? 1U : 0U));
}

TEST_CASE("A list of kept takes that is damaged, or names other folders, opens nothing and breaks nothing") {
  const Desk desk;
  Started program(desk.root);
  const fs::path folder = program.keeper.folderOf(desk.file);
  fs::create_directories(folder);
  const std::string text =
      GENERATE(std::string("[{\"file\": \"../../slab.scene.json\"}]"), std::string("{{{"),
               std::string("[1, {\"file\": 7}, {\"file\": \"gone.take\"}]"));
  std::ofstream(folder / "takes.json") << text;
  program.open(desk.file);
  CHECK(program.session().takes().empty());
  program.fixture.simulateToEnd();
  CHECK(program.session().takes().size() == 1);
}

}  // namespace
