#include "modeling/shapes/sweep_path.h"

#include <Eigen/Geometry>

namespace modeling {
namespace {

// Reflections between two stations: the axis then follows the curve to about 1e-4 of its turn.
constexpr int kSubsteps = 8;

// Sine of the angle below which two directions count as one.
constexpr double kParallel = 1e-6;

std::optional<sim::Problem> checkValues(const ValueChain& values, std::size_t segments,
                                        const std::string& place) {
  if (values.size() != 1 && values.size() != segments)
    return sim::Problem{place,
                        "there are " + std::to_string(values.size()) + " segments of it for " +
                            std::to_string(segments) + " of the curve",
                        "give one segment for each of the curve's, or one for all"};
  for (const auto& segment : values)
    for (const double value : segment)
      if (!(value > 0.0) || !std::isfinite(value))
        return sim::Problem{place, "it must be positive everywhere", "give positive lengths in centimetres"};
  return std::nullopt;
}

/// One step of the double reflection: carries `axis` from one point and tangent to the next.
Vec3 carried(const Vec3& axis, const Vec3& step, const Vec3& tangent, const Vec3& nextTangent) {
  const double squared = step.squaredNorm();
  if (!(squared > 0.0)) return axis;
  const Vec3 mirroredAxis = axis - 2.0 / squared * step.dot(axis) * step;
  const Vec3 mirroredTangent = tangent - 2.0 / squared * step.dot(tangent) * step;
  const Vec3 turn = nextTangent - mirroredTangent;
  const double turnSquared = turn.squaredNorm();
  if (!(turnSquared > 0.0)) return mirroredAxis;
  return mirroredAxis - 2.0 / turnSquared * turn.dot(mirroredAxis) * turn;
}

}  // namespace

sim::Result<SweepPath> SweepPath::make(const CurvedCylinderShape& shape) {
  if (auto problem = checkChain(shape.curve, "curve")) return *problem;
  CurveChain centre = shape.curve;
  if (shape.secondRail.empty()) {
    if (auto problem = checkValues(shape.halfWidth, shape.curve.size(), "halfWidth")) return *problem;
    if (!shape.firstAxis.allFinite() || !(shape.firstAxis.norm() > 0.0))
      return sim::Problem{"firstAxis", "it has no direction", "give a vector that is not zero"};
  } else {
    if (auto problem = checkChain(shape.secondRail, "secondRail")) return *problem;
    if (shape.secondRail.size() != shape.curve.size())
      return sim::Problem{"secondRail", "the rails have different numbers of segments",
                          "split the shorter one"};
    for (std::size_t i = 0; i < centre.size(); ++i)
      for (std::size_t k = 0; k < 4; ++k) centre[i][k] = 0.5 * (shape.curve[i][k] + shape.secondRail[i][k]);
    if (auto problem = checkChain(centre, "secondRail")) return *problem;
  }
  if (auto problem = checkValues(shape.halfDepth, shape.curve.size(), "halfDepth")) return *problem;
  return SweepPath(shape, std::move(centre));
}

SweepPath::SweepPath(const CurvedCylinderShape& shape, CurveChain centre)
    : shape_(shape), centre_(std::move(centre)) {}

double SweepPath::sizeAt(const ValueChain& values, const Place& place, double share) const {
  const bool perSegment = values.size() == centre_.segments().size();
  return perSegment ? evaluate(values[place.segment], place.t) : evaluate(values[0], share);
}

std::optional<sim::Problem> SweepPath::setAxes(SweepStation& station, const Place& place) const {
  Vec3 across = shape_.firstAxis.normalized();
  if (!shape_.secondRail.empty()) {
    const Vec3 between =
        evaluate(shape_.secondRail[place.segment], place.t) - evaluate(shape_.curve[place.segment], place.t);
    station.halfWidth = 0.5 * between.norm();
    if (station.halfWidth <= 1e-6 * length())
      return sim::Problem{"secondRail", "the rails meet", "keep them apart, their ends too"};
    across = between.normalized();
  }
  const Vec3 second = station.tangent.cross(across);
  if (second.norm() < kParallel) {
    if (shape_.secondRail.empty())
      return sim::Problem{"firstAxis", "the curve runs along it", "choose an axis across the curve"};
    return sim::Problem{"secondRail", "the sweep runs along the section", "let the rails run side by side"};
  }
  station.second = second.normalized();
  station.first = shape_.secondRail.empty() ? Vec3(station.second.cross(station.tangent)) : across;
  return std::nullopt;
}

void SweepPath::carryAxis(std::vector<SweepStation>& stations) const {
  const auto steps = static_cast<double>((stations.size() - 1) * kSubsteps);
  Vec3 axis = stations[0].first;
  Place at = centre_.atShare(0.0);
  for (std::size_t i = 1; i < stations.size(); ++i) {
    for (std::size_t k = 1; k <= kSubsteps; ++k) {
      const Place next = centre_.atShare(static_cast<double>((i - 1) * kSubsteps + k) / steps);
      axis =
          carried(axis, centre_.point(next) - centre_.point(at), centre_.tangent(at), centre_.tangent(next));
      at = next;
    }
    SweepStation& station = stations[i];
    station.second = station.tangent.cross(axis).normalized();
    station.first = station.second.cross(station.tangent);
  }
}

sim::Result<std::vector<SweepStation>> SweepPath::stations(int cells) const {
  std::vector<SweepStation> result;
  const bool carries = shape_.secondRail.empty() && !shape_.keepFirstAxis;
  for (int i = 0; i <= cells; ++i) {
    const double share = static_cast<double>(i) / cells;
    const Place place = centre_.atShare(share);
    SweepStation station;
    station.centre = centre_.point(place);
    station.tangent = centre_.tangent(place);
    if (shape_.secondRail.empty()) station.halfWidth = sizeAt(shape_.halfWidth, place, share);
    station.halfDepth = sizeAt(shape_.halfDepth, place, share);
    if (i == 0 || !carries)
      if (auto problem = setAxes(station, place)) return *problem;
    result.push_back(station);
  }
  if (carries) carryAxis(result);
  return result;
}

}  // namespace modeling
