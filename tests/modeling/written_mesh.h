#pragma once

#include <fstream>
#include <string>

#include "modeling/import/mesh_file.h"
#include "tests/sim/take_sample.h"

namespace tests {

/// Writes a file of its own and reads it as a mesh.
inline sim::Result<modeling::MeshFile> meshOf(const std::string& name, const std::string& bytes,
                                              modeling::MeshUnit unit = modeling::MeshUnit::guess,
                                              modeling::MeshUp up = modeling::MeshUp::guess) {
  const ScratchFolder scratch;
  std::ofstream(scratch.file(name), std::ios::binary) << bytes;
  return modeling::loadMesh(scratch.file(name).parent_path(), {name, unit, up});
}

/// The one line of its problem, or "".
inline std::string problemOf(const std::string& name, const std::string& bytes) {
  const auto file = meshOf(name, bytes);
  return file.ok() ? "" : file.problem().line();
}

/// Its extent, cm.
inline sim::Vec3 sizeOf(const modeling::MeshFile& file) {
  return file.mesh.box().diagonal();
}

}  // namespace tests
