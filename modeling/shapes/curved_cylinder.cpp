#include "modeling/shapes/curved_cylinder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "modeling/shapes/cell_counts.h"
#include "modeling/shapes/grid.h"
#include "modeling/shapes/sheet.h"
#include "modeling/shapes/sweep_path.h"

namespace modeling {
namespace {

using std::numbers::pi;

constexpr const char* kRemedy = "bend the curve less sharply, or make the section narrower than its bends";

bool hasWall(const CurvedCylinderShape& shape) {
  return shape.section == SweepSection::ring || shape.section == SweepSection::arc;
}

std::optional<sim::Problem> checkSection(const CurvedCylinderShape& shape) {
  if (hasWall(shape) && !(shape.wallThickness > 0.0 && std::isfinite(shape.wallThickness)))
    return sim::Problem{"wallThickness", "the wall must have a positive thickness", "use for example 0.3"};
  if (shape.section != SweepSection::arc) return std::nullopt;
  const double turn = shape.endAngle - shape.startAngle;
  if (std::isfinite(turn) && turn > 0.0 && turn < 2.0 * pi) return std::nullopt;
  return sim::Problem{"endAngle", "an arc must end after its start, and before a full turn",
                      "use a ring for a full turn"};
}

std::optional<sim::Problem> checkWall(const CurvedCylinderShape& shape,
                                      const std::vector<SweepStation>& stations) {
  if (!hasWall(shape)) return std::nullopt;
  for (const SweepStation& station : stations)
    if (shape.wallThickness >= std::min(station.halfWidth, station.halfDepth))
      return sim::Problem{"wallThickness", "the wall leaves no hollow where the section is narrowest",
                          "use a thinner wall, a wider section, or a solid one"};
  return std::nullopt;
}

/// Angles on an ellipse at equal shares of its length.
class EllipseArc {
 public:
  EllipseArc(double halfWidth, double halfDepth, double start, double end) : start_(start), end_(end) {
    lengths_[0] = 0.0;
    Vec2 before(halfWidth * std::cos(start), halfDepth * std::sin(start));
    for (std::size_t i = 1; i <= kSamples; ++i) {
      const double angle = angleOf(static_cast<double>(i));
      const Vec2 here(halfWidth * std::cos(angle), halfDepth * std::sin(angle));
      lengths_[i] = lengths_[i - 1] + (here - before).norm();
      before = here;
    }
  }
  double length() const { return lengths_[kSamples]; }
  double angleAt(double share) const {
    const double target = share * length();
    const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, target);
    const auto sample = static_cast<std::size_t>(above - lengths_.begin()) - 1;
    const double within = (target - lengths_[sample]) / (lengths_[sample + 1] - lengths_[sample]);
    return angleOf(static_cast<double>(sample) + within);
  }

 private:
  static constexpr std::size_t kSamples = 256;
  double angleOf(double sample) const {
    return start_ + (end_ - start_) * sample / static_cast<double>(kSamples);
  }

  double start_, end_;
  std::array<double, kSamples + 1> lengths_{};
};

EllipseArc midWall(const CurvedCylinderShape& shape, const SweepStation& station) {
  const double inset = hasWall(shape) ? 0.5 * shape.wallThickness : 0.0;
  const bool arc = shape.section == SweepSection::arc;
  return {station.halfWidth - inset, station.halfDepth - inset, arc ? shape.startAngle : 0.0,
          arc ? shape.endAngle : 2.0 * pi};
}

Vec3 onSection(const SweepStation& station, double alongFirst, double alongSecond) {
  return station.centre + alongFirst * station.first + alongSecond * station.second;
}

class Sweeper {
 public:
  Sweeper(const CurvedCylinderShape& shape, std::vector<SweepStation> stations)
      : shape_(shape), stations_(std::move(stations)), along_(static_cast<int>(stations_.size()) - 1) {
    const auto count = static_cast<double>(stations_.size());
    for (const SweepStation& station : stations_) {
      meanWidth_ += 2.0 * station.halfWidth / count;
      meanDepth_ += 2.0 * station.halfDepth / count;
      meanAround_ += midWall(shape, station).length() / count;
    }
  }

  sim::Result<Lattice> run() const {
    switch (shape_.section) {
      case SweepSection::disc:
        return sweepDisc();
      case SweepSection::rectangle:
        return sweepRectangle();
      case SweepSection::ring:
      case SweepSection::arc:
        return sweepWall();
    }
    return sim::Problem{"section", "there is no such section", "use disc, rectangle, ring or arc"};
  }

 private:
  const SweepStation& station(double share) const {
    return stations_[static_cast<std::size_t>(std::lround(share * along_))];
  }
  std::optional<sim::Problem> checkCount(double sectionNodes) const {
    return checkNodeCount(sectionNodes * (along_ + 1.0));
  }

  sim::Result<Lattice> sweepDisc() const {
    const auto around = cellsAlong(shape_.resolution, 1, meanAround_, 8, 8);
    if (!around) return around.problem();
    DiscLayout layout;
    layout.core = *around / 8;
    layout.rings = flatDiscRings(layout.core);
    layout.angle = 2.0 * pi;
    if (auto problem = checkCount(discNodeCount(layout))) return *problem;
    const Disc disc = divideDisc(layout);
    const LayerOrder order = along_ > 2 * layout.core ? LayerOrder::innermost : LayerOrder::betweenRows;
    return stack({disc.points, disc.quads, disc.rows}, along_, order, [&](const Vec2& point, int layer) {
      const SweepStation& here = stations_[static_cast<std::size_t>(layer)];
      const double angle = 2.0 * pi * point[1];
      return PlacedNode{onSection(here, here.halfWidth * point[0] * std::cos(angle),
                                  here.halfDepth * point[0] * std::sin(angle)),
                        {static_cast<double>(layer) / along_, point[1], point[0]}};
    });
  }

  sim::Result<Lattice> sweepRectangle() const {
    const auto across = cellsAlong(shape_.resolution, 1, meanWidth_);
    if (!across) return across.problem();
    const auto through = cellsAlong(shape_.resolution, 2, meanDepth_);
    if (!through) return through.problem();
    if (auto problem = checkCount((*across + 1.0) * (*through + 1.0))) return *problem;
    return gridLattice({{along_, *across, *through}, {}}, [&](const Vec3& shares) {
      const SweepStation& here = station(shares.x());
      return onSection(here, here.halfWidth * (2.0 * shares.y() - 1.0),
                       here.halfDepth * (2.0 * shares.z() - 1.0));
    });
  }

  sim::Result<Lattice> sweepWall() const {
    const bool ring = shape_.section == SweepSection::ring;
    const auto around = cellsAlong(shape_.resolution, 1, meanAround_, 1, ring ? 3 : 1);
    if (!around) return around.problem();
    const auto through = cellsAlong(shape_.resolution, 2, shape_.wallThickness);
    if (!through) return through.problem();
    if (auto problem = checkCount((*around + 1.0) * (*through + 1.0))) return *problem;
    std::vector<EllipseArc> arcs;
    for (const SweepStation& here : stations_) arcs.push_back(midWall(shape_, here));
    return gridLattice({{along_, *around, *through}, {false, ring, false}}, [&](const Vec3& shares) {
      const SweepStation& here = station(shares.x());
      const double angle =
          arcs[static_cast<std::size_t>(std::lround(shares.x() * along_))].angleAt(shares.y());
      const double inset = (1.0 - shares.z()) * shape_.wallThickness;
      return onSection(here, (here.halfWidth - inset) * std::cos(angle),
                       (here.halfDepth - inset) * std::sin(angle));
    });
  }

  const CurvedCylinderShape& shape_;
  std::vector<SweepStation> stations_;
  int along_;
  double meanWidth_ = 0.0, meanDepth_ = 0.0, meanAround_ = 0.0;  ///< cm
};

double largest(const ValueChain& values) {
  double result = 0.0;
  for (const auto& segment : values)
    for (const double value : segment) result = std::max(result, value);
  return result;
}

}  // namespace

sim::Result<Lattice> build(const CurvedCylinderShape& shape) {
  if (auto problem = checkSection(shape)) return *problem;
  const auto path = SweepPath::make(shape);
  if (!path) return path.problem();
  const auto along = cellsAlong(shape.resolution, 0, path->length());
  if (!along) return along.problem();
  // No section has fewer nodes. Told before the sections are placed, which takes long where there are
  // millions.
  constexpr double kLeastSection = 4.0;
  if (auto problem = checkNodeCount(kLeastSection * (*along + 1.0))) return *problem;
  const auto stations = path->stations(*along);
  if (!stations) return stations.problem();
  if (auto problem = checkWall(shape, *stations)) return *problem;
  auto lattice = Sweeper(shape, *stations).run();
  return lattice ? completed(std::move(lattice).value(), kRemedy) : lattice;
}

Eigen::AlignedBox3d CurvedCylinderShape::box() const {
  // Curves stay within the hull of their control points.
  Eigen::AlignedBox3d box;
  for (const CurveChain* chain : {&curve, &secondRail}) {
    for (const auto& segment : *chain)
      for (const Vec3& point : segment) box.extend(point);
  }
  if (box.isEmpty()) return box;
  const double by = std::max(secondRail.empty() ? largest(halfWidth) : 0.0, largest(halfDepth));
  box.min().array() -= by;
  box.max().array() += by;
  return box;
}

}  // namespace modeling
