#include <catch2/catch.hpp>

#include "modeling/scene/scene_file.h"
#include "modeling/text/spelling.h"
#include "tests/modeling/scene_examples.h"

namespace {

using modeling::parseScene;
using tests::kFullScene;
using tests::kPlainScene;
using tests::replaced;

std::string problemOf(const std::string& text) {
  const auto file = parseScene(text, "s");
  return file.ok() ? "" : file.problem().line();
}

struct Mistake {
  const char* from;
  const char* to;
  const char* line;
};

TEST_CASE("a mistake in a scene is one line with the place and the remedy") {
  const Mistake mistakes[] = {
      {"\"size\": [4", "\"size\": [4,",
       "s:5:70: this is not valid JSON: unexpected ',', expected '[', '{', or a literal; correct the JSON "
       "here"},
      {"[4, 2, 2]", "[4, 2]", "s:5:67: size has 2 entries; give a list of 3"},
      {"[4, 2, 2]", "[4, 0, 2]", "s:5:71: size holds 0; give a number from 1e-06 to 1e+06"},
      {"[4, 2, 2]", "[4, 1e999, 2]", "s:5:71: the number \"1e999\" is too large; give a finite number"},
      {"[4, 2, 2]", "[4, NaN, 2]", "s:5:71: this is not valid JSON: invalid literal; correct the JSON here"},
      {"[4, 2, 2]", "\"big\"", "s:5:67: size holds a text; give a list of 3"},
      {"\"size\"", "\"sise\"", "s:5:59: there is no key \"sise\" here; did you mean \"size\""},
      {"1e8}", "1e8, \"densty\": 1}", "s:3:48: there is no key \"densty\" here; did you mean \"density\""},
      {"\"clay\", \"size\"", "\"caly\", \"size\"",
       "s:5:51: there is no material \"caly\"; did you mean \"clay\""},
      {", \"size\": [4, 2, 2]", "", "s:5:5: the key \"size\" is missing; add it to this object"},
      {"\"slab\"", "\"slob\"",
       "s:5:31: kind does not know \"slob\"; did you mean \"slab\"? There are slab, patch, revolution, "
       "curvedCylinder, network, mesh"},
      {"\"smithereens\": 1", "\"smithereens\": 2",
       "s:2:18: this is a scene of version 2; open it with a newer Smithereens"},
      {"  \"smithereens\": 1,\n", "",
       "s:1:1: this is no Smithereens scene: the key \"smithereens\" is missing; begin it with "
       "\"smithereens\": 1"},
      {"\"kind\"", "\"name\": \"x\", \"kind\"", "s:5:23: \"name\" is given twice; keep one of them"},
      {"\"material\": \"clay\", ", "", "s:5:5: the part \"brick\" has no material; add the key \"material\""},
      {"1e8}", "1e8, \"strength\": 3, \"threshold\": {\"mean\": 1}}", nullptr},
  };
  for (const Mistake& mistake : mistakes) {
    const std::string line = problemOf(replaced(kPlainScene, mistake.from, mistake.to));
    INFO(mistake.to);
    CHECK_FALSE(line.empty());
    if (mistake.line != nullptr) CHECK(line == mistake.line);
  }
}

TEST_CASE("what refers to nothing is named with what is nearest") {
  const Mistake mistakes[] = {
      {"\"a\": \"spout\"", "\"a\": \"sput\"", "there is no part \"sput\"; did you mean \"spout\""},
      {"\"b\": \"cup\"", "\"b\": \"spout\"", "\"spout\" is glued to itself; name two different parts"},
      {"damping.scale.clay", "damping.scale.cley", "there is no material \"cley\"; did you mean \"clay\""},
      {"collider.ball.position", "collider.bell.position",
       "there is no collider \"bell\"; did you mean \"ball\""},
      {"\"gravity.scale\"", "\"gravitation.scale\"",
       "target does not know \"gravitation.scale\"; did you mean"},
      {"[0.5, 5]", "[0.7, 5]", "this key is not later than the one before; put the keys in order of time"},
      {"[0.5, 5]", "[0.5, [0, 0, 1]]", "this is the wrong kind of value for gravity.scale; give one number"},
      {"\"name\": \"leaf\"", "\"name\": \"brick\"", "\"brick\" is named twice; rename one of the two"},
      {"\"max\": [9, 9, 0.1]", "\"max\": [9, 9, -10]", "the box ends before it begins"},
      {"\"1\": {\"stiffness\"", "\"one\": {\"stiffness\"",
       "\"one\" is no bond type; give a whole number from 1 on"},
      {"[0.5, 0.5, 0.5, 0.5]", "[0, 0, 0, 0]", "this quaternion has no direction"},
      {"\"safety\": 0.4", "\"safety\": 1.4", "safety holds 1.4; give a number from 1e-04 to 0.9"},
      {"\"step\": 2e-6", "\"step\": {\"tolerance\": 2}", "tolerance holds 2; give a number from 1e-12 to 1"},
      {"\"step\": 2e-6", "\"step\": {}", "\"tolerance\""},
      {"\"seed\": 18446744073709551615", "\"seed\": 1.5", "seed holds 1.5; give a whole number"},
      {"\"symplectic-euler\"", "\"simplectic\"", "did you mean \"symplectic-euler\""},
  };
  for (const Mistake& mistake : mistakes) {
    const std::string line = problemOf(replaced(kFullScene, mistake.from, mistake.to));
    INFO(line);
    CHECK(line.find(mistake.line) != std::string::npos);
    CHECK(line.substr(0, 2) == "s:");
  }
}

TEST_CASE("texts made to break a reader are refused") {
  // The words in the middle are the library's, and other ones in each of its versions.
  CHECK_THAT(problemOf(""), Catch::StartsWith("s:1:1: this is not valid JSON: ") &&
                                Catch::EndsWith("; correct the JSON here"));
  CHECK(problemOf("[]").find("the scene holds a list") != std::string::npos);
  const std::string deep(1'000'000, '[');
  CHECK(problemOf(deep).find("s:1:65: this is nested more than 64 deep") == 0);
  std::string many = "[0";
  for (int i = 0; i < 1'100'000; ++i) many += ",0";
  CHECK(problemOf(many + "]").find("the file holds more than 1000000 values") != std::string::npos);
  CHECK_FALSE(problemOf(std::string("{\"a\xff\": 1}")).empty());
  CHECK_FALSE(problemOf(std::string("\0\0\0", 3)).empty());
}

TEST_CASE("columns count characters, not bytes, and a byte order mark is none") {
  CHECK(problemOf("\xEF\xBB\xBF{\"smithereens\": 1, \"\xC3\xA9\": 1, \"parts\": []}").substr(0, 7) ==
        "s:1:20:");
  CHECK(problemOf("{\"smithereens\": 1, \"name\": \"\xC3\xA9\xC3\xA9\", \"x\": 1}").substr(0, 7) ==
        "s:1:34:");
}

TEST_CASE("settings are laid over the text before it is read") {
  const auto file =
      parseScene(kFullScene, "s",
                 {"environment.gravity=[0,0,-1]", "materials.clay.threshold.mean=2e-3",
                  "parts[0].worldFromPart.position[2]=30", "parts.cup.velocity=[1,2,3]",
                  "solver.method=velocity-verlet", "view={}", "environment.colliders.ball.radius=7"});
  if (!file) FAIL(file.problem().line());
  CHECK(file->scene.environment.gravity == sim::Vec3(0, 0, -1));
  CHECK(file->scene.materials[0].values.threshold.mean == 2e-3);
  CHECK(file->scene.parts[0].worldFromPart.position.z() == 30.0);
  CHECK(file->scene.parts[2].velocity == sim::Vec3(1, 2, 3));
  CHECK(file->scene.solver.method == sim::Method::velocityVerlet);
  CHECK_FALSE(file->scene.view.camera);
}

TEST_CASE("a setting adds what the text left out") {
  const auto file = parseScene(kPlainScene, "s", {"solver.contact.friction=0.9", "output.fps=12"});
  if (!file) FAIL(file.problem().line());
  CHECK(file->scene.solver.contact.friction == 0.9);
  CHECK(file->scene.output.fps == 12.0);
}

TEST_CASE("a setting that leads nowhere names the nearest") {
  const std::pair<const char*, const char*> wrong[] = {
      {"environment.gravty=1", "there is no key \"gravty\" here; did you mean \"gravity\""},
      {"materials.cley.density=1", "there is no \"cley\" in \"materials\"; did you mean \"clay\""},
      {"parts.brik.velocity=[0,0,0]", "there is no \"brik\" in \"parts\"; did you mean \"brick\""},
      {"parts[9].velocity=[0,0,0]", "there is no \"9\" in \"parts\""},
      {"environment.gravity=[0,0", "this is not valid JSON"},
      {"environment.gravity=down", "gravity holds a text; give a list of 3"},
      {"nonsense", "this is not PATH=VALUE"},
      {"a..b=1", "this is not PATH=VALUE"},
      {"parts[0=1", "this is not PATH=VALUE"},
  };
  for (const auto& [setting, expected] : wrong) {
    const auto file = parseScene(kPlainScene, "s", {setting});
    INFO(setting);
    REQUIRE_FALSE(file.ok());
    CHECK(file.problem().line().find(expected) != std::string::npos);
    CHECK(file.problem().line().find("--set ") == 0);
  }
}

TEST_CASE("the nearest word is the one with the fewest edits") {
  CHECK(modeling::nearest("frction", {"fracture", "friction", "function"}) == "friction");
  CHECK(modeling::nearest("DENSITY", {"intensity", "density"}) == "density");
  CHECK(modeling::nearest("x", {}).empty());
}

}  // namespace
