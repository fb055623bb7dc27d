#pragma once

#include <string_view>

#include "modeling/import/raw_mesh.h"

namespace modeling {

/// Wavefront OBJ: corners, and faces of three corners and more. Textures, normals, materials and groups do
/// not count, whether they are there or not. A Problem names the line.
Reading readObj(std::string_view text);

}  // namespace modeling
