#include <fstream>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"

namespace {

/// What stands in README.md between ```json and ```.
std::string sceneOfReadme() {
  std::ifstream stream(SMITHEREENS_SOURCE_DIR "/README.md");
  std::stringstream text;
  text << stream.rdbuf();
  const std::string readme = text.str();
  const std::string fence = "```json\n";
  const auto begin = readme.find(fence) + fence.size();
  return readme.substr(begin, readme.find("```", begin) - begin);
}

}  // namespace

TEST_CASE("the first scene that README shows can be built", "[scene]") {
  const auto file = modeling::parseScene(sceneOfReadme(), "README.md");
  if (!file) FAIL(file.problem().line());
  const auto setup = modeling::build(file->scene, SMITHEREENS_SOURCE_DIR);
  if (!setup) FAIL(setup.problem().line());
  CHECK(setup->network.nodeCount() > 1000);
}
