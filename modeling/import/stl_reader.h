#pragma once

#include <string_view>

#include "modeling/import/raw_mesh.h"

namespace modeling {

/// STL, text or binary, by what is in it: the heads of many binary files begin with "solid", too. Solids
/// without triangles are nothing, and bytes behind the last triangle are passed over, with a note.
Reading readStl(std::string_view bytes);

}  // namespace modeling
