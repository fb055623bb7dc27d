#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/cli/waiting.h"
#include "modeling/exchange/lammps_import.h"
#include "modeling/files/output_guard.h"
#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "modeling/scene/scene_files.h"

namespace app {

namespace {

struct ImportOptions {
  std::string dump;
  std::string bonds;
  std::string scene;
  std::vector<std::string> settings;
  std::string take;
  bool force = false;
};

/// Beside the dump of nodes, as the exported input writes it; "" where there is none.
std::filesystem::path bondsOf(const ImportOptions& options) {
  if (!options.bonds.empty()) return options.bonds;
  std::filesystem::path beside = options.dump;
  beside.replace_extension(".bonds");
  return std::filesystem::exists(beside) ? beside : std::filesystem::path();
}

sim::Status checkOutputs(const ImportOptions& options, const modeling::Scene& scene) {
  modeling::OutputGuard guard(options.force);
  guard.reads({options.dump, bondsOf(options), options.scene});
  guard.reads(modeling::filesOf(scene, std::filesystem::path(options.scene).parent_path()));
  guard.writes(options.take, modeling::kinds::take);
  return guard.check();
}

ExitStatus import(const ImportOptions& options) {
  const auto file = modeling::loadScene(options.scene, options.settings);
  if (!file) return complain(file.problem());
  tell(file->notes);
  if (const sim::Status safe = checkOutputs(options, file->scene); !safe) return complain(safe.problem());
  auto built = modeling::build(file->scene, std::filesystem::path(options.scene).parent_path(),
                               Waiting().attendance());
  if (!built) return complain(file->located(built.problem()));
  const double expected = std::max(1.0, file->scene.output.duration * file->scene.output.fps + 1.0);
  Progress progress("import");
  const auto show = [&](std::size_t frames) {
    progress.show(std::min(1.0, static_cast<double>(frames) / expected));
    return true;
  };
  const auto frames = modeling::importLammps({options.dump, bondsOf(options), show}, built->scene,
                                             built->network, options.take);
  if (!frames) return complain(frames.problem());
  std::cout << "frames        " << *frames << '\n';
  return ExitStatus::done;
}

}  // namespace

Command importLammpsCommand() {
  const auto options = std::make_shared<ImportOptions>();
  return {
      .name = "import-lammps",
      .help = "Bring a run of LAMMPS back as a take (see export --format lammps)",
      .options = {{.name = "dump", .target = &options->dump, .help = "The dump of nodes", .required = true},
                  {.name = "--scene",
                   .target = &options->scene,
                   .help = "The scene that the run was exported from",
                   .required = true},
                  {.name = "--take", .target = &options->take, .help = "File to write", .required = true},
                  {"--bonds", &options->bonds, "The dump of bonds (default: DUMP with the ending .bonds)"},
                  {"--set", &options->settings, "PATH=VALUE, as the scene was run with"},
                  forceOption(options->force)},
      .run = [options] { return import(*options); }};
}

}  // namespace app
