#pragma once

#include <QPointF>

#include "ui/viewport/gl_target.h"
#include "ui/viewport/pick.h"
#include "ui/viewport/render_context.h"

namespace ui {

/// What is behind a pixel, as the picture shows it.
struct PickedThing {
  Pick::Kind kind = Pick::Kind::nothing;
  std::uint32_t index = 0;  ///< of the face, shard corner / 3, node, bond, collider
  bool shard = false;
  sim::Vec3 point = sim::Vec3::Zero();
  sim::Vec3 normal = sim::Vec3::UnitZ();
};

/// Finds what is under the pointer by drawing what it is instead of its colours, and reading that back.
class PickPass {
 public:
  PickPass();
  void destroy(Gl& gl) { target_.destroy(gl); }

  /// The thing nearest to a point of the picture, at most `reach` logical pixels away.
  PickedThing pick(RenderContext& context, const PictureFrame& frame, const QPointF& at, double reach);

 private:
  GlTarget target_;
};

}  // namespace ui
