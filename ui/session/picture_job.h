#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "ui/picture/take_pictures.h"

namespace ui {

/// Pictures drawn in a thread of their own, while the window goes on. The window asks how far they are; each
/// answer has the picture as it is by then. Every function may be called from any thread and returns at once.
class PictureJob {
 public:
  struct Order {
    PictureFrames frames;
    std::size_t first = 0;
    std::size_t last = 0;
    std::optional<Camera> camera;  ///< absent: the scene's view, or one that sees all frames
    PictureChoices choices;
    PictureSettings settings;  ///< its progress is not used
    PngDepth depth = PngDepth::eightBit;
    double framesPerSecond = 24.0;  ///< of a film
    std::filesystem::path out;      ///< a picture, numbered ones, or a film; empty: only to be looked at
  };
  struct View {
    std::shared_ptr<const Image> image;  ///< null before the first samples
    std::size_t frame = 0;
    double share = 0.0;  ///< of all frames
    bool ended = false;
    std::optional<sim::Problem> problem;  ///< why it ended early; nothing for one that was stopped
  };

  explicit PictureJob(Order order);
  /// Stops it and waits for the samples that are being drawn, a few milliseconds.
  ~PictureJob();
  PictureJob(const PictureJob&) = delete;
  PictureJob& operator=(const PictureJob&) = delete;

  void stop() { runner_.request_stop(); }
  View view() const;

 private:
  sim::Status drawAll(const std::stop_token& stop);
  sim::Status drawFrame(TakePictures& pictures, std::size_t frame, const std::filesystem::path& path,
                        const std::stop_token& stop);
  void show(std::shared_ptr<const Image> image, std::size_t frame, double share);

  Order order_;
  mutable std::mutex mutex_;  ///< of view_
  View view_;
  std::jthread runner_;  ///< last: it uses all of the above
};

}  // namespace ui
