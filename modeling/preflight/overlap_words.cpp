#include <cmath>
#include <cstdio>

#include "modeling/preflight/overlaps.h"
#include "modeling/text/spelling.h"

namespace modeling {
namespace {

using sim::Vec3;

std::string shortNumber(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.3g", value == 0.0 ? 0.0 : value);
  return digits;
}

/// Away from zero to three digits, so that a move by what is read is no shorter.
double roundedUp(double value) {
  if (value == 0.0 || !std::isfinite(value)) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
  // What is a round number but for its last bits is meant to be one.
  return std::copysign(std::ceil(std::abs(value) / unit - 1e-6) * unit, value);
}

std::string place(const Vec3& at) {
  std::string text = "(";
  for (const double value : at) {
    if (text.size() > 1) text += ", ";
    text += shortNumber(std::abs(value) < 1e-9 ? 0.0 : value);
  }
  text += ")";
  return text;
}

std::string words(const Overlap::Mend& mend) {
  const std::string what = inQuotes(mend.part) + (mend.glued ? " and what is glued to it" : "");
  const Vec3& move = mend.move;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (std::abs(move[axis]) < move.norm() * (1.0 - 1e-9)) continue;
    const std::string length = shortNumber(roundedUp(std::abs(move[axis]))) + " cm";
    if (axis == 2) return "move " + what + (move.z() > 0.0 ? " up" : " down") + " by " + length;
    const std::string way = std::string(move[axis] > 0.0 ? "+" : "-") + (axis == 0 ? "x" : "y");
    return "move " + what + " by " + length + " along " + way;
  }
  return "move " + what + " by " + place({roundedUp(move.x()), roundedUp(move.y()), roundedUp(move.z())}) +
         " cm";
}

std::string remedy(const Overlap& overlap) {
  const std::string move = overlap.mend ? words(*overlap.mend) : "move them apart";
  return overlap.kind == Overlap::Kind::parts ? move + ", or glue them" : move;
}

}  // namespace

std::string sentence(const Overlap& overlap) {
  const std::string depth = shortNumber(overlap.depth) + " cm";
  const std::string at = ", deepest at " + place(overlap.at) + ", ";
  const std::string part = inQuotes(overlap.part), other = inQuotes(overlap.other);
  switch (overlap.kind) {
    case Overlap::Kind::partInObstacle:
      return "the part " + part + " begins " + depth + " inside the obstacle " + other + at +
             "and will be let out slowly, if it can; " + remedy(overlap);
    case Overlap::Kind::obstacleInPart:
      return "the obstacle " + other + " stands " + depth + " deep inside the part " + part + at +
             "between its nodes, which do not feel it there; " + remedy(overlap);
    case Overlap::Kind::parts:
      return "the parts " + part + " and " + other + " overlap by " + depth + at +
             "and may stay inside each other; " + remedy(overlap);
  }
  return "";
}

}  // namespace modeling
