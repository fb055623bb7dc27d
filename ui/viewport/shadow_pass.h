#pragma once

#include <QMatrix4x4>
#include <memory>

#include "ui/viewport/render_context.h"

namespace ui {

/// Unit: towards the lamp.
const sim::Vec3& lightDirection();

/// What the lamp sees: a map of depths, by which programs find what lies in the shade.
class ShadowPass {
 public:
  void make(Gl& gl);
  void destroy(Gl& gl);

  /// Draws the map, unless it is of this draw data already.
  void paint(RenderContext& context);
  /// Lets the program that is bound read the map.
  void use(RenderContext& context, QOpenGLShaderProgram& program) const;

 private:
  void drawCasters(RenderContext& context, const QMatrix4x4& clip, const QMatrix4x4& view);

  GLuint map_ = 0;
  GLuint buffer_ = 0;
  std::shared_ptr<const DrawData> of_;
  QMatrix4x4 shadowFromWorld_;
  float radius_ = 0.0F;  ///< of the penumbra, share of the map
  float offset_ = 0.0F;  ///< cm, off the surface, so that it does not shade itself
};

}  // namespace ui
