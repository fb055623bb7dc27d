#pragma once

#include "modeling/import/gltf_accessor.h"
#include "sim/base/types.h"

namespace modeling {

/// What a primitive of a glTF mesh is made of.
struct GltfPrimitive {
  std::uint64_t mode = 4;             ///< 0 points; 1 to 3 lines; 4 triangles; 5 a strip; 6 a fan
  std::vector<sim::Vec3> points;      ///< with shape keys applied
  std::vector<std::int64_t> corners;  ///< numbers of points
  std::vector<GltfNumbers> joints;    ///< four a point, as many sets as there are
  std::vector<GltfNumbers> weights;   ///< the same
};

/// `weights`: how much of each shape key there is.
sim::Result<GltfPrimitive> readPrimitive(GltfDocument& document, const GltfJson& primitive,
                                         const std::vector<double>& weights);

}  // namespace modeling
