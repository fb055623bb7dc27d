#pragma once

#include <filesystem>
#include <string_view>

#include "modeling/import/raw_mesh.h"

namespace modeling {

/// FBX and Collada, by assimp: what the file shows before anything moves, with rigs in the pose of their
/// bones and shape keys at their weights, in the file's own unit and axes. `bytes` are the file's; `ending`
/// is ".fbx" or
/// ".dae". A Problem where assimp can't read it, or says less of it than is needed to have it right.
Reading readByAssimp(const std::filesystem::path& file, std::string_view bytes, std::string_view ending);

}  // namespace modeling
