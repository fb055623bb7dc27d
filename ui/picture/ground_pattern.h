#pragma once

#include "modeling/scene/picture_style.h"
#include "ui/picture/linear.h"

namespace ui {

/// Smooth noise in [-1, 1]: random values at whole coordinates, blended.
float noise(const Vec3f& at);

/// How a ground's surface looks at a place of it.
struct GroundLook {
  Light colour;
  float glaze = 0.0F;
  float roughness = 0.0F;
};
/// `across` and `along` in cm from the world's origin.
GroundLook groundLook(const modeling::Ground& ground, float across, float along);

}  // namespace ui
