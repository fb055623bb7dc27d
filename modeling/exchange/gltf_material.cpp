#include "modeling/exchange/gltf_material.h"

#include <cmath>
#include <utility>

#include "modeling/exchange/gltf_axes.h"

namespace modeling {

namespace {

using Json = nlohmann::ordered_json;

/// The body under a glaze and biscuit scatter like chalk; what breaks of glass is smooth.
constexpr double kBodyRoughness = 0.6;
constexpr double kBrokenRoughness = 0.9;
constexpr double kGlazeRoughness = 0.04;
constexpr double kGlassRoughness = 0.0;
constexpr double kGlassRefraction = 1.5;

double linear(double sRgb) {
  return sRgb <= 0.04045 ? sRgb / 12.92 : std::pow((sRgb + 0.055) / 1.055, 2.4);
}

double roughnessOf(const Look& look, bool inside) {
  if (look.finish == Finish::glass) return kGlassRoughness;
  return inside || look.finish == Finish::matte ? kBrokenRoughness : kBodyRoughness;
}

}  // namespace

Json gltfMaterial(const std::string& name, const Look& look, bool inside, double thickness) {
  const bool glass = look.finish == Finish::glass;
  const Colour& colour = inside && !glass ? look.inside : look.outside;
  const Json light = {linear(colour[0]), linear(colour[1]), linear(colour[2])};
  Json base = glass ? Json{1.0, 1.0, 1.0} : light;
  base.push_back(1.0);
  Json material = {{"name", name},
                   {"pbrMetallicRoughness",
                    {{"baseColorFactor", std::move(base)},
                     {"metallicFactor", 0.0},
                     {"roughnessFactor", roughnessOf(look, inside)}}}};
  if (glass) {
    material["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", 1.0}}},
                              {"KHR_materials_ior", {{"ior", kGlassRefraction}}},
                              {"KHR_materials_volume",
                               {{"thicknessFactor", kMetresPerCentimetre * thickness},
                                {"attenuationDistance", kMetresPerCentimetre * kGlassDepth},
                                {"attenuationColor", light}}}};
  } else if (look.finish == Finish::glazed && !inside && look.glaze > 0.0) {
    material["extensions"] = {
        {"KHR_materials_clearcoat",
         {{"clearcoatFactor", look.glaze}, {"clearcoatRoughnessFactor", kGlazeRoughness}}}};
  }
  return material;
}

std::vector<std::string> gltfMaterialExtensions(const Json& material) {
  std::vector<std::string> names;
  const auto found = material.find("extensions");
  if (found == material.end()) return names;
  for (const auto& extension : found->items()) names.push_back(extension.key());
  return names;
}

}  // namespace modeling
