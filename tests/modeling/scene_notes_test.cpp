// Scenes of older versions, with keys that mean nothing any more.
#include <catch2/catch.hpp>

#include "modeling/scene/salvage.h"
#include "modeling/scene/scene_file.h"
#include "tests/modeling/scene_examples.h"

namespace {

using modeling::parseScene;
using tests::kPlainScene;
using tests::replaced;

const std::string kOldScene = replaced(kPlainScene, "\"parts\"",
                                       R"("solver": {"precision": "float", "safety": 0.4,
             "skip": {"sleep": false, "ledger": 3, "labelling": [true, {}]}},
  "parts")");

TEST_CASE("a key that was retired is read over, with a note that says where and since when") {
  const auto file = parseScene(kOldScene, "old");
  if (!file) FAIL(file.problem().line());
  CHECK(file->scene.solver.safety == 0.4);
  CHECK_FALSE(file->scene.solver.skip.sleep);
  REQUIRE(file->notes.size() == 3);
  CHECK(file->notes[0].line() ==
        "old:4:14: \"precision\" means nothing since November 2026, as forces are always computed in double "
        "precision; take it out");
  CHECK(file->notes[1].place == "old:5:39");
  CHECK(file->notes[1].what.starts_with("\"ledger\" means nothing since November 2026"));
  CHECK(file->notes[2].place == "old:5:52");
}

TEST_CASE("a scene without such keys has no notes, and writing an old one leaves them out") {
  CHECK(parseScene(kPlainScene, "s")->notes.empty());
  const std::string written = modeling::writeScene(parseScene(kOldScene, "old")->scene);
  CHECK(written.find("precision") == std::string::npos);
  const auto again = parseScene(written, "written");
  REQUIRE(again.ok());
  CHECK(again->notes.empty());
  CHECK(again->scene == parseScene(kOldScene, "old")->scene);
}

TEST_CASE("a setting of a retired key is noted too") {
  const auto file = parseScene(kPlainScene, "s", {"solver.precision=float"});
  REQUIRE(file.ok());
  REQUIRE(file->notes.size() == 1);
  CHECK(file->notes[0].place.starts_with("--set solver.precision:"));
}

TEST_CASE("a retired key does not make other unknown keys known") {
  const auto file = parseScene(replaced(kOldScene, "\"ledger\"", "\"legder\""), "old");
  REQUIRE_FALSE(file.ok());
  CHECK(file.problem().what == "there is no key \"legder\" here");
  CHECK_FALSE(
      parseScene(replaced(kPlainScene, "\"parts\"", "\"precision\": \"float\", \"parts\""), "s").ok());
}

TEST_CASE("a damaged old scene keeps its notes when it is salvaged") {
  const auto salvaged = modeling::salvageScene(
      replaced(kOldScene, "\"parts\": [",
               "\"parts\": [{\"name\": \"lost\", \"kind\": \"slab\", \"material\": \"clay\"}, "),
      "old");
  REQUIRE(salvaged.ok());
  CHECK(salvaged->faults.size() == 1);
  CHECK(salvaged->notes.size() == 3);
}

}  // namespace
