#include "app/cli/scene_options.h"

#include <array>

#include "app/cli/command.h"
#include "sim/methods/method_names.h"
namespace app {
namespace {

struct Shorthand {
  const char* option;
  const char* path;
  std::string SceneOptions::*value;
  const char* before = "";  ///< of the value, to make JSON of it
  const char* after = "";
};

constexpr std::array<Shorthand, 6> kShorthands{
    {{"--until", "output.duration", &SceneOptions::until},
     {"--fps", "output.fps", &SceneOptions::fps},
     {"--seed", "solver.seed", &SceneOptions::seed},
     {"--method", "solver.method", &SceneOptions::method},
     {"--step", "solver.step", &SceneOptions::step},
     {"--tolerance", "solver.step", &SceneOptions::tolerance, R"({"tolerance":)", "}"}}};

std::string listOf(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

std::vector<Option> SceneOptions::options() {
  return {{.name = "scene", .target = &scene, .help = "NAME.scene.json", .required = true},
          {"--until", &until, "Seconds to simulate, in place of output.duration"},
          {"--fps", &fps, "Frames a second, in place of output.fps"},
          {"--seed", &seed, "Of the random thresholds"},
          {"--method", &method, "One of " + listOf(sim::methodNames())},
          {"--step", &step, "Seconds, or auto"},
          {.name = "--tolerance",
           .target = &tolerance,
           .help = "Error of strain a shortest swing that the step keeps to",
           .excludes = "--step"},
          {.name = "--set",
           .target = &settings,
           .help = "PATH=VALUE: change a value of the scene, e.g. environment.gravity=[0,0,-4905]",
           .oneAtATime = true}};
}

sim::Result<modeling::SceneFile> SceneOptions::load() const {
  std::vector<std::string> all = settings;
  for (const Shorthand& shorthand : kShorthands) {
    const std::string& value = this->*shorthand.value;
    if (!value.empty())
      all.push_back(std::string(shorthand.path) + "=" + shorthand.before + value + shorthand.after);
  }
  sim::Result<modeling::SceneFile> file = modeling::loadScene(scene, all);
  if (file) {
    tell(file->notes);
    return file;
  }
  sim::Problem problem = file.problem();
  for (const Shorthand& shorthand : kShorthands) {
    const std::string source = std::string("--set ") + shorthand.path;
    if (!(this->*shorthand.value).empty() && problem.place.starts_with(source)) {
      problem.place.replace(0, source.size(), shorthand.option);
    }
  }
  return problem;
}

}  // namespace app
