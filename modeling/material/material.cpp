#include "modeling/material/material.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace modeling {
namespace {

constexpr std::array<std::pair<BondPattern, std::string_view>, 4> kPatterns{{{BondPattern::full, "full"},
                                                                             {BondPattern::fig1, "fig1"},
                                                                             {BondPattern::fig2, "fig2"},
                                                                             {BondPattern::faces, "faces"}}};

/// C11 / E of every isotropic central-force network: lambda + 2 mu with lambda = mu = 0.4 E.
constexpr double kLongitudinalShare = 1.2;

/// Energy per h^2 at strain t of the bonds that cross a (100) plane of a lattice of cubes is
/// (this / 2) t^2 E h: k1 + 8 k2 + 12 k3 in units of E h, and k1 + 4 k2 where each face has one diagonal.
double crossingStiffness(BondPattern pattern) {
  switch (pattern) {
    case BondPattern::full:
      return 4.0;
    case BondPattern::fig1:
      return 4.4;
    case BondPattern::fig2:
    case BondPattern::faces:
      return 3.6;
  }
  return 4.0;
}

bool positive(double value) {
  return std::isfinite(value) && value > 0.0;
}
bool notNegative(double value) {
  return std::isfinite(value) && value >= 0.0;
}

sim::Status mustBePositive(double value, const char* key, const char* unit) {
  if (positive(value)) return sim::Done{};
  return sim::Problem{key, "must be a positive number", std::string("give it in ") + unit};
}

sim::Status validateThreshold(const Material& material) {
  const int given = int(material.threshold.mean.has_value()) + int(material.strength.has_value()) +
                    int(material.fractureToughness.has_value());
  if (given > 1)
    return sim::Problem{"threshold", "the break strain is given in more than one way",
                        "keep one of threshold.mean, strength and fractureToughness"};
  if (material.threshold.mean && !positive(*material.threshold.mean))
    return sim::Problem{"threshold.mean", "must be a positive number",
                        "give the relative stretch at which bonds break, or leave it out for a material that "
                        "never breaks"};
  // A normal deviate past 1 / spread would make a threshold negative; past one half that is one bond in 44.
  if (!notNegative(material.threshold.spread) || material.threshold.spread > 0.5)
    return sim::Problem{"threshold.spread", "must lie between 0 and 0.5",
                        "give the standard deviation relative to the mean"};
  if (material.strength)
    if (auto status = mustBePositive(*material.strength, "strength", "dyn/cm^2"); !status) return status;
  if (material.fractureToughness)
    return mustBePositive(*material.fractureToughness, "fractureToughness", "dyn/cm^(3/2)");
  return sim::Done{};
}

sim::Status validateLook(const Look& look) {
  const auto inRange = [](double component) { return component >= 0.0 && component <= 1.0; };
  if (!std::all_of(look.outside.begin(), look.outside.end(), inRange))
    return sim::Problem{"look.outside", "a colour component lies outside 0 to 1", "give red, green and blue"};
  if (!std::all_of(look.inside.begin(), look.inside.end(), inRange))
    return sim::Problem{"look.inside", "a colour component lies outside 0 to 1", "give red, green and blue"};
  if (!inRange(look.glaze)) return sim::Problem{"look.glaze", "must lie between 0 (matt) and 1", ""};
  return sim::Done{};
}

}  // namespace

std::optional<BondPattern> bondPatternFromName(std::string_view name) {
  for (const auto& [pattern, patternName] : kPatterns)
    if (patternName == name) return pattern;
  return std::nullopt;
}

std::string_view nameOf(BondPattern pattern) {
  return std::find_if(kPatterns.begin(), kPatterns.end(),
                      [&](const auto& entry) { return entry.first == pattern; })
      ->second;
}

const std::vector<std::string>& bondPatternNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    all.reserve(std::size(kPatterns));
    for (const auto& entry : kPatterns) all.emplace_back(entry.second);
    return all;
  }();
  return names;
}

sim::Status validate(const Material& material) {
  if (auto status = mustBePositive(material.youngsModulus, "youngsModulus", "dyn/cm^2"); !status)
    return status;
  if (auto status = mustBePositive(material.density, "density", "g/cm^3"); !status) return status;
  if (!notNegative(material.lossFactor))
    return sim::Problem{"lossFactor", "must be zero or a positive number",
                        "0.2 damps the shortest waves well"};
  if (auto status = validateThreshold(material); !status) return status;
  if (material.plastic) {
    if (!positive(material.plastic->yieldStrain))
      return sim::Problem{"plastic.yieldStrain", "must be a positive number",
                          "give the strain past which it flows, or leave plastic out"};
    if (auto status = mustBePositive(material.plastic->rate, "plastic.rate", "1/s"); !status) return status;
  }
  return validateLook(material.look);
}

double breakStrain(const Material& material, double cellSize) {
  if (material.threshold.mean) return *material.threshold.mean;
  if (material.strength) return *material.strength / material.youngsModulus;
  if (!material.fractureToughness) return sim::kUnbreakable;
  const double toughness = *material.fractureToughness;
  const double energy =
      toughness * toughness * (1.0 - kPoissonRatio * kPoissonRatio) / material.youngsModulus;
  return std::sqrt(2.0 * energy / (crossingStiffness(material.pattern) * material.youngsModulus * cellSize));
}

double highestFrequency(const Material& material, double cellSize) {
  return 2.0 * std::sqrt(kLongitudinalShare * material.youngsModulus / material.density) / cellSize;
}

double dampingTime(const Material& material, double cellSize) {
  return material.lossFactor / highestFrequency(material, cellSize);
}

sim::Material resolve(const Material& material, double cellSize) {
  sim::Material resolved;
  resolved.name = material.name;
  resolved.thresholdMean = breakStrain(material, cellSize);
  resolved.thresholdSpread = material.threshold.spread;
  if (material.plastic) {
    resolved.yieldStrain = material.plastic->yieldStrain;
    resolved.flowRate = material.plastic->rate;
  }
  return resolved;
}

}  // namespace modeling
