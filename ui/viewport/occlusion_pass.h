#pragma once

#include "ui/viewport/gl_target.h"
#include "ui/viewport/render_context.h"

namespace ui {

/// How much of the sky is seen from what is drawn: corners and undersides are darker. In half as many pixels
/// as the picture has along each side.
class OcclusionPass {
 public:
  OcclusionPass();
  void destroy(Gl& gl);

  void paint(RenderContext& context, const PictureFrame& frame);
  /// Lets the program that is bound read what was painted.
  void use(RenderContext& context, QOpenGLShaderProgram& program) const;

 private:
  GlTarget places_;  ///< where what is seen is, and how it is turned
  GlTarget result_;  ///< what of the sky it sees
};

}  // namespace ui
