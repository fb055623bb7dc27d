#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "modeling/scene/scene.h"
#include "sim/base/result.h"
#include "sim/surface/surface_topology.h"

namespace modeling {

/// (u, v) of a face's four corners; a triangle repeats its third.
using FaceCoordinates = std::array<Eigen::Vector2f, 4>;

/// The parts' own parameters over the surface of a network: texture coordinates. A network does not keep
/// them; they are found by building the parts of its scene once more (without materials, which takes most of
/// the time).
class PartParameters {
 public:
  /// Files of parts are looked for in `folder`. A Problem when a part cannot be built, or the scene is not
  /// the network's.
  static sim::Result<PartParameters> create(const Scene& scene, const std::filesystem::path& folder,
                                            const sim::Network& network);

  /// Of a face of the network's surface. Of the parameters (u, v, w) in [0, 1]^3 of the part a face lies in,
  /// a face has the two along it: on the outside of a pot u and v, on its rim u and w. Where a part closes in
  /// itself, coordinates go on beyond 1 across the seam. Bodies drawn in place of loose nodes have (0, 0).
  FaceCoordinates textureCoordinates(const sim::SurfaceMesh& mesh, const sim::SurfaceMesh::Face& face) const;

 private:
  using CellParameters = std::array<Eigen::Vector3f, 8>;

  explicit PartParameters(const sim::Network& network) : network_(&network) {}

  const sim::Network* network_;
  std::vector<CellParameters> cells_;
};

}  // namespace modeling
