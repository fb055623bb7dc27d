#include "modeling/exchange/part_parameters.h"

#include <algorithm>

#include <Eigen/LU>

#include "modeling/glue/glue.h"
#include "modeling/scene/build_parts.h"

namespace modeling {

namespace {

using Corners = std::array<Vec3, 8>;

double weight(const Vec3& at, unsigned corner) {
  double product = 1.0;
  for (unsigned axis = 0; axis < 3; ++axis) product *= (corner >> axis & 1U) != 0 ? at[axis] : 1.0 - at[axis];
  return product;
}

Vec3 placed(const Corners& corners, const Vec3& at) {
  Vec3 sum = Vec3::Zero();
  for (unsigned c = 0; c < 8; ++c) sum += weight(at, c) * corners[c];
  return sum;
}

/// Where in a cell a point lies, by Newton's method; cells are near enough to cubes for a few rounds.
Vec3 localCoordinates(const Corners& corners, const Vec3& point) {
  Vec3 at = Vec3::Constant(0.5);
  for (int round = 0; round < 8; ++round) {
    Eigen::Matrix3d slopes;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 low = at, high = at;
      low[axis] = 0.0;
      high[axis] = 1.0;
      slopes.col(axis) = placed(corners, high) - placed(corners, low);
    }
    if (!(std::abs(slopes.determinant()) > 0.0)) break;
    const Vec3 step = slopes.inverse() * (point - placed(corners, at));
    at = (at + step).cwiseMax(-1.0).cwiseMin(2.0);
    if (step.norm() < 1e-9) break;
  }
  return at;
}

/// Values on both sides of a seam made to follow one another. Where a part closes in itself, its last column
/// of cells has the values 0 and 1 - 1/n, n at least 3; only where it does not is there a 1.
template <class Parameters>
void closeSeams(Parameters& corners) {
  constexpr float kLeastSpread = 0.6F;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [lowest, highest] = std::minmax_element(
        corners.begin(), corners.end(), [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    const float high = (*highest)[axis];
    if (high > 0.999F || high - (*lowest)[axis] < kLeastSpread) continue;
    for (auto& corner : corners) {
      if (corner[axis] < high - 0.5F) corner[axis] += 1.0F;
    }
  }
}

/// The local axis across a face: along which its corners spread least, against its area.
int acrossAxis(const std::array<Vec3, 4>& at) {
  const Vec3 area = (at[2] - at[0]).cross(at[3] - at[1]) + (at[1] - at[0]).cross(at[2] - at[0]);
  Eigen::Index across = 0;
  area.cwiseAbs().maxCoeff(&across);
  return static_cast<int>(across);
}

}  // namespace

sim::Result<PartParameters> PartParameters::create(const Scene& scene, const std::filesystem::path& folder,
                                                   const sim::Network& network) {
  const auto built = buildParts(scene, folder);
  if (!built) return built.problem();
  const auto glued = glue(glueParts(built->parts), glueSettings(scene, built->parts));
  if (!glued) return glued.problem();
  PartParameters parameters(network);
  for (std::size_t p = 0; p < built->parts.size(); ++p) {
    const Lattice& lattice = built->parts[p].lattice;
    const auto& dropped = glued->droppedCells[p];
    for (sim::CellIndex cell = 0; cell < lattice.cells.size(); ++cell) {
      if (std::binary_search(dropped.begin(), dropped.end(), cell)) continue;
      CellParameters& corners = parameters.cells_.emplace_back();
      for (std::size_t c = 0; c < 8; ++c)
        corners[c] = lattice.parameters[lattice.cells[cell][c]].cast<float>();
      closeSeams(corners);
    }
  }
  if (parameters.cells_.size() != network.cellCount()) {
    return sim::Problem{"", "the scene makes other cells than the network has",
                        "simulate the scene again, or leave texture coordinates out"};
  }
  return parameters;
}

FaceCoordinates PartParameters::textureCoordinates(const sim::SurfaceMesh& mesh,
                                                   const sim::SurfaceMesh::Face& face) const {
  FaceCoordinates coordinates;
  coordinates.fill(Eigen::Vector2f::Zero());
  if (face.cell == sim::kNone) return coordinates;
  Corners corners;
  for (std::size_t c = 0; c < 8; ++c) corners[c] = network_->positions[network_->cells[face.cell][c]];
  const CellParameters& parameters = cells_[face.cell];
  std::array<Vec3, 4> at;
  std::array<Eigen::Vector3f, 4> values;
  for (std::size_t c = 0; c < 4; ++c) {
    at[c] = localCoordinates(corners, mesh.restPoints[face.points[c]]);
    values[c].setZero();
    for (unsigned corner = 0; corner < 8; ++corner)
      values[c] += static_cast<float>(weight(at[c], corner)) * parameters[corner];
  }
  const int across = acrossAxis(at);
  // Of the parameters, the one that varies most across the face is left out.
  Eigen::Vector3f change = Eigen::Vector3f::Zero();
  for (unsigned corner = 0; corner < 8; ++corner)
    change += ((corner >> across & 1U) != 0 ? 0.25F : -0.25F) * parameters[corner];
  Eigen::Index left = 0;
  change.cwiseAbs().maxCoeff(&left);
  for (std::size_t c = 0; c < 4; ++c)
    coordinates[c] = {values[c][left == 0 ? 1 : 0], values[c][left == 2 ? 1 : 2]};
  return coordinates;
}

}  // namespace modeling
