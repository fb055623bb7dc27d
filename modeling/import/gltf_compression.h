#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "sim/base/result.h"

/// What makes glTF files small.
namespace modeling {

/// Rows of as many numbers each.
struct GltfNumbers {
  std::size_t width = 1;
  std::vector<double> values;

  std::size_t count() const { return values.size() / width; }
  double at(std::size_t row, std::size_t column) const { return values[row * width + column]; }
};

/// The bytes of a buffer view that meshoptimizer has compressed; `extension` says how.
sim::Result<std::string> unpackMeshopt(const nlohmann::json& extension, std::string_view bytes);

/// A primitive compressed by Draco.
struct DracoMesh {
  std::vector<std::int64_t> corners;    ///< three a triangle
  std::vector<GltfNumbers> attributes;  ///< as they were asked for
};
/// `wanted`: the numbers by which the file names attributes.
sim::Result<DracoMesh> unpackDraco(std::string_view bytes, const std::vector<std::uint32_t>& wanted);

}  // namespace modeling
