#include "modeling/shapes/disc.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace modeling {
namespace {

/// Cells from the centre to the circle for each cell along a core block: found best for a quarter sector,
/// whose circle has pi/4 radius / core wide cells.
constexpr double kRadialCells = 1.4;

/// How far a core block's far corner stands out, as a share of the rings' width. At 0.15 the angles about it
/// are near 120 degrees and all edges within 16 % below and 25 % above their mean.
constexpr double kCornerShare = 0.15;

/// One sector in the plane: core nodes (a, b) with a along its first side and b along its second, and ring
/// nodes (t, ring) with t around from the first side to the second. All three blocks are bilinear between
/// their corners, but for the circle.
class Sector {
 public:
  explicit Sector(const DiscLayout& layout)
      : core_(layout.core), rings_(layout.rings), angle_(layout.angle / layout.sectors) {
    const double side = static_cast<double>(core_) / (core_ + rings_);
    first_ = polar(side, 0.0);
    second_ = polar(side, angle_);
    corner_ = polar(side + kCornerShare * (1.0 - side), 0.5 * angle_);
  }

  Vec2 core(int a, int b) const {
    const double x = static_cast<double>(a) / core_, y = static_cast<double>(b) / core_;
    return x * (1.0 - y) * first_ + (1.0 - x) * y * second_ + x * y * corner_;
  }
  Vec2 ring(int t, int ringOut) const {
    const double outward = static_cast<double>(ringOut + 1) / rings_;
    const Vec2 inner = t <= core_ ? core(core_, t) : core(2 * core_ - t, core_);
    return (1.0 - outward) * inner + outward * polar(1.0, angle_ * t / (2 * core_));
  }

 private:
  static Vec2 polar(double radius, double angle) {
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }

  int core_, rings_;
  double angle_;
  Vec2 first_, second_, corner_;
};

/// Numbers the core nodes of all sectors by rows of one square grid.
class CoreNumbering {
 public:
  explicit CoreNumbering(const DiscLayout& layout) : layout_(layout) {
    for (int sector = 0; sector < layout.sectors; ++sector)
      for (int a = 0; a <= layout.core; ++a)
        for (int b = 0; b <= layout.core; ++b)
          if (owns(sector, a, b)) entries.push_back(entry(sector, a, b));
    std::sort(entries.begin(), entries.end(),
              [](const Entry& p, const Entry& q) { return std::tie(p.y, p.x) < std::tie(q.y, q.x); });
    const auto side = static_cast<std::size_t>(layout.core) + 1;
    ids_.resize(static_cast<std::size_t>(layout.sectors) * side * side);
    for (std::size_t id = 0; id < entries.size(); ++id)
      ids_[key(entries[id].sector, entries[id].a, entries[id].b)] = static_cast<std::uint32_t>(id);
  }

  struct Entry {
    int y, x, sector, a, b;
  };
  std::vector<Entry> entries;

  std::uint32_t id(int sector, int a, int b) const {
    if (a == 0 && b == 0) return ids_[key(0, 0, 0)];
    if (owns(sector, a, b)) return ids_[key(sector, a, b)];
    return ids_[key((sector + 1) % layout_.sectors, b, 0)];
  }

 private:
  /// A sector's second side is the next one's first.
  bool owns(int sector, int a, int b) const {
    if (a > 0) return true;
    if (b == 0) return sector == 0;
    return sector + 1 == layout_.sectors && !layout_.full();
  }
  std::size_t key(int sector, int a, int b) const {
    const auto side = static_cast<std::size_t>(layout_.core) + 1;
    return (static_cast<std::size_t>(sector) * side + static_cast<std::size_t>(a)) * side +
           static_cast<std::size_t>(b);
  }
  static Entry entry(int sector, int a, int b) {
    switch (sector % 4) {
      case 0:
        return {b, a, sector, a, b};
      case 1:
        return {a, -b, sector, a, b};
      case 2:
        return {-b, -a, sector, a, b};
      // The open side of a fourth sector lies on the first one's row, and gets a row of its own.
      default:
        return {a > 0 ? -a : std::numeric_limits<int>::max(), b, sector, a, b};
    }
  }

  DiscLayout layout_;
  std::vector<std::uint32_t> ids_;
};

Vec2 toPolar(const Vec2& point, int sector, const DiscLayout& layout) {
  const double radius = point.norm();
  const double within = radius > 0.0 ? std::atan2(point.y(), point.x()) * layout.sectors / layout.angle : 0.0;
  const double share = (sector + std::clamp(within, 0.0, 1.0)) / layout.sectors;
  return {std::min(radius, 1.0), radius > 0.0 ? share : 0.0};
}

void addCore(Disc& disc, const Sector& sector, const CoreNumbering& numbering) {
  int row = std::numeric_limits<int>::min();
  for (const auto& entry : numbering.entries) {
    if (entry.y != row) disc.rows.push_back(static_cast<std::uint32_t>(disc.points.size()));
    row = entry.y;
    disc.points.push_back(toPolar(sector.core(entry.a, entry.b), entry.sector, disc.layout));
  }
  disc.coreNodes = disc.points.size();
  for (int s = 0; s < disc.layout.sectors; ++s)
    for (int a = 0; a < disc.layout.core; ++a)
      for (int b = 0; b < disc.layout.core; ++b)
        disc.quads.push_back({numbering.id(s, a, b), numbering.id(s, a, b + 1), numbering.id(s, a + 1, b),
                              numbering.id(s, a + 1, b + 1)});
}

void addRings(Disc& disc, const Sector& sector, const CoreNumbering& numbering) {
  const int core = disc.layout.core, around = disc.layout.nodesAround();
  const auto node = [&](int i, int ring) -> std::uint32_t {
    const int s = std::min(i / (2 * core), disc.layout.sectors - 1), t = i - s * 2 * core;
    if (ring < 0) return t <= core ? numbering.id(s, core, t) : numbering.id(s, 2 * core - t, core);
    return static_cast<std::uint32_t>(disc.ringStart(ring)) + static_cast<std::uint32_t>(i % around);
  };
  for (int ring = 0; ring < disc.layout.rings; ++ring) {
    disc.rows.push_back(static_cast<std::uint32_t>(disc.points.size()));
    for (int i = 0; i < around; ++i) {
      const int s = std::min(i / (2 * core), disc.layout.sectors - 1);
      disc.points.push_back(toPolar(sector.ring(i - s * 2 * core, ring), s, disc.layout));
    }
    for (int i = 0; i < disc.layout.cellsAround(); ++i)
      disc.quads.push_back({node(i, ring - 1), node(i + 1, ring - 1), node(i, ring), node(i + 1, ring)});
  }
}

}  // namespace

bool DiscLayout::full() const {
  return angle > 2.0 * std::numbers::pi - 1e-9;
}

int flatDiscRings(int core) {
  return std::max(1, static_cast<int>(std::lround(kRadialCells * core)) - core);
}

int discSectors(double angle) {
  const double most = 100.0 * std::numbers::pi / 180.0;
  return std::max(1, static_cast<int>(std::ceil(angle / most - 1e-9)));
}

Disc divideDisc(const DiscLayout& layout) {
  const Sector sector(layout);
  const CoreNumbering numbering(layout);
  Disc disc;
  disc.layout = layout;
  addCore(disc, sector, numbering);
  addRings(disc, sector, numbering);
  return disc;
}

double discNodeCount(const DiscLayout& layout) {
  const double core = layout.core, sides = layout.full() ? 0.0 : core;
  return 1.0 + layout.sectors * core * (core + 1.0) + sides +
         layout.rings * static_cast<double>(layout.nodesAround());
}

}  // namespace modeling
