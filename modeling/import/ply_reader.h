#pragma once

#include <string_view>

#include "modeling/import/raw_mesh.h"

namespace modeling {

/// PLY as text and binary of either order of bytes, with any types: faces, or strips of triangles. Other
/// elements and properties are passed over. There is no reader of it that Debian 12 and 13 both have.
Reading readPly(std::string_view bytes);

}  // namespace modeling
