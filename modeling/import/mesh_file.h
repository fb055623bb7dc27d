#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeling/shapes/mesh_shape.h"
#include "sim/base/result.h"
#include "sim/collider/triangle_mesh.h"

/// Meshes from other programs: OBJ, PLY, STL, glTF, FBX, Collada, read by assimp.
namespace modeling {

/// cm, z up.
struct MeshFile {
  sim::TriangleMesh mesh;
  std::string remark;  ///< how its unit and its axes were taken, and what was mended
};

/// Larger files are refused before they are read.
inline constexpr std::uintmax_t kLargestMeshFile = 128U << 20U;  ///< bytes
inline constexpr std::size_t kMostTriangles = 2'000'000;
/// How long, s, and with how much memory, bytes, a file may be read.
inline constexpr unsigned kLongestMeshReading = 60;
inline constexpr std::size_t kMeshReadingMemory = std::size_t{2} << 30U;

/// All triangles of the file as its nodes have them, corners in one place made one; a closed mesh that is
/// inside out is turned. The file is read by a process of its own, so that nothing a hostile file does to the
/// reader does anything to us. A Problem names the file.
sim::Result<MeshFile> loadMesh(const std::filesystem::path& folder, const MeshSource& source);

/// The endings of names of files that can be read, with their dots.
const std::vector<std::string>& meshFileEndings();

}  // namespace modeling
