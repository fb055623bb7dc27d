#pragma once

#include <memory>
#include <optional>

#include "ui/viewport/occlusion_pass.h"
#include "ui/viewport/pick_pass.h"
#include "ui/viewport/shadow_pass.h"

namespace ui {

/// Draws draw data with OpenGL 3.3. Made, used and destroyed with the context current.
class ViewportRenderer {
 public:
  /// Null where there is no OpenGL 3.3, or a shader does not compile; `why` says so.
  static std::unique_ptr<ViewportRenderer> create(QString& why);
  /// What contexts have to be like, for the program to ask for before it makes the first.
  static void askForContexts(int samplesAPixel = 4);
  ~ViewportRenderer();

  void show(const std::shared_ptr<const DrawData>& data);
  void paint(const PictureFrame& frame);
  /// The thing nearest to a point of the picture, at most `reach` logical pixels away.
  PickedThing pick(const PictureFrame& frame, const QPointF& at, double reach);
  const DrawStatistics& statistics() const { return statistics_; }

 private:
  ViewportRenderer();

  bool initialise(QString& why);
  void useLight(QOpenGLShaderProgram& program, const PictureFrame& frame);
  void paintBackground(const PictureFrame& frame);
  void paintSolids(const PictureFrame& frame);
  void paintBalls(const PictureFrame& frame);
  void paintBonds(const PictureFrame& frame);
  void paintGround(const PictureFrame& frame);
  void paintXray(const PictureFrame& frame);
  void paintOutline(const PictureFrame& frame);

  Gl gl_;
  DrawStatistics statistics_;
  GlPrograms programs_;
  std::unique_ptr<GpuScene> scene_;
  std::optional<RenderContext> context_;  ///< of the three above
  ShadowPass shadow_;
  OcclusionPass occlusion_;
  PickPass picking_;
  GlTarget mask_;  ///< of what is outlined
};

}  // namespace ui
