#pragma once

#include <QOpenGLShaderProgram>

namespace ui {

/// The shaders of resources/shaders, compiled.
struct GlPrograms {
  QOpenGLShaderProgram background;
  QOpenGLShaderProgram ground;
  QOpenGLShaderProgram groundPick;
  QOpenGLShaderProgram solid;
  QOpenGLShaderProgram solidDepth;
  QOpenGLShaderProgram solidMask;
  QOpenGLShaderProgram solidPick;
  QOpenGLShaderProgram ball;
  QOpenGLShaderProgram ballPick;
  QOpenGLShaderProgram bond;
  QOpenGLShaderProgram bondPick;
  QOpenGLShaderProgram occlusion;
  QOpenGLShaderProgram outline;

  /// False where one does not compile; `why` is what the driver says.
  bool build(QString& why);
};

}  // namespace ui
