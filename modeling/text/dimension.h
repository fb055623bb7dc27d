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

}  // namespace modeling
