#pragma once

#include <vector>

#include "modeling/scene/scene.h"
#include "sim/take/take.h"
#include "ui/picture/picture.h"

namespace ui {

/// Sets up pictures of a take's frames: the surface, the materials' looks, colliders where their tracks have
/// them, and the camera.
class TakePictures {
 public:
  /// Pictures of frames [first, last], which all have one camera: the scene's view, or one that sees all of
  /// them. Keeps a reference to the take. A Problem when its scene or a frame cannot be read.
  static sim::Result<TakePictures> create(const sim::TakeReader& take, std::size_t first, std::size_t last,
                                          double aspect,
                                          sim::LooseNodes looseNodes = sim::LooseNodes::shards);

  sim::Result<PictureScene> sceneOf(std::size_t frame);

 private:
  TakePictures(const sim::TakeReader& take, modeling::Scene scene, sim::LooseNodes looseNodes);

  const sim::TakeReader* take_;
  sim::SurfaceBuilder surfaceBuilder_;
  modeling::Scene scene_;
  Camera camera_;
  Box subject_;
};

/// Where most of a moment is: the box of the fragments nearest to its middle that together have kFramedShare
/// of its nodes, so that shards which flew off do not make everything small. What is whole is framed whole.
inline constexpr double kFramedShare = 0.8;
Box boxOfMost(const sim::Snapshot& moment);

}  // namespace ui
