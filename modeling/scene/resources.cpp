#include "modeling/scene/resources.h"

#include <algorithm>
#include <cstdlib>

#include "modeling/scene/scene_codec.h"
#include "modeling/text/spelling.h"
#include "modeling/text/text_file.h"

namespace modeling {
namespace {

namespace fs = std::filesystem;

/// Where a program installed as PREFIX/bin or built as build/release/app finds resources.
std::vector<fs::path> foldersAboveProgram() {
  std::error_code error;
  std::vector<fs::path> folders;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  for (fs::path folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
    folders.push_back(folder / "resources");
    folders.push_back(folder / "share" / "smithereens");
  }
  return folders;
}

}  // namespace

fs::path resourcesFolder() {
  if (const char* chosen = std::getenv("SMITHEREENS_RESOURCES"); chosen != nullptr && *chosen != '\0')
    return chosen;
  std::error_code error;
  const fs::path source = SMITHEREENS_RESOURCES_DIR;
  if (fs::is_directory(source, error)) return source;
  for (const fs::path& folder : foldersAboveProgram()) {
    if (fs::is_directory(folder / "materials", error)) return folder;
  }
  return source;
}

bool comesWithProgram(const fs::path& scene) {
  std::error_code error;
  return !scene.empty() && fs::equivalent(scene.parent_path(), resourcesFolder() / "scenes", error);
}

std::vector<std::string> presetNames() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(resourcesFolder() / "materials", error)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

sim::Result<Material> presetMaterial(const std::string& name) {
  const std::vector<std::string> names = presetNames();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    return sim::Problem{"", "there is no material preset " + inQuotes(name), didYouMean(name, names)};
  }
  const fs::path file = resourcesFolder() / "materials" / (name + ".json");
  const sim::Result<std::string> text = readTextFile(file, kLargestText);
  if (!text) return text.problem();
  const sim::Result<JsonDocument> document = parseJson(*text, file.string());
  if (!document) return document.problem();
  JsonReader reader(*document);
  Material material;
  if (!Codec<Material>::read(reader, document->root, material, Rule{})) return *reader.problem();
  material.name = name;
  return material;
}

}  // namespace modeling
