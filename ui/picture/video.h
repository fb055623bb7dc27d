#pragma once

#include <filesystem>
#include <string>

#include "sim/base/result.h"

namespace ui {

/// A film made of numbered pictures by the program `ffmpeg`, which may or may not be installed.
struct VideoRequest {
  std::string pictures;  ///< path with %04d in place of a picture's number
  std::size_t first = 0;
  std::size_t count = 1;
  double framesPerSecond = 24.0;
  std::filesystem::path out;
};

/// Whether a path's ending is that of a film: mp4, mov, webm, gif, webp or apng.
bool isVideoPath(const std::filesystem::path& path);

/// The film appears whole or not at all. A Problem when there is no ffmpeg or it fails.
sim::Status writeVideo(const VideoRequest& request);

}  // namespace ui
