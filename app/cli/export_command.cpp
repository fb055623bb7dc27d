#include <iostream>
#include <memory>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/frames.h"
#include "app/cli/loose_nodes.h"
#include "app/cli/progress.h"
#include "modeling/exchange/export.h"
#include "modeling/exchange/take_scene.h"
#include "modeling/scene/scene_files.h"
#include "modeling/text/printable.h"

namespace app {

namespace {

struct ExportOptions {
  std::string take;
  std::string format;
  std::string out;
  std::string frames = ":";
  std::string looseNodes;
  bool levelSurface = false;
  bool force = false;
};

sim::Status write(const modeling::ExportFormat& format, const sim::TakeReader& take, const FrameRange& range,
                  const ExportOptions& options) {
  modeling::OutputGuard guard(options.force);
  guard.reads(options.take);
  if (const auto scene = modeling::sceneOf(take))
    guard.reads(modeling::filesOf(*scene, std::filesystem::path(options.take).parent_path()));
  guard.writes(format.files(
      {.path = options.out, .firstFrame = range.first, .lastFrame = range.last, .progress = {}}));
  if (const sim::Status safe = guard.check(); !safe) return safe;
  Progress progress("export");
  const auto show = [&](double share) {
    progress.show(share);
    return true;
  };
  std::string remarks;
  const auto remark = [&](const std::string& text) { remarks += modeling::printable(text) + "\n"; };
  auto status = format.write(take, {.path = options.out,
                                    .firstFrame = range.first,
                                    .lastFrame = range.last,
                                    .progress = show,
                                    .remark = remark,
                                    .looseNodes = looseNodesNamed(options.looseNodes),
                                    .levelSurface = options.levelSurface});
  if (status) std::cout << remarks;
  return status;
}

ExitStatus exportTake(const ExportOptions& options) {
  const auto format = modeling::exportFormatNamed(options.format);
  if (!format) return complain(format.problem());
  if (!options.looseNodes.empty() && format->surface == modeling::ExportedSurface::none) {
    return complain(sim::Problem{"--loose-nodes", "the format " + format->name + " has no surface",
                                 "leave it out, or use --format glb, obj, ply or pc2"});
  }
  if (options.levelSurface && format->surface != modeling::ExportedSurface::cellsOrLevel) {
    return complain(sim::Problem{"--level-surface", "the format " + format->name + " cannot have it",
                                 "use --format obj or ply"});
  }
  const auto take = sim::TakeReader::open(options.take);
  if (!take) return complain(take.problem());
  if (const auto some = needFrames(**take, options.take); !some) return complain(some.problem());
  const auto range = parseFrameRange(options.frames, **take);
  if (!range) return complain(range.problem());
  const auto written = write(*format, **take, *range, options);
  return written ? ExitStatus::done : complain(written.problem());
}

std::string formatHelp() {
  std::string help = "One of";
  for (const auto& format : modeling::exportFormats()) help += "\n  " + format.name + ": " + format.summary;
  return help;
}

}  // namespace

Command exportCommand() {
  const auto options = std::make_shared<ExportOptions>();
  return {.name = "export",
          .help = "Write a take's frames for other programs",
          .options =
              {{.name = "take", .target = &options->take, .help = "The take", .required = true},
               {.name = "--format", .target = &options->format, .help = formatHelp(), .required = true},
               {.name = "--out",
                .target = &options->out,
                .help = "File; a format of one file a frame numbers them, as in FILE.0012.obj",
                .required = true},
               {"--frames", &options->frames, "Frames A:B, counted from 0 (default: all)"},
               looseNodesOption(options->looseNodes),
               {"--level-surface", &options->levelSurface,
                "The surface on which the potential field of the nodes has one value, in place of the cells' "
                "(obj, ply)"},
               forceOption(options->force)},
          .run = [options] { return exportTake(*options); }};
}

}  // namespace app
