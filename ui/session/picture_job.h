#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "ui/picture/take_pictures.h"
#include "ui/session/background_worker.h"

namespace ui {

/// Pictures drawn in a thread of their own (BackgroundWorker), while the window goes on. The window asks how
/// far they are; each answer has the picture as it is by then.
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
    std::string
        doing;  ///< what takes its time before the first samples: "reading sky.hdr, 3 s"; "": nothing does
    bool ended = false;
    std::optional<sim::Problem> problem;  ///< why it ended early; nothing for one that was stopped
  };

  explicit PictureJob(Order order);

  void stop() { worker_.cancel(); }
  View view() const;

 private:
  BackgroundWorker<Order, View> worker_;
};

}  // namespace ui
