#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeling/material/material.h"
#include "sim/base/result.h"

namespace modeling {

/// Where scenes/ and materials/ are: the environment variable SMITHEREENS_RESOURCES; else the folder this
/// program was built from; else resources/ beside or above the program's own file. The first that exists.
std::filesystem::path resourcesFolder();

/// True: a scene that comes with the program, which is there to start from.
bool comesWithProgram(const std::filesystem::path& scene);

/// Names of all presets, in alphabetical order.
std::vector<std::string> presetNames();

/// resources/materials/NAME.json: one object with the keys of a scene's material. The value's name is `name`.
sim::Result<Material> presetMaterial(const std::string& name);

}  // namespace modeling
