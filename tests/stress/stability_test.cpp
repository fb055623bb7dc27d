#include <catch2/catch.hpp>

#include "app/bench/stability_cases.h"

namespace {

TEST_CASE("nothing a scene may ask for makes a run unstable") {
  // The extremes of each group of `bench stability`; what must hold and why stands with judge().
  for (const app::StabilityCase& one : app::stabilityCases(true)) {
    const app::StabilityResult result = app::judge(one);
    INFO(one.group << ' ' << one.value << ", " << one.method << ": " << result.reason << ", energy rose by "
                   << result.maxRise);
    CHECK(result.passed);
  }
}

TEST_CASE("what must be refused or seen is") {
  // A step that is far too long: the judge must not pass it.
  app::StabilityCase broken = app::stabilityCases(true).front();
  broken.start = [] {
    sim::Blueprint pair;
    pair.materials = {{.name = "spring"}};
    pair.partNames = {"pair"};
    pair.nodes = {{.mass = 1.0}, {.position = sim::Vec3(1.1, 0.0, 0.0), .mass = 1.0}};
    pair.bonds = {{0, 1, 1000.0, 1.0, 0.0, 0}};
    sim::Settings settings;
    settings.step = 0.2;
    sim::Environment nothing;
    nothing.gravity = sim::Vec3::Zero();
    return sim::Simulation::create(sim::buildNetwork(pair, 1).value(), nothing, {}, settings);
  };
  const app::StabilityResult result = app::judge(broken);
  CHECK_FALSE(result.passed);
  CHECK(result.reason.find("refused: solver.step") == 0);
}

}  // namespace
