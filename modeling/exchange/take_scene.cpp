#include "modeling/exchange/take_scene.h"

#include <algorithm>
#include <utility>

#include "modeling/scene/scene_file.h"

namespace modeling {

sim::Result<Scene> sceneOf(const sim::TakeReader& take, const std::vector<std::string>& settings) {
  if (take.header().scene.empty()) return Scene{};
  auto file = parseScene(take.header().scene, "the take's scene", settings);
  if (!file) return file.problem();
  return std::move(file->scene);
}

std::vector<Look> looksOf(const Scene& scene, const sim::Network& network) {
  std::vector<Look> looks;
  for (const sim::Material& material : network.materials) {
    const auto named = [&](const SceneMaterial& other) { return other.name == material.name; };
    const auto found = std::find_if(scene.materials.begin(), scene.materials.end(), named);
    looks.push_back(found == scene.materials.end() ? Look{} : found->values.look);
  }
  return looks;
}

}  // namespace modeling
