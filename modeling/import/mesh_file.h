#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeling/import/attendance.h"
#include "modeling/shapes/mesh_shape.h"
#include "sim/base/result.h"
#include "sim/collider/triangle_mesh.h"

/// Meshes from other programs: OBJ, PLY, STL, glTF, FBX, Collada.
namespace modeling {

/// cm, z up.
struct MeshFile {
  sim::TriangleMesh mesh;
  std::string remark;  ///< how its unit and its axes were taken, and what was mended or passed over
};

/// All triangles of the file as its nodes have them, corners in one place made one; closed bodies that are
/// inside out are turned. The file is read by a process of its own (reading_process.h). A Problem has no
/// place, and names the file as the source does; a mesh that nothing can be made of is one, too
/// (sim::checkSurface).
sim::Result<MeshFile> loadMesh(const std::filesystem::path& folder, const MeshSource& source,
                               const Attendance& attendance = {});

/// The endings of names of files that can be read, with their dots.
const std::vector<std::string>& meshFileEndings();

}  // namespace modeling
