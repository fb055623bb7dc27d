#pragma once

#include <optional>
#include <string>
#include <vector>

#include "modeling/material/material.h"
#include "sim/base/result.h"

/// How a scene is looked at.
namespace modeling {

struct Camera {
  sim::Vec3 position{60.0, -80.0, 50.0};  ///< cm
  sim::Vec3 target = sim::Vec3::Zero();   ///< cm
  double fieldOfView = 35.0;              ///< degrees, vertical
  double aperture = 0.0;                  ///< cm, of the lens; 0: a pinhole
  std::optional<double> focus;            ///< cm from the eye; absent: as far as the target

  bool operator==(const Camera&) const = default;
};

/// What surface pictures draw.
enum class PictureSurface {
  cells,  ///< of the cells, with cracks
  level,  ///< where the potential field of the nodes has one value (paper, "Rendering")
};

enum class GroundKind {
  studio,   ///< a visible floor, grey, that fades into the backdrop
  none,     ///< not drawn
  plain,    ///< of one matt colour
  checker,  ///< squares of two colours
  wood,     ///< planks of about the first colour, grained with the second
  shadow,   ///< nothing but the shadows that fall on it
};

/// What things stand on. Where there is no visible floor, all but `studio` and `none` are a plane under them.
struct Ground {
  GroundKind kind = GroundKind::studio;
  std::optional<Colour> colour;  ///< absent: the kind's own, as of `second`
  std::optional<Colour> second;
  double size = 6.0;  ///< cm, of a square; width of a plank

  bool operator==(const Ground&) const = default;
};

enum class BackdropKind { studio, colour, gradient, environment };

/// What is seen where there is nothing.
struct Backdrop {
  BackdropKind kind = BackdropKind::studio;
  Colour colour{0.75, 0.75, 0.75};  ///< of a gradient: at the horizon
  Colour top{0.25, 0.28, 0.32};     ///< of a gradient: overhead

  bool operator==(const Backdrop&) const = default;
};

/// An image of all that is around, which lights the scene in place of the studio's lamps.
struct EnvironmentLight {
  std::string
      image;  ///< file: OpenEXR, Radiance .hdr or PNG, twice as wide as high; empty: the studio's lamps
  double strength = 1.0;  ///< factor
  double turn = 0.0;      ///< degrees about the vertical; at 0 the middle of the image lies towards +y

  bool operator==(const EnvironmentLight&) const = default;
};

struct PictureStyle {
  PictureSurface surface = PictureSurface::cells;
  Ground ground;
  Backdrop backdrop;
  EnvironmentLight environment;

  bool operator==(const PictureStyle&) const = default;
};

struct View {
  std::optional<Camera> camera;  ///< absent: framed around everything
  PictureStyle picture;
  std::vector<std::string>
      hidden;  ///< parts that are simulated, but not drawn; names of nothing count nothing
  std::vector<std::string> locked;  ///< parts and colliders that a click in the viewport passes over

  bool operator==(const View&) const = default;
};

/// What makes the style impossible. The Problem's place is a path of the scene, such as
/// "view.picture.backdrop.kind".
sim::Status checkPictureStyle(const PictureStyle& style);

}  // namespace modeling
