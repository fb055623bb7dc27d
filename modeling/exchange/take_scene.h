#pragma once

#include <vector>

#include "modeling/scene/scene.h"
#include "sim/take/take.h"

namespace modeling {

/// The scene a take was made from. A take without one (made from a network by hand) has an empty scene; a
/// text that is no scene is a Problem. `settings` are laid over it as by parseScene().
sim::Result<Scene> sceneOf(const sim::TakeReader& take, const std::vector<std::string>& settings = {});

/// By material of the network, found by name; Look's defaults where the scene has no such material.
std::vector<Look> looksOf(const Scene& scene, const sim::Network& network);

}  // namespace modeling
