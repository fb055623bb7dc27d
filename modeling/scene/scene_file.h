#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "modeling/scene/scene.h"
#include "modeling/text/json_document.h"

/// Scenes as text (docs/formats.md). Strict: a key that means nothing, a value of the wrong kind or out of
/// range, a name given to nothing is one Problem "FILE:LINE:COLUMN: what; how to mend it".
namespace modeling {

inline constexpr int kSceneVersion = 1;

/// A scene and the text it was read from.
struct SceneFile {
  Scene scene;
  JsonDocument document;
  std::vector<sim::Problem> notes;  ///< what the reader read over, such as keys that are used no more

  /// The problem with a scene path for a place ("parts[2].reach") moved to FILE:LINE:COLUMN; others as they
  /// are.
  sim::Problem located(const sim::Problem& problem) const;
};

sim::Result<SceneFile> readScene(JsonDocument document);
/// `settings` are laid over the text first, each "PATH=VALUE" (json_path.h).
sim::Result<SceneFile> parseScene(std::string_view text, const std::string& source,
                                  const std::vector<std::string>& settings = {});
sim::Result<SceneFile> loadScene(const std::filesystem::path& file,
                                 const std::vector<std::string>& settings = {});

/// parseScene(writeScene(scene)) is the scene again, exactly, provided checkScene() allows it and its presets
/// exist.
std::string writeScene(const Scene& scene);

/// Replaces the file in one step: after a crash the old one or the new one is there, whole.
sim::Status saveScene(const Scene& scene, const std::filesystem::path& file);

/// The same scene standing on its own: what presets give is written out.
Scene withoutPresets(Scene scene);

/// JSON Schema of the scene file, made from the same lists of keys as reader and writer.
std::string sceneSchema();

}  // namespace modeling
