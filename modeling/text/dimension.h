#pragma once

#include <string_view>

namespace modeling {

/// What a number measures. The scene keeps every number in the unit that stands beside its dimension.
enum class Dimension {
  number,           ///< none
  share,            ///< of a whole: 1 is 100 %
  length,           ///< cm
  mass,             ///< g
  time,             ///< s
  rate,             ///< 1/s
  velocity,         ///< cm/s
  acceleration,     ///< cm/s^2
  angle,            ///< rad in the scene, degrees in its file
  degrees,          ///< degrees in both
  angularVelocity,  ///< rad/s
  density,          ///< g/cm^3
  pressure,         ///< dyn/cm^2
  toughness,        ///< dyn/cm^(3/2)
  stiffness,        ///< dyn/cm
  damping,          ///< g/s
};

/// The unit in which a scene file gives the number; "" for numbers without one.
constexpr std::string_view unitInFile(Dimension dimension) {
  switch (dimension) {
    case Dimension::number:
    case Dimension::share:
      return "";
    case Dimension::length:
      return "cm";
    case Dimension::mass:
      return "g";
    case Dimension::time:
      return "s";
    case Dimension::rate:
      return "1/s";
    case Dimension::velocity:
      return "cm/s";
    case Dimension::acceleration:
      return "cm/s²";
    case Dimension::angle:
    case Dimension::degrees:
      return "degrees";
    case Dimension::angularVelocity:
      return "rad/s";
    case Dimension::density:
      return "g/cm³";
    case Dimension::pressure:
      return "dyn/cm²";
    case Dimension::toughness:
      return "dyn/cm^(3/2)";
    case Dimension::stiffness:
      return "dyn/cm";
    case Dimension::damping:
      return "g/s";
  }
  return "";
}

/// The largest magnitude, in the unit of files, that a number of the dimension may have where its field does
/// not say otherwise. Far beyond what anybody builds (10 km, 100 km/s, ten times the stiffness of diamond),
/// and near enough that products of a few of them are still numbers.
constexpr double reachOf(Dimension dimension) {
  switch (dimension) {
    case Dimension::number:
      return 1e9;
    case Dimension::share:
      return 1e3;
    case Dimension::length:
    case Dimension::time:
    case Dimension::angularVelocity:
      return 1e6;
    case Dimension::rate:
      return 1e9;
    case Dimension::velocity:
      return 1e7;
    case Dimension::acceleration:
      return 1e8;
    case Dimension::angle:
    case Dimension::degrees:
      return 36000.0;
    case Dimension::density:
      return 1e3;
    case Dimension::mass:
      return 1e12;
    case Dimension::pressure:
    case Dimension::toughness:
    case Dimension::damping:
      return 1e15;
    case Dimension::stiffness:
      return 1e18;
  }
  return 1e9;
}

/// The smallest length of anything that has one: a hundredth of a micrometre, cm.
inline constexpr double kSmallestLength = 1e-6;

}  // namespace modeling
