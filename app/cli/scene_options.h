#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "modeling/scene/scene_file.h"

namespace app {

/// The options that name a scene and change it before it is used.
struct SceneOptions {
  std::string scene;
  std::vector<std::string> settings;  ///< PATH=VALUE
  std::string until;  ///< these stand for settings, too, and are checked as such; "": not given
  std::string fps;
  std::string seed;
  std::string method;
  std::string step;
  std::string tolerance;

  /// The options, bound to this object, which has to outlive them.
  std::vector<Option> options();
  /// The scene with everything laid over it; its notes are told. A Problem in an option's value names the
  /// option.
  sim::Result<modeling::SceneFile> load() const;
};

}  // namespace app
