#pragma once

#include <filesystem>
#include <vector>

#include "modeling/scene/scene.h"

namespace modeling {

/// The files that a scene in the folder is made of beside its own: meshes, networks, the image of its light,
/// presets. Whether they are there or not.
std::vector<std::filesystem::path> filesOf(const Scene& scene, const std::filesystem::path& folder);

}  // namespace modeling
