#include "ui/picture/video.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "modeling/files/output_file.h"

namespace ui {

namespace {

struct Codec {
  std::string_view ending;
  std::vector<std::string> arguments;
};

/// Options by which ffmpeg makes a picture's sRGB to what films have, and says so in the file: BT.709 in
/// limited range, whatever the size. Unasked, it takes BT.601 and says nothing, and players guess by size.
/// `before`: filters of the picture, each with a comma behind it.
std::vector<std::string> filmColours(const std::string& before) {
  return {"-vf",
          before +
              "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int,"
              "format=yuv420p,"
              "setparams=colorspace=bt709:color_primaries=bt709:color_trc=bt709:range=tv",
          "-colorspace",
          "bt709",
          "-color_primaries",
          "bt709",
          "-color_trc",
          "bt709",
          "-color_range",
          "tv"};
}

std::vector<std::string> operator+(std::vector<std::string> first, const std::vector<std::string>& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

const std::array<Codec, 6>& codecs() {
  // What players want of mp4 has an even number of pixels a side.
  static const std::vector<std::string> kPlayable =
      filmColours("pad=ceil(iw/2)*2:ceil(ih/2)*2,") +
      std::vector<std::string>{"-c:v",    "libx264", "-crf",      "17",
                               "-preset", "slow",    "-movflags", "+faststart+write_colr"};
  static const std::vector<std::string> kWebm =
      filmColours("") + std::vector<std::string>{"-c:v", "libvpx-vp9", "-crf", "28", "-b:v", "0"};
  // A palette of the film's own; without it a gradient shows the steps of a general one.
  static const std::string kPalette =
      "split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=dither=sierra2_4a";
  static const std::array<Codec, 6> kCodecs{
      {{".mp4", kPlayable},
       {".mov", kPlayable},
       {".webm", kWebm},
       {".gif", {"-filter_complex", kPalette, "-loop", "0"}},
       {".webp", {"-c:v", "libwebp_anim", "-quality", "92", "-compression_level", "6", "-loop", "0"}},
       {".apng", {"-f", "apng", "-plays", "0"}}}};
  return kCodecs;
}

const Codec* codecOf(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  const auto found = std::find_if(codecs().begin(), codecs().end(),
                                  [&](const Codec& codec) { return codec.ending == ending; });
  return found == codecs().end() ? nullptr : &*found;
}

std::vector<std::string> argumentsOf(const VideoRequest& request, const std::filesystem::path& out,
                                     const Codec& codec) {
  std::vector<std::string> arguments{"ffmpeg",
                                     "-nostdin",
                                     "-y",
                                     "-loglevel",
                                     "error",
                                     "-framerate",
                                     std::to_string(request.framesPerSecond),
                                     "-start_number",
                                     std::to_string(request.first),
                                     "-i",
                                     request.pictures,
                                     "-frames:v",
                                     std::to_string(request.count)};
  arguments.insert(arguments.end(), codec.arguments.begin(), codec.arguments.end());
  // A name that begins with a hyphen is no option.
  arguments.push_back("file:" + out.string());
  return arguments;
}

/// Waits for the program; its exit status, or -1 where it could not be started.
int run(const std::vector<std::string>& arguments) {
  std::vector<char*> raw;
  for (const std::string& argument : arguments) raw.push_back(const_cast<char*>(argument.c_str()));
  raw.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, raw[0], nullptr, nullptr, raw.data(), environ) != 0) return -1;
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return -1;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace

bool isVideoPath(const std::filesystem::path& path) {
  return codecOf(path) != nullptr;
}

sim::Status writeVideo(const VideoRequest& request) {
  const Codec* codec = codecOf(request.out);
  if (codec == nullptr) {
    return sim::Problem{request.out.string(), "no film has this ending",
                        "end it in .mp4, .mov, .webm, .gif, .webp or .apng"};
  }
  auto film = modeling::OutputFile::create(request.out);
  if (!film) return film.problem();
  if (film->draft().empty())
    return sim::Problem{request.out.string(), "a film cannot be written to this", "name a file"};
  const int status = run(argumentsOf(request, film->draft(), *codec));
  if (status == 0) return film->finish();
  // 127 is what a shell answers for a program that is not there, and some systems' posix_spawnp too.
  if (status < 0 || status == 127) {
    return sim::Problem{request.out.string(), "there is no ffmpeg to make a film with",
                        "install ffmpeg, or write PNG files"};
  }
  return sim::Problem{request.out.string(), "ffmpeg could not make the film",
                      "see what it says above; the pictures are " + request.pictures};
}

}  // namespace ui
