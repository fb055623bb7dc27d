#pragma once

#include <QOpenGLFunctions_3_3_Core>

#include "ui/theme/theme.h"

namespace ui {

/// Draws what the session shows with OpenGL 3.3.
class ViewportRenderer : protected QOpenGLFunctions_3_3_Core {
 public:
  bool initialise() { return initializeOpenGLFunctions(); }
  void clear(const QColor& colour) {
    glClearColor(colour.redF(), colour.greenF(), colour.blueF(), 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
};

}  // namespace ui
