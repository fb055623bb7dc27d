#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "modeling/material/material.h"

namespace modeling {

/// A look as a material of glTF: colour and roughness, which every program knows, and the coat of a glaze
/// (KHR_materials_clearcoat) or the clearness of glass (KHR_materials_transmission, KHR_materials_ior), which
/// programs that do not know them leave out.
/// `inside`: what breaking bared, in the inside colour, without glaze.
nlohmann::ordered_json gltfMaterial(const std::string& name, const Look& look, bool inside);

/// The extensions that a file with such a material states as used.
std::vector<std::string> gltfMaterialExtensions(const nlohmann::ordered_json& material);

}  // namespace modeling
