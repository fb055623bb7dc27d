#pragma once

#include <QSizeF>
#include <vector>

#include <Eigen/Geometry>

#include "ui/viewport/draw_data.h"
#include "ui/viewport/gl.h"
#include "ui/viewport/view_camera.h"

namespace modeling {
struct Scene;
}

namespace ui {

class Selection;
struct Colours;

/// What of the draw data is treated in a way of its own. Parts are the network's; colliders are indices into
/// the draw data's.
struct MarkedThings {
  std::vector<sim::PartIndex> outlinedParts;
  std::vector<std::size_t> outlinedColliders;
  std::vector<sim::PartIndex> passedParts;  ///< picking looks through their surface
  std::vector<std::size_t> passedColliders;
};
/// Outlines what is selected, and lets clicks pass over what is locked.
MarkedThings markedThings(const DrawData& data, const modeling::Scene& scene, const Selection& selection);

/// Everything of a picture that is not in the draw data.
struct PictureFrame {
  const ViewCamera& camera;
  QSizeF size;         ///< logical pixels
  double ratio = 1.0;  ///< device pixels a logical one
  GLuint target = 0;   ///< framebuffer
  const Colours& colours;
  MarkedThings marked;
};

/// What the view is to show when it shows everything, cm: all bodies and colliders, and of a floor what lies
/// below them. Empty where there is nothing.
Eigen::AlignedBox3d boxOfAll(const DrawData& data);
/// Around what is outlined, cm; empty where nothing is, or nothing of it is drawn.
Eigen::AlignedBox3d boxOfOutlined(const DrawData& data, const MarkedThings& marked);

}  // namespace ui
