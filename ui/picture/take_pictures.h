#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "modeling/scene/scene.h"
#include "sim/surface/surface_mesh.h"
#include "sim/take/take.h"
#include "ui/picture/picture.h"

namespace ui {

/// Where pictures get their frames from.
struct PictureFrames {
  std::shared_ptr<const sim::Network> network;
  modeling::Scene scene;
  double framesPerSecond = 24.0;
  std::filesystem::path folder;  ///< where the image of the environment is looked for
  EnvironmentReader readEnvironment = [](const std::filesystem::path& path,
                                         const modeling::Attendance& attendance) {
    return ui::readEnvironment(path, {}, attendance);
  };
  std::function<sim::Result<sim::SnapshotPointer>(std::size_t)> frame;
};

/// Those of a take, which must be there as long as they are. A Problem when its scene cannot be read.
/// `settings` are laid over the scene.
sim::Result<PictureFrames> framesOf(const sim::TakeReader& take,
                                    const std::vector<std::string>& settings = {});

/// What a take leaves open.
struct PictureChoices {
  sim::LooseNodes looseNodes = sim::LooseNodes::shards;
  double shutter = 0.0;  ///< how long it is open, as a share of the time of a frame; 0: nothing is blurred
  std::optional<double> aperture;  ///< cm; absent: the scene's camera's
};

/// Sets up pictures of frames: the surface, the materials' looks, colliders where their tracks have them, and
/// the camera.
class TakePictures {
 public:
  /// Pictures of frames [first, last], which all have one camera: the scene's view, or one that sees all of
  /// them. A Problem when a frame or the image of the environment cannot be read; who waits for the image is
  /// told, and can give up.
  static sim::Result<TakePictures> create(PictureFrames frames, std::size_t first, std::size_t last,
                                          double aspect, const PictureChoices& choices = {},
                                          const modeling::Attendance& attendance = {});

  sim::Result<PictureScene> sceneOf(std::size_t frame);

 private:
  TakePictures(PictureFrames frames, const PictureChoices& choices);

  PictureFrames frames_;
  PictureChoices choices_;
  sim::SurfaceBuilder surfaceBuilder_;
  std::shared_ptr<const EnvironmentMap> environment_;
  Camera camera_;
  Box subject_;
};

/// Where most of a moment is: the box of the fragments nearest to its middle that together have kFramedShare
/// of its nodes, so that shards which flew off do not make everything small. What is whole is framed whole.
inline constexpr double kFramedShare = 0.8;
Box boxOfMost(const sim::Snapshot& moment);

}  // namespace ui
