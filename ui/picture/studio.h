#pragma once

#include <array>

#include "modeling/scene/picture_style.h"
#include "ui/picture/camera.h"
#include "ui/picture/environment_map.h"
#include "ui/picture/linear.h"

namespace ui {

/// A soft box: a rectangle that shines to its front, brightest in the middle.
struct SoftBox {
  Vec3f centre;
  Vec3f halfAcross;  ///< to its right edge
  Vec3f halfUp;      ///< to its upper edge
  Vec3f front;       ///< unit
  Light radiance;    ///< of its middle
  float area = 0.0F;

  Vec3f pointAt(const std::array<float, 2>& random) const {
    return centre + (2.0F * random[0] - 1.0F) * halfAcross + (2.0F * random[1] - 1.0F) * halfUp;
  }
  /// Towards a viewer in front of it, at coordinates in [-1, 1]; dark outside.
  Light radianceAt(float across, float up) const;
  /// Of a point made by pointAt().
  Light radianceAt(const std::array<float, 2>& random) const {
    return radianceAt(2.0F * random[0] - 1.0F, 2.0F * random[1] - 1.0F);
  }
};

/// The photographer's room, arranged around the subject as the camera sees it: a key light at the left above,
/// a weak wide fill light at the right, a dim dome, and a warm grey sweep into which the floor fades.
struct Studio {
  std::array<SoftBox, 2> lights;  ///< key, fill
  float fadeFrom = 0.0F;  ///< distance along the floor from the subject where it begins to turn to backdrop
  float fadeTo = 0.0F;

  modeling::PictureStyle style;
  std::shared_ptr<const EnvironmentMap>
      environment;                      ///< lights in place of dome and lamps, where there is one
  Vec3f middle = Vec3f::Zero();         ///< of the subject in the world, cm
  Light domeFromAbove = Light::Zero();  ///< what the dome alone gives a horizontal white surface
  Light ambient = Light::Zero();        ///< what arrives from surfaces that are no longer followed

  /// What the camera sees where there is nothing.
  Light backdrop(const Vec3f& direction) const;
  /// What lights from there: brighter than the backdrop, as a studio has a ceiling that no picture shows.
  Light dome(const Vec3f& direction) const;
  /// What a mirror sees where there is nothing: the environment, or the dome and the soft boxes.
  Light reflected(const Vec3f& origin, const Vec3f& direction) const;
};

/// All in coordinates relative to the middle of the subject.
Studio arrangeStudio(const Camera& camera, const Box& subject, const modeling::PictureStyle& style = {},
                     std::shared_ptr<const EnvironmentMap> environment = nullptr);

}  // namespace ui
