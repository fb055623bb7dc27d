#include "modeling/material/material.h"

#include <cmath>
#include <functional>

#include <catch2/catch.hpp>

#include "tests/support/elastic_body.h"

using namespace modeling;
using tests::Block;

namespace {

/// Energy per area of the bonds that cross the plane x = 1.5 h of a 3 x 8 x 8 block, all stretched by t:
/// counted bond by bond, in the middle of the block.
double energyAcrossPlane(const Material& material, double h, double t) {
  const Block block{{3, 8, 8}, h};
  const sim::Blueprint body = tests::bodyOf(block.lattice(), material);
  double energy = 0.0;
  for (const auto& bond : body.bonds) {
    const Vec3& a = body.nodes[bond.a].position;
    const Vec3& b = body.nodes[bond.b].position;
    if ((a.x() - 1.5 * h) * (b.x() - 1.5 * h) > 0.0) continue;
    // Half of what starts or ends on the border of the window belongs to it: the window may be shifted by a
    // cell.
    for (const Vec3& end : {a, b}) {
      const bool inside = end.y() > 1.5 * h && end.y() < 5.5 * h && end.z() > 1.5 * h && end.z() < 5.5 * h;
      if (inside) energy += 0.25 * bond.stiffness * std::pow(t * bond.restLength, 2);
    }
  }
  return energy / std::pow(4.0 * h, 2);
}

}  // namespace

TEST_CASE("patterns are found by the names they give") {
  for (const std::string& name : bondPatternNames()) CHECK(nameOf(*bondPatternFromName(name)) == name);
  CHECK(bondPatternNames().size() == 4);
  CHECK_FALSE(bondPatternFromName("cubic"));
}

TEST_CASE("a threshold from toughness makes the bonds across a plane hold the fracture energy") {
  for (const auto pattern : {BondPattern::full, BondPattern::fig1, BondPattern::fig2, BondPattern::faces})
    for (const double h : {0.25, 2.0}) {
      Material material = tests::plainMaterial(pattern);
      material.fractureToughness = 3.0;
      const double fractureEnergy = 3.0 * 3.0 * (1.0 - 0.25 * 0.25) / material.youngsModulus;
      CHECK(energyAcrossPlane(material, h, breakStrain(material, h)) == Approx(fractureEnergy).epsilon(1e-9));
    }
}

TEST_CASE("glass of half-centimetre cells breaks at a strain of about 1e-4") {
  Material glass = tests::plainMaterial();
  glass.youngsModulus = 7.2e11;
  glass.fractureToughness = 0.75e8;
  CHECK(breakStrain(glass, 0.5) == Approx(1.0e-4).epsilon(0.02));
}

TEST_CASE("a threshold from strength does not depend on the cell size, and the stated one is itself") {
  Material material = tests::plainMaterial();
  material.strength = 20.0;
  CHECK(breakStrain(material, 0.1) == 0.02);
  CHECK(breakStrain(material, 5.0) == 0.02);
  material.strength.reset();
  material.threshold = {0.07, 0.2};
  CHECK(resolve(material, 1.0).thresholdMean == 0.07);
  CHECK(resolve(material, 1.0).thresholdSpread == 0.2);
  CHECK(breakStrain(tests::plainMaterial(), 1.0) == sim::kUnbreakable);
}

TEST_CASE("the network's highest frequency is damped by half the loss factor") {
  Material material = tests::plainMaterial();
  material.lossFactor = 0.2;
  // zeta = beta omega / 2.
  CHECK(dampingTime(material, 0.3) * highestFrequency(material, 0.3) / 2.0 == Approx(0.1).epsilon(1e-12));
}

TEST_CASE("what a person may get wrong in a material is said with its key") {
  const auto placeOf = [](const std::function<void(Material&)>& spoil) {
    Material material = tests::plainMaterial();
    spoil(material);
    const auto status = validate(material);
    return status ? std::string("fine") : status.problem().place;
  };
  CHECK(placeOf([](Material&) {}) == "fine");
  CHECK(placeOf([](Material& m) { m.youngsModulus = 0.0; }) == "youngsModulus");
  CHECK(placeOf([](Material& m) { m.youngsModulus = std::nan(""); }) == "youngsModulus");
  CHECK(placeOf([](Material& m) { m.density = -1.0; }) == "density");
  CHECK(placeOf([](Material& m) { m.lossFactor = -0.1; }) == "lossFactor");
  CHECK(placeOf([](Material& m) { m.threshold.mean = 0.0; }) == "threshold.mean");
  CHECK(placeOf([](Material& m) { m.threshold.spread = 0.6; }) == "threshold.spread");
  CHECK(placeOf([](Material& m) { m.strength = -2.0; }) == "strength");
  CHECK(placeOf([](Material& m) { m.fractureToughness = INFINITY; }) == "fractureToughness");
  CHECK(placeOf([](Material& m) { m.strength = m.fractureToughness = 2.0; }) == "threshold");
  CHECK(placeOf([](Material& m) { m.plastic = Plastic{0.0, 1.0}; }) == "plastic.yieldStrain");
  CHECK(placeOf([](Material& m) { m.plastic = Plastic{0.1, 0.0}; }) == "plastic.rate");
  CHECK(placeOf([](Material& m) { m.look.inside[2] = 1.5; }) == "look.inside");
  CHECK(placeOf([](Material& m) { m.look.glaze = -1.0; }) == "look.glaze");
}
