#pragma once

#include <functional>
#include <vector>

#include "modeling/material/material.h"
#include "sim/contact/collider.h"
#include "sim/network/surface_mesh.h"
#include "ui/picture/camera.h"
#include "ui/picture/image.h"

namespace ui {

/// What a still shows. Visible colliders are drawn; a visible floor is the ground of the studio, and without
/// one the things float in front of the backdrop.
struct PictureScene {
  sim::SurfaceMesh surface;
  std::vector<modeling::Look> looks;  ///< by material; a material without one has Look's defaults
  std::vector<sim::Collider> colliders;
  Camera camera;
  Box subject;  ///< what the lights and the backdrop are arranged around, cm
};

struct PictureSettings {
  int width = 1280;
  int height = 720;
  int samples = 40;        ///< paths a pixel
  std::uint32_t seed = 1;  ///< of the paths; a picture is the same for any number of threads
  int threads = 0;         ///< 0: all there are
  /// Told the share that is done, from one thread at a time; answers false to cancel.
  std::function<bool(double)> progress;
};

/// A ray-traced still (P21): a key and a fill light, soft shadows, one bounce of indirect light, a
/// mirror-like glaze by Fresnel's law on outsides, matt insides, every fragment in a tint of its own. Curved
/// outsides are drawn curved: each face is a patch through its corners that follows their normals.
///
/// A Problem when cancelled, when the sizes are out of range, or when there is not enough memory.
sim::Result<Image> renderPicture(const PictureScene& scene, const PictureSettings& settings);

}  // namespace ui
