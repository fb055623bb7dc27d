#include <catch2/catch.hpp>

#include "modeling/scene/resources.h"

using namespace modeling;

TEST_CASE("every preset is a sound material, with its sources") {
  const std::vector<std::string> expected{
      "jelly", "porcelain", "rubber", "soda-lime-glass", "steel-spoon", "terracotta", "tipsy-turvy-ceramic"};
  CHECK(presetNames() == expected);
  for (const std::string& name : presetNames()) {
    INFO(name);
    const auto material = presetMaterial(name);
    if (!material) FAIL(material.problem().line());
    CHECK(material->name == name);
    const auto status = validate(*material);
    if (!status) FAIL(status.problem().line());
    for (const char* key : {"youngsModulus", "density", "lossFactor"})
      CHECK((name == "tipsy-turvy-ceramic" || material->source.find(key) != std::string::npos));
  }
}

TEST_CASE("presets differ as their substances do") {
  const auto strainOf = [](const char* name) { return breakStrain(*presetMaterial(name), 0.5); };
  CHECK(strainOf("soda-lime-glass") < strainOf("porcelain"));
  CHECK(strainOf("porcelain") < strainOf("tipsy-turvy-ceramic"));
  CHECK(strainOf("steel-spoon") < strainOf("rubber"));
  CHECK(strainOf("jelly") == sim::kUnbreakable);
  CHECK(presetMaterial("steel-spoon")->plastic);
}
