#pragma once

#include <filesystem>
#include <string_view>

#include "modeling/import/raw_mesh.h"

namespace modeling {

/// glTF 2.0, .gltf and .glb: the triangles of its scene as a viewer first shows them, with shape keys at
/// their weights, rigs in the pose of their nodes, and instances. Metres, y up. Buffers are looked for in
/// `folder`.
Reading readGltf(std::string_view bytes, const std::filesystem::path& folder);

}  // namespace modeling
