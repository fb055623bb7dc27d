#include "app/cli/render_command.h"

#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/frames.h"
#include "app/cli/progress.h"
#include "modeling/exchange/export.h"
#include "ui/picture/take_pictures.h"

namespace app {

namespace {

struct RenderOptions {
  std::string take;
  std::string out;
  std::optional<double> time;
  std::string frames;
  std::string size = "1280x720";
  int samples = ui::PictureSettings{}.samples;
  bool sixteenBit = false;
  sim::LooseNodes looseNodes = sim::LooseNodes::shards;
};

sim::Status readSize(const std::string& text, ui::PictureSettings& settings) {
  char rest = '\0';
  if (std::sscanf(text.c_str(), "%5dx%5d%c", &settings.width, &settings.height, &rest) == 2)
    return sim::Done{};
  return sim::Problem{"--size", "\"" + text + "\" is no size", "write it as 1280x720"};
}

sim::Result<FrameRange> framesWanted(const RenderOptions& options, const sim::TakeReader& take) {
  if (!options.frames.empty()) return parseFrameRange(options.frames, take);
  const std::size_t frame = options.time ? frameNearest(*options.time, take) : take.frameCount() - 1;
  return FrameRange{frame, frame};
}

sim::Status drawFrame(std::size_t frame, ui::TakePictures& pictures, ui::PictureSettings settings,
                      const std::filesystem::path& path, ui::PngDepth depth) {
  const auto scene = pictures.sceneOf(frame);
  if (!scene) return scene.problem();
  Progress progress("render frame " + std::to_string(frame));
  settings.progress = [&](double share) {
    progress.show(share);
    return true;
  };
  const auto image = ui::renderPicture(*scene, settings);
  if (!image) return image.problem();
  return ui::writePng(path, *image, depth);
}

ExitStatus drawFrames(const RenderOptions& options, const ui::PictureSettings& settings,
                      ui::TakePictures& pictures, const FrameRange& range) {
  const auto depth = options.sixteenBit ? ui::PngDepth::sixteenBit : ui::PngDepth::eightBit;
  for (std::size_t frame = range.first; frame <= range.last; ++frame) {
    const auto path = options.frames.empty() ? std::filesystem::path(options.out)
                                             : modeling::numberedPath(options.out, frame);
    const auto drawn = drawFrame(frame, pictures, settings, path, depth);
    if (!drawn) return complain(drawn.problem());
  }
  return ExitStatus::done;
}

ExitStatus render(const RenderOptions& options) {
  ui::PictureSettings settings;
  settings.samples = options.samples;
  if (const auto size = readSize(options.size, settings); !size) return complain(size.problem());
  const auto take = sim::TakeReader::open(options.take);
  if (!take) return complain(take.problem());
  if (const auto some = needFrames(**take, options.take); !some) return complain(some.problem());
  const auto range = framesWanted(options, **take);
  if (!range) return complain(range.problem());
  const double aspect = static_cast<double>(settings.width) / std::max(1, settings.height);
  auto pictures = ui::TakePictures::create(**take, range->first, range->last, aspect, options.looseNodes);
  if (!pictures) return complain(pictures.problem());
  return drawFrames(options, settings, *pictures, *range);
}

}  // namespace

void addRenderCommand(CLI::App& program, ExitStatus& status) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* command = program.add_subcommand("render", "Draw ray-traced pictures of a take's frames");
  command->add_option("take", options->take, "The take")->required();
  command->add_option("--out", options->out, "PNG file; with --frames, FILE.0012.png for frame 12")
      ->required();
  CLI::Option* time =
      command->add_option("--time", options->time, "The frame nearest to this time, s (default: the last)");
  command->add_option("--frames", options->frames, "Frames A:B, counted from 0")->excludes(time);
  command->add_option("--size", options->size, "Width and height in pixels")->capture_default_str();
  command->add_option("--samples", options->samples, "Paths a pixel: more is smoother and slower")
      ->capture_default_str();
  command->add_flag("--sixteen-bit", options->sixteenBit, "16 bit a channel instead of 8");
  static const std::map<std::string, sim::LooseNodes> kLooseNodes{
      {"shards", sim::LooseNodes::shards},
      {"tetrahedra", sim::LooseNodes::tetrahedra},
      {"spheres", sim::LooseNodes::spheres},
      {"given-to-neighbours", sim::LooseNodes::givenToNeighbours}};
  command
      ->add_option(
          "--loose-nodes", options->looseNodes,
          "How nodes are drawn that nothing holds any more: shards that fill what their cells filled, "
          "tetrahedra, spheres, or not at all, their material given to the fragments beside them")
      ->transform(CLI::CheckedTransformer(kLooseNodes))
      ->default_str("shards");
  command->callback([options, &status] { status = render(*options); });
}

}  // namespace app
