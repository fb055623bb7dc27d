#include "modeling/import/mesh_units.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace modeling {
namespace {

using sim::Vec3;

struct UnitName {
  MeshUnit unit;
  double centimetres;
  const char* name;
};
/// In the order in which they are guessed.
constexpr std::array<UnitName, 4> kUnits{{{MeshUnit::centimetre, 1.0, "centimetres"},
                                          {MeshUnit::millimetre, 0.1, "millimetres"},
                                          {MeshUnit::metre, 100.0, "metres"},
                                          {MeshUnit::inch, 2.54, "inches"}}};
/// What dishware measures at its longest, cm: from an egg cup to a platter.
constexpr double kSmallestDish = 3.0;
constexpr double kLargestDish = 60.0;

std::string nameOf(double centimetres) {
  for (const UnitName& known : kUnits)
    if (std::abs(known.centimetres / centimetres - 1.0) < 1e-6) return known.name;
  std::ostringstream words;
  words.precision(6);
  words << "units of " << centimetres << " cm";
  return words.str();
}

std::string sizeText(const Vec3& size) {
  std::ostringstream words;
  words.precision(3);
  words << size.x() << " x " << size.y() << " x " << size.z() << " cm";
  return words.str();
}

bool isDish(double length) {
  return length >= kSmallestDish && length <= kLargestDish;
}

struct Unit {
  double centimetres = 1.0;
  Statement said = Statement::nobody;
  bool isGuess = false;
  std::string words;
};

/// STL comes from design and printing, which count in millimetres.
std::vector<UnitName> guesses(const std::string& ending) {
  std::vector<UnitName> units(kUnits.begin(), kUnits.end());
  if (ending == ".stl") std::swap(units[0], units[1]);
  return units;
}

Unit guessed(const std::string& ending, const Vec3& extent) {
  const double size = extent.maxCoeff();
  Unit unit;
  std::string others;
  for (const UnitName& guess : guesses(ending)) {
    if (!isDish(size * guess.centimetres)) continue;
    if (unit.isGuess && guess.unit != MeshUnit::inch) {
      others += std::string(others.empty() ? "" : ", and ") + "in " + guess.name + " it would be " +
                sizeText(guess.centimetres * extent);
    } else if (!unit.isGuess) {
      unit = {guess.centimetres, Statement::nobody, true, std::string("in ") + guess.name};
    }
  }
  if (!unit.isGuess) {
    const UnitName first = guesses(ending).front();
    return {first.centimetres, Statement::nobody, true,
            std::string("in ") + first.name + ", as no unit makes it as large as dishware (state its unit)"};
  }
  unit.words +=
      " by a guess at its size (" + (others.empty() ? "" : others + "; ") + "state its unit to be sure)";
  return unit;
}

Unit unitOf(const MeshSource& source, const RawMesh& raw, const std::string& ending, const Vec3& extent) {
  const bool isSaid = raw.unitSaid != Statement::nobody && raw.unit > 0.0 && std::isfinite(raw.unit);
  for (const UnitName& known : kUnits) {
    if (source.unit != known.unit) continue;
    Unit unit{known.centimetres, Statement::nobody, false, std::string("in ") + known.name};
    if (isSaid && nameOf(raw.unit) == known.name) unit.said = raw.unitSaid;
    if (isSaid && nameOf(raw.unit) != known.name && raw.unitSaid == Statement::theFile)
      unit.words += ", as the scene says (the file states " + nameOf(raw.unit) + "),";
    return unit;
  }
  if (isSaid) return {raw.unit, raw.unitSaid, false, "in " + nameOf(raw.unit)};
  return guessed(ending, extent);
}

struct Axes {
  std::array<Vec3, 3> axes{};
  Statement said = Statement::nobody;
  std::string words;
};

std::string upText(const Vec3& up) {
  Eigen::Index axis = 0;
  up.cwiseAbs().maxCoeff(&axis);
  return std::string(up[axis] < 0.0 ? "with -" : "with ") + "xyz"[axis] + " up";
}

Axes axesOf(const MeshSource& source, const RawMesh& raw) {
  if (source.up == MeshUp::guess && raw.axesSaid != Statement::nobody)
    return {raw.axes, raw.axesSaid, upText(raw.axes[2])};
  RawMesh stated;
  stated.stateUp(source.up == MeshUp::y ? 'y' : 'z', Statement::nobody);
  const bool agree = raw.axesSaid != Statement::nobody && raw.axes[2] == stated.axes[2];
  // What the person repeats is taken with the sides that the file gives it.
  if (agree) return {raw.axes, raw.axesSaid, upText(raw.axes[2])};
  return {stated.axes, Statement::nobody, upText(stated.axes[2])};
}

const char* saidText(Statement statement) {
  if (statement == Statement::theFile) return ", as the file states";
  return statement == Statement::theFormat ? ", as its format says" : "";
}

}  // namespace

MeshInterpretation interpretationOf(const MeshSource& source, const RawMesh& raw, const std::string& ending,
                                    const Vec3& extent) {
  const Axes axes = axesOf(source, raw);
  Vec3 turned;
  for (std::size_t i = 0; i < 3; ++i)
    turned[static_cast<Eigen::Index>(i)] = axes.axes[i].cwiseAbs().dot(extent);
  const Unit unit = unitOf(source, raw, ending, turned);
  const bool isOne = unit.said == axes.said;
  std::string words = unit.words + (isOne ? "" : saidText(unit.said));
  words += (isOne || unit.said == Statement::nobody ? " and " : ", and ") + axes.words + saidText(axes.said);
  return {unit.centimetres, axes.axes, words};
}

}  // namespace modeling
