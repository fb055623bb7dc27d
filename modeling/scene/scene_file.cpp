#include "modeling/scene/scene_file.h"

#include <algorithm>

#include "modeling/scene/scene_codec.h"
#include "modeling/text/json_path.h"
#include "modeling/text/json_text.h"
#include "modeling/text/text_file.h"

namespace modeling {
namespace {

constexpr std::string_view kVersionKey = "smithereens";

bool readVersion(JsonReader& reader, const JsonValue& root) {
  const Rule rule{kVersionKey, {}, true, {}, false};
  if (root.object() == nullptr) return reader.failKind(root, {"the scene", {}, true, {}, false}, "an object");
  const JsonValue* version = root.find(kVersionKey);
  if (version == nullptr) {
    return reader.fail(root.position, "this is no Smithereens scene: the key \"smithereens\" is missing",
                       "begin it with \"smithereens\": " + std::to_string(kSceneVersion));
  }
  int number = 0;
  if (!Codec<int>::read(reader, *version, number, rule)) return false;
  if (number == kSceneVersion) return true;
  const std::string remedy = number > kSceneVersion ? "open it with a newer Smithereens"
                                                    : "there has never been one; version 1 is the first";
  return reader.fail(version->position, "this is a scene of version " + std::to_string(number), remedy);
}

bool readRoot(JsonReader& reader, const JsonValue& root, Scene& scene) {
  if (!readVersion(reader, root)) return false;
  std::vector<std::string> keys = keysOf<Scene>();
  keys.emplace_back(kVersionKey);
  return reader.checkObject(root, {"the scene", {}, true, {}, false}, keys, retiredKeysOf<Scene>()) &&
         readFields(reader, root, scene);
}

}  // namespace

sim::Problem SceneFile::located(const sim::Problem& problem) const {
  const std::vector<std::string> steps = splitPath(problem.place);
  const std::vector<std::string> keys = keysOf<Scene>();
  // The path of a file is no path of the scene.
  if (steps.empty() || std::find(keys.begin(), keys.end(), steps.front()) == keys.end()) return problem;
  const JsonValue& value = deepestValue(document.root, problem.place);
  return {document.place(value.position), problem.what, problem.remedy};
}

sim::Result<SceneFile> parseScene(std::string_view text, const std::string& source,
                                  const std::vector<std::string>& settings) {
  sim::Result<JsonDocument> document = parseJson(text, source);
  if (!document) return document.problem();
  for (const std::string& setting : settings) {
    if (const sim::Status status = applySetting(*document, setting); !status) return status.problem();
  }
  return readScene(std::move(document).value());
}

sim::Result<SceneFile> readScene(JsonDocument document) {
  SceneFile file{{}, std::move(document), {}};
  JsonReader reader(file.document);
  if (!readRoot(reader, file.document.root, file.scene)) return *reader.problem();
  file.notes = reader.notes();
  if (const sim::Status status = checkScene(file.scene); !status) return file.located(status.problem());
  return file;
}

sim::Result<SceneFile> loadScene(const std::filesystem::path& file,
                                 const std::vector<std::string>& settings) {
  const sim::Result<std::string> text = readTextFile(file, kLargestText);
  if (!text) return text.problem();
  return parseScene(*text, file.string(), settings);
}

std::string writeScene(const Scene& scene) {
  Json root = Json::object();
  root[std::string(kVersionKey)] = kSceneVersion;
  writeFields(scene, Scene{}, root);
  return jsonText(root);
}

sim::Status saveScene(const Scene& scene, const std::filesystem::path& file) {
  return replaceTextFile(file, writeScene(scene));
}

Scene withoutPresets(Scene scene) {
  for (SceneMaterial& material : scene.materials) material.preset.clear();
  return scene;
}

std::string sceneSchema() {
  Json schema = {{"$schema", "https://json-schema.org/draft/2019-09/schema"}, {"title", "Smithereens scene"}};
  schema.update(objectSchema());
  schema["properties"][std::string(kVersionKey)] = {{"const", kSceneVersion},
                                                    {"description", "Version of the format."}};
  schema["required"].push_back(kVersionKey);
  addFieldSchemas<Scene>(schema);
  return jsonText(schema);
}

}  // namespace modeling
