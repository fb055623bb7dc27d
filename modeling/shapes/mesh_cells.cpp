#include "modeling/shapes/mesh_cells.h"

#include <algorithm>
#include <cmath>

#include "modeling/shapes/cell_counts.h"
#include "modeling/shapes/resolution.h"
#include "sim/collider/triangle_mesh.h"

namespace modeling {

namespace {

using Cell = std::array<int, 3>;
using Shares = std::vector<std::uint8_t>;  ///< samples inside, one number a cell

/// Samples a cell, along each axis.
constexpr int kSamples = 3;
constexpr int kHalf = (kSamples * kSamples * kSamples + 1) / 2;
/// One byte each; the cells themselves are bounded by kMaxLatticeNodes.
constexpr double kMostGridCells = 2e8;
/// Passes over the grid; each adds what the one before made necessary. Few are ever needed.
constexpr int kMostPasses = 50;

/// Where a vertical line passes through the surface.
struct Crossing {
  std::uint64_t column;
  double height;
  int turn;  ///< 1: it leaves the mesh upwards; -1: it enters
};

class Sampler {
 public:
  Sampler(const sim::TriangleMesh& mesh, const CellGrid& grid) : mesh_(mesh), grid_(grid) {
    // Off the lattice of round numbers in which meshes are made, or lines would run along edges.
    shift_ = grid.cellSize / kSamples * Vec3(0.5 + 1.3e-4, 0.5 - 0.7e-4, 0.5);
  }

  /// See CellGrid.
  double onceShare() const { return often_ > 0.0 ? once_ / often_ : 1.0; }

  Shares run() {
    for (const auto& triangle : mesh_.triangles()) cross(triangle);
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& left, const Crossing& right) {
      return left.column != right.column ? left.column < right.column : left.height < right.height;
    });
    Shares shares(grid_.filled.size(), 0);
    for (std::size_t first = 0; first < crossings_.size();) {
      std::size_t last = first;
      while (last < crossings_.size() && crossings_[last].column == crossings_[first].column) ++last;
      fillColumn(first, last, shares);
      first = last;
    }
    return shares;
  }

 private:
  double spacing() const { return grid_.cellSize / kSamples; }
  std::uint64_t columnsAlong(std::size_t axis) const {
    return static_cast<std::uint64_t>(grid_.count[axis]) * kSamples;
  }

  /// First and last sample between two coordinates.
  std::pair<std::int64_t, std::int64_t> between(double low, double high, Eigen::Index axis) const {
    const double start = grid_.corner[axis] + shift_[axis];
    return {static_cast<std::int64_t>(std::ceil((low - start) / spacing())),
            static_cast<std::int64_t>(std::floor((high - start) / spacing()))};
  }

  void cross(const sim::TriangleMesh::Triangle& triangle) {
    const Vec3& a = mesh_.points()[triangle[0]];
    const Vec3 ab = mesh_.points()[triangle[1]] - a;
    const Vec3 ac = mesh_.points()[triangle[2]] - a;
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    if (area == 0.0) return;
    const auto [x0, x1] =
        between(a.x() + std::min({0.0, ab.x(), ac.x()}), a.x() + std::max({0.0, ab.x(), ac.x()}), 0);
    const auto [y0, y1] =
        between(a.y() + std::min({0.0, ab.y(), ac.y()}), a.y() + std::max({0.0, ab.y(), ac.y()}), 1);
    for (std::int64_t y = y0; y <= y1; ++y) {
      for (std::int64_t x = x0; x <= x1; ++x) {
        const double dx = grid_.corner.x() + shift_.x() + static_cast<double>(x) * spacing() - a.x();
        const double dy = grid_.corner.y() + shift_.y() + static_cast<double>(y) * spacing() - a.y();
        const double s = (dx * ac.y() - dy * ac.x()) / area;
        const double t = (ab.x() * dy - ab.y() * dx) / area;
        if (s < 0.0 || t < 0.0 || s + t > 1.0) continue;
        const auto column = static_cast<std::uint64_t>(y) * columnsAlong(0) + static_cast<std::uint64_t>(x);
        crossings_.push_back({column, a.z() + s * ab.z() + t * ac.z(), area > 0.0 ? 1 : -1});
      }
    }
  }

  /// Inside is where more surfaces above are left than entered.
  void fillColumn(std::size_t first, std::size_t last, Shares& shares) {
    int left = 0;
    for (std::size_t i = first; i < last; ++i) left += crossings_[i].turn;
    if (left != 0) return;  // the line ran along an edge; its neighbours decide
    const std::uint64_t column = crossings_[first].column;
    const auto x = static_cast<int>(column % columnsAlong(0) / kSamples);
    const auto y = static_cast<int>(column / columnsAlong(0) / kSamples);
    int winding = 0;
    for (std::size_t i = last; i-- > first + 1;) {
      winding += crossings_[i].turn;
      if (winding <= 0) continue;
      const auto [from, to] = between(crossings_[i - 1].height, crossings_[i].height, 2);
      for (std::int64_t z = from; z <= to; ++z) ++shares[grid_.index({x, y, static_cast<int>(z / kSamples)})];
      const double height = crossings_[i].height - crossings_[i - 1].height;
      once_ += height;
      often_ += winding * height;
    }
  }

  const sim::TriangleMesh& mesh_;
  const CellGrid& grid_;
  Vec3 shift_;
  std::vector<Crossing> crossings_;
  double once_ = 0.0, often_ = 0.0;  ///< cm: of all lines, what is inside, and that times how often
};

/// Of the eight cells round a corner, those that can be reached from the first of them by faces, as bits.
unsigned reachable(unsigned cells) {
  unsigned reached = cells & (~cells + 1U);
  for (unsigned before = 0; before != reached;) {
    before = reached;
    for (unsigned cell = 0; cell < 8; ++cell) {
      if (((reached >> cell) & 1U) == 0) continue;
      for (const unsigned axis : {1U, 2U, 4U}) reached |= cells & (1U << (cell ^ axis));
    }
  }
  return reached;
}

/// The surface of the cells is one sheet at this corner.
bool isSheet(unsigned cells) {
  const unsigned others = ~cells & 0xffU;
  return (cells == 0 || reachable(cells) == cells) && (others == 0 || reachable(others) == others);
}

class Mender {
 public:
  Mender(const Shares& shares, CellGrid& grid) : shares_(shares), grid_(grid) {}

  std::size_t run() {
    std::size_t added = 0;
    for (int pass = 0; pass < kMostPasses; ++pass) {
      const std::size_t before = added;
      for (int z = 1; z < grid_.count[2]; ++z) {
        for (int y = 1; y < grid_.count[1]; ++y) {
          for (int x = 1; x < grid_.count[0]; ++x) added += mend({x, y, z});
        }
      }
      if (added == before) break;
    }
    return added;
  }

 private:
  static Cell cellAt(const Cell& corner, unsigned which) {
    return {corner[0] - 1 + static_cast<int>(which & 1U),
            corner[1] - 1 + static_cast<int>((which >> 1U) & 1U),
            corner[2] - 1 + static_cast<int>(which >> 2U)};
  }

  std::size_t mend(const Cell& corner) {
    unsigned cells = 0;
    for (unsigned which = 0; which < 8; ++which)
      cells |= grid_.isFilled(cellAt(corner, which)) ? 1U << which : 0U;
    std::size_t added = 0;
    while (!isSheet(cells)) {
      int best = -1;
      unsigned chosen = 0;
      for (unsigned which = 0; which < 8; ++which) {
        if (((cells >> which) & 1U) != 0) continue;
        const int share = shares_[grid_.index(cellAt(corner, which))];
        if (share > best) {
          best = share;
          chosen = which;
        }
      }
      cells |= 1U << chosen;
      grid_.filled[grid_.index(cellAt(corner, chosen))] = 1;
      ++added;
    }
    return added;
  }

  const Shares& shares_;
  CellGrid& grid_;
};

}  // namespace

sim::Result<CellGrid> cellsOf(const sim::TriangleMesh& mesh, double cellSize) {
  const Eigen::AlignedBox3d box = mesh.box();
  CellGrid grid;
  grid.cellSize = cellSize;
  double cells = 1.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    // An empty cell at least on either side, and one more for those that are added.
    const double along = std::max(1.0, std::ceil(box.diagonal()[axis] / cellSize - 1e-9)) + 4.0;
    cells *= along;
    if (!(cells < kMostGridCells)) {
      const Vec3 counts = box.diagonal() / cellSize;
      return sim::Problem{"cellSize",
                          "the box of this mesh would hold " + roughCount(counts.prod()) + " cells so small",
                          "use larger cells"};
    }
    grid.count[static_cast<std::size_t>(axis)] = static_cast<int>(along);
    grid.corner[axis] = box.center()[axis] - 0.5 * along * cellSize;
  }
  grid.filled.assign(static_cast<std::size_t>(cells), 0);
  Sampler sampler(mesh, grid);
  const Shares shares = sampler.run();
  grid.onceShare = sampler.onceShare();
  std::size_t count = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    grid.filled[i] = shares[i] >= kHalf ? 1 : 0;
    count += grid.filled[i];
  }
  grid.added = Mender(shares, grid).run();
  if (count + grid.added > kMaxLatticeNodes)
    return sim::Problem{"cellSize", "this would be " + std::to_string(count + grid.added) + " cells",
                        "use larger cells"};
  return grid;
}

}  // namespace modeling
