#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "modeling/scene/scene.h"

namespace modeling {

/// What could be read of a damaged scene.
struct SalvagedScene {
  Scene scene;
  std::vector<sim::Problem>
      faults;  ///< what was left out and why, in the order of being found; empty: nothing was
  std::vector<sim::Problem> notes;  ///< as of SceneFile
};

/// Reads a scene as loadScene() does, but leaves out what cannot be read: a part, gluing, collider, track or
/// material with a fault and, because they lean on it, what names it; else the whole section. A text that
/// stops or goes wrong in its middle is read up to there. A Problem where nothing can be made of it: it is no
/// scene, or no part is left.
sim::Result<SalvagedScene> salvageScene(std::string_view text, const std::string& source);
sim::Result<SalvagedScene> salvageScene(const std::filesystem::path& file);

}  // namespace modeling
