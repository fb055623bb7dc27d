#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/frames.h"
#include "app/cli/loose_nodes.h"
#include "app/cli/progress.h"
#include "modeling/exchange/export.h"
#include "modeling/scene/scene_names.h"
#include "ui/picture/take_pictures.h"
#include "ui/picture/video.h"

namespace app {

namespace {

/// What was drawn so far is written beside the picture this often, s, so that little is lost.
constexpr double kKeepEvery = 60.0;
/// Samples between two looks at the clock.
constexpr int kSamplesAPass = 4;

volatile std::sig_atomic_t interrupted = 0;

struct RenderOptions {
  std::string take;
  std::string out;
  std::optional<double> time;
  std::string frames;
  std::string size = "1280x720";
  int samples = ui::PictureSettings{}.samples;
  bool sixteenBit = false;
  bool resume = false;
  double framesPerSecond = 0.0;
  ui::PictureChoices choices;
  std::string looseNodes;
  std::vector<std::string> settings;  ///< of the scene
  // These stand for settings of view.picture; "": not given.
  std::string surface;
  std::string ground;
  std::string backdrop;
  std::string environment;

  std::vector<std::string> allSettings() const {
    std::vector<std::string> all = settings;
    const auto add = [&](const std::string& path, const std::string& value) {
      if (!value.empty()) all.push_back("view.picture." + path + "=" + value);
    };
    add("surface", surface);
    add("ground.kind", ground);
    add("backdrop.kind", backdrop);
    if (environment.empty()) return all;
    std::string image = "\"";
    image += std::filesystem::absolute(environment).string();
    image += "\"";
    add("environment.image", image);
    return all;
  }
  bool isSequence() const { return !frames.empty() || ui::isVideoPath(out); }
  /// What pictures depend on but for the number of samples: more can be added to those that were kept.
  std::string nameOf(std::size_t frame) const {
    std::ostringstream name;
    name << take << " frame " << frame << " " << size << " " << static_cast<int>(looseNodesNamed(looseNodes))
         << " " << choices.shutter << " " << choices.aperture.value_or(-1.0);
    for (const std::string& setting : allSettings()) name << " " << setting;
    return name.str();
  }
};

sim::Status readSize(const std::string& text, ui::PictureSettings& settings) {
  char rest = '\0';
  if (std::sscanf(text.c_str(), "%5dx%5d%c", &settings.width, &settings.height, &rest) == 2)
    return sim::Done{};
  return sim::Problem{"--size", "\"" + text + "\" is no size", "write it as 1280x720"};
}

sim::Result<FrameRange> framesWanted(const RenderOptions& options, const sim::TakeReader& take) {
  if (!options.frames.empty()) return parseFrameRange(options.frames, take);
  if (options.isSequence()) return FrameRange{0, take.frameCount() - 1};
  const std::size_t frame = options.time ? frameNearest(*options.time, take) : take.frameCount() - 1;
  return FrameRange{frame, frame};
}

/// Draws the frames of one command.
class FrameDrawer {
 public:
  FrameDrawer(const RenderOptions& options, const ui::PictureSettings& settings, ui::TakePictures& pictures)
      : options_(options), settings_(settings), pictures_(pictures) {}

  sim::Status draw(std::size_t frame, const std::filesystem::path& path) {
    if (options_.resume && std::filesystem::exists(path)) return sim::Done{};
    const auto scene = pictures_.sceneOf(frame);
    if (!scene) return scene.problem();
    Progress progress("render frame " + std::to_string(frame));
    settings_.progress = [&](double share) {
      progress.show(share);
      return interrupted == 0;
    };
    const auto run = ui::PictureRun::create(*scene, settings_);
    if (!run) return run.problem();
    const std::filesystem::path kept = path.string() + ".partial";
    if (const auto status = goOn(**run, kept, frame); !status) return status;
    if (const auto status = finish(**run, kept, frame); !status) return status;
    const auto depth = options_.sixteenBit ? ui::PngDepth::sixteenBit : ui::PngDepth::eightBit;
    if (auto status = ui::writePng(path, (*run)->image(), depth); !status) return status;
    std::error_code nothingKept;
    std::filesystem::remove(kept, nothingKept);
    return sim::Done{};
  }

 private:
  sim::Status goOn(ui::PictureRun& run, const std::filesystem::path& kept, std::size_t frame) const {
    if (!options_.resume || !std::filesystem::exists(kept)) return sim::Done{};
    std::ifstream in(kept, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    auto status = run.goOnFrom(std::as_bytes(std::span(bytes)), options_.nameOf(frame));
    if (status) return status;
    sim::Problem problem = status.problem();
    problem.place = kept.string();
    return problem;
  }

  sim::Status finish(ui::PictureRun& run, const std::filesystem::path& kept, std::size_t frame) const {
    using Clock = std::chrono::steady_clock;
    Clock::time_point written = Clock::now();
    while (run.samples() < settings_.samples) {
      const bool goesOn = run.advanceTo(run.samples() + kSamplesAPass);
      const double since = std::chrono::duration<double>(Clock::now() - written).count();
      if (goesOn && since < kKeepEvery) continue;
      const std::vector<std::byte> bytes = run.kept(options_.nameOf(frame));
      std::ofstream out(kept, std::ios::binary | std::ios::trunc);
      out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
      if (!out.flush()) return sim::Problem{kept.string(), "cannot be written", "see that there is room"};
      if (!goesOn)
        return sim::Problem{kept.string(), "the picture was interrupted", "--resume goes on with it"};
      written = Clock::now();
    }
    return sim::Done{};
  }

  const RenderOptions& options_;
  ui::PictureSettings settings_;
  ui::TakePictures& pictures_;
};

/// Frames of a film are pictures in a folder beside it until it is made.
sim::Status drawVideo(const RenderOptions& options, FrameDrawer& drawer, const FrameRange& range,
                      double fps) {
  const std::filesystem::path folder = options.out + ".frames";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    return sim::Problem{folder.string(), "the folder cannot be made", "choose another place for --out"};
  for (std::size_t frame = range.first; frame <= range.last; ++frame) {
    const auto path = modeling::numberedPath(folder / "frame.png", frame);
    if (auto status = drawer.draw(frame, path); !status) return status;
  }
  const ui::VideoRequest request{(folder / "frame.%04d.png").string(), range.first,
                                 range.last - range.first + 1, fps, options.out};
  if (auto status = ui::writeVideo(request); !status) return status;
  std::filesystem::remove_all(folder, error);
  return sim::Done{};
}

sim::Status drawFrames(const RenderOptions& options, const ui::PictureSettings& settings,
                       ui::TakePictures& pictures, const FrameRange& range, double fps) {
  FrameDrawer drawer(options, settings, pictures);
  if (ui::isVideoPath(options.out)) return drawVideo(options, drawer, range, fps);
  for (std::size_t frame = range.first; frame <= range.last; ++frame) {
    const auto path = options.isSequence() ? modeling::numberedPath(options.out, frame)
                                           : std::filesystem::path(options.out);
    if (auto status = drawer.draw(frame, path); !status) return status;
  }
  return sim::Done{};
}

/// While the image of the environment is read.
modeling::Attendance waiting() {
  modeling::Attendance attendance;
  attendance.tell = [last = std::string()](const std::string& words) mutable {
    if (words != last) std::cerr << words << '\n';
    last = words;
  };
  attendance.gaveUp = [] { return interrupted != 0; };
  return attendance;
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
  auto frames = ui::framesOf(**take, options.allSettings());
  if (!frames) return complain(frames.problem());
  frames->folder = std::filesystem::path(options.take).parent_path();
  const double fps = options.framesPerSecond > 0.0 ? options.framesPerSecond : frames->framesPerSecond;
  const double aspect = static_cast<double>(settings.width) / std::max(1, settings.height);
  ui::PictureChoices choices = options.choices;
  choices.looseNodes = looseNodesNamed(options.looseNodes);
  std::signal(SIGINT, [](int) { interrupted = 1; });
  std::signal(SIGTERM, [](int) { interrupted = 1; });
  auto pictures =
      ui::TakePictures::create(std::move(*frames), range->first, range->last, aspect, choices, waiting());
  if (!pictures)
    return complain(pictures.problem(), interrupted != 0 ? ExitStatus::failed : ExitStatus::wrongInput);
  const auto drawn = drawFrames(options, settings, *pictures, *range, fps);
  if (drawn) return ExitStatus::done;
  return complain(drawn.problem(), interrupted != 0 ? ExitStatus::failed : ExitStatus::wrongInput);
}

/// --NAME, short for --set view.picture...=VALUE.
Option lookOption(const std::string& name, std::string& value, const std::vector<std::string>& names,
                  const std::string& help) {
  return {.name = name, .target = &value, .help = help + " (default: the scene's)", .oneOf = names};
}

/// What pictures look like.
std::vector<Option> lookOptions(RenderOptions& options) {
  return {
      looseNodesOption(options.looseNodes),
      lookOption("--surface", options.surface, modeling::EnumNames<modeling::PictureSurface>::names(),
                 "Of the cells, or the level surface of the nodes' potential field"),
      lookOption("--ground", options.ground, modeling::EnumNames<modeling::GroundKind>::names(),
                 "What things stand on"),
      lookOption("--backdrop", options.backdrop, modeling::EnumNames<modeling::BackdropKind>::names(),
                 "What is seen where there is nothing"),
      {"--environment", &options.environment,
       "Image of all around, OpenEXR, Radiance .hdr or PNG, that lights in place of the studio's lamps "
       "(default: the scene's, which is looked for beside the take)"},
      {"--set", &options.settings,
       "PATH=VALUE: a value of the scene, such as view.picture.ground.colour=[0.8,0.2,0.1]"},
      {.name = "--shutter",
       .target = &options.choices.shutter,
       .help = "Share of a frame's time that the shutter is open: what moves is blurred",
       .range = Range{0.0, 1.0},
       .shownDefault = "0"},
      {.name = "--aperture",
       .target = &options.choices.aperture,
       .help = "Diameter of the lens, cm: what is not in focus is blurred (default: the scene's camera's)",
       .range = Range{0.0, 1e3}}};
}

std::vector<Option> renderOptions(RenderOptions& options) {
  std::vector<Option> all = {
      {.name = "take", .target = &options.take, .help = "The take", .required = true},
      {.name = "--out",
       .target = &options.out,
       .help = "PNG file; with --frames, FILE.0012.png for frame 12; or a film of all frames by ffmpeg: "
               ".mp4, .mov, .webm, .gif, .webp, .apng",
       .required = true},
      {"--time", &options.time, "The frame nearest to this time, s (default: the last)"},
      {.name = "--frames",
       .target = &options.frames,
       .help = "Frames A:B, counted from 0",
       .excludes = "--time"},
      {.name = "--size",
       .target = &options.size,
       .help = "Width and height in pixels",
       .shownDefault = options.size},
      {.name = "--samples",
       .target = &options.samples,
       .help = "Paths a pixel: more is smoother and slower",
       .shownDefault = std::to_string(options.samples)},
      {.name = "--fps",
       .target = &options.framesPerSecond,
       .help = "Frames a second that a film shows (default: as many as were recorded a second)",
       .positive = true},
      {"--sixteen-bit", &options.sixteenBit, "16 bit a channel instead of 8"},
      {"--resume", &options.resume,
       "Go on with what an interrupted command left: pictures that are there are kept"}};
  for (Option& option : lookOptions(options)) all.push_back(std::move(option));
  return all;
}

}  // namespace

Command renderCommand() {
  const auto options = std::make_shared<RenderOptions>();
  return {.name = "render",
          .help = "Draw ray-traced pictures of a take's frames",
          .options = renderOptions(*options),
          .run = [options] { return render(*options); }};
}

}  // namespace app
