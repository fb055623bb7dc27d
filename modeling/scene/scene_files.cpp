#include "modeling/scene/scene_files.h"

#include <variant>

#include "modeling/scene/resources.h"

namespace modeling {
namespace {

template <class Form>
std::string fileOf(const Form& form) {
  if constexpr (requires { form.file; }) {
    return form.file;
  } else {
    return {};
  }
}

}  // namespace

std::vector<std::filesystem::path> filesOf(const Scene& scene, const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](const std::string& file) {
    if (!file.empty()) files.push_back(folder / file);
  };
  const auto nameIn = [](const auto& form) { return fileOf(form); };
  for (const Part& part : scene.parts) add(std::visit(nameIn, part.shape));
  for (const SceneCollider& collider : scene.environment.colliders) add(std::visit(nameIn, collider.form));
  add(scene.view.picture.environment.image);
  for (const SceneMaterial& material : scene.materials) {
    if (!material.preset.empty())
      files.push_back(resourcesFolder() / "materials" / (material.preset + ".json"));
  }
  return files;
}

}  // namespace modeling
