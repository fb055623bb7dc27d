#pragma once

#include <Eigen/Geometry>

#include "sim/base/types.h"

namespace ui {

using Box = Eigen::AlignedBox3d;  ///< cm

/// A lens that keeps the world's z upright.
struct Camera {
  sim::Vec3 position{0.0, -100.0, 30.0};  ///< cm
  sim::Vec3 target = sim::Vec3::Zero();   ///< cm, in the middle of the picture
  double verticalFieldOfView = 0.5;       ///< radians, from the picture's bottom to its top
  double aperture = 0.0;                  ///< cm, the lens's diameter; 0: a pinhole, all is sharp
  double focus = 0.0;                     ///< cm, distance that is sharp; 0: that of the target
};

/// Where a picture is taken from when nobody says: from the front, a little to the right, from slightly
/// above, by a long lens, as products are photographed.
struct ViewDirection {
  double azimuth = -1.05;     ///< radians from +x towards +y: where the camera stands, seen from the subject
  double elevation = 0.33;    ///< radians above the horizon
  double fieldOfView = 0.45;  ///< radians, vertical
};

/// The nearest camera of that direction which sees the whole box with a margin; aspect = width / height.
Camera frameBox(const Box& box, double aspect, const ViewDirection& direction = {});

}  // namespace ui
