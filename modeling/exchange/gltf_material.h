#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "modeling/material/glass.h"
#include "modeling/material/material.h"

namespace modeling {

/// A look as a material of glTF: colour and roughness, which every program knows, and the coat of a glaze
/// (KHR_materials_clearcoat) or the clearness of glass (KHR_materials_transmission, KHR_materials_ior,
/// KHR_materials_volume), which programs that do not know them leave out. Glass takes its colour from how far
/// light goes in it, as in pictures (kGlassDepth), not from its surface.
/// `inside`: what breaking bared, in the inside colour, without glaze. `thickness`: of the walls that are of
/// it, cm: programs that trace no rays take it for the way through glass.
nlohmann::ordered_json gltfMaterial(const std::string& name, const Look& look, bool inside, double thickness);

/// The extensions that a file with such a material states as used.
std::vector<std::string> gltfMaterialExtensions(const nlohmann::ordered_json& material);

}  // namespace modeling
