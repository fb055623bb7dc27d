#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/result.h"
#include "sim/base/types.h"

namespace modeling {

/// What a file says, in its own units and axes.
struct RawMesh {
  std::vector<sim::Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of points
  double unit = 0.0;                                    ///< cm; 0: the file does not say
  std::uint32_t up = 0;                                 ///< 1: y, 2: z; 0: the file does not say
};

/// Reads the file by assimp in a process of its own, with bounded time and memory. A Problem when it is none
/// of the formats, damaged, or too much.
sim::Result<RawMesh> readMeshApart(const std::filesystem::path& file);

}  // namespace modeling
