#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "modeling/scene/picture_style.h"
#include "sim/collider/collider.h"
#include "sim/surface/surface_mesh.h"
#include "ui/picture/camera.h"
#include "ui/picture/environment_map.h"
#include "ui/picture/image.h"

namespace ui {

class TracedScene;

/// What a still shows. Visible colliders are drawn; a visible floor is the ground, and without one the things
/// float in front of the backdrop, unless the style says what they stand on.
struct PictureScene {
  sim::SurfaceMesh surface;
  std::vector<modeling::Look> looks;  ///< by material; a material without one has Look's defaults
  std::vector<sim::Collider> colliders;
  // When the shutter closes: what moves until then is blurred. All empty: nothing does.
  std::vector<sim::Vec3> endPoints;   ///< of the surface, cm
  std::vector<sim::Vec3> endNormals;  ///< likewise
  std::vector<sim::Collider> endColliders;
  modeling::PictureStyle style;                       ///< its surface and image have been made already, ...
  std::shared_ptr<const EnvironmentMap> environment;  ///< ... the latter into this; null: the studio's lamps
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

/// A picture in the making: samples are added to it bit by bit, it can be looked at any time, and kept to be
/// gone on with. However it is cut into pieces, the picture is the same.
class PictureRun {
 public:
  /// A Problem when the sizes are out of range, or when there is not enough memory.
  static sim::Result<std::unique_ptr<PictureRun>> create(const PictureScene& scene,
                                                         const PictureSettings& settings);
  ~PictureRun();
  PictureRun(const PictureRun&) = delete;
  PictureRun& operator=(const PictureRun&) = delete;

  /// Goes on until every pixel has this many samples, at most the settings'. False when `progress` of the
  /// settings, which is told the share of all samples, said to stop: what has been done by then counts.
  bool advanceTo(int samples);
  /// The fewest samples that a pixel has.
  int samples() const;
  /// As it is now. Where there are no samples it is black.
  Image image() const;

  /// All samples so far; `of` names what the picture is of and how it is drawn.
  std::vector<std::byte> kept(const std::string& of) const;
  /// A Problem, and nothing changed, where it was kept of another picture or is damaged.
  sim::Status goOnFrom(std::span<const std::byte> kept, const std::string& of);

 private:
  class Renderer;
  PictureRun() = default;
  std::unique_ptr<TracedScene> traced_;
  std::unique_ptr<Renderer> renderer_;
};

/// A ray-traced still: a key and a fill light, soft shadows, light that is scattered up to four times,
/// a mirror-like glaze by Fresnel's law on outsides, clear glass, matt insides, every fragment in a tint of
/// its own; blurred by what the lens does not focus and by what moves while the shutter is open. Curved
/// outsides are drawn curved: each face is a patch through its corners that follows their normals.
///
/// A Problem when cancelled, when the sizes are out of range, or when there is not enough memory.
sim::Result<Image> renderPicture(const PictureScene& scene, const PictureSettings& settings);

}  // namespace ui
