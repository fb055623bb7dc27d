#pragma once

#include <QColor>
#include <QSizeF>
#include <memory>
#include <optional>
#include <vector>

#include "ui/viewport/draw_data.h"
#include "ui/viewport/gl.h"
#include "ui/viewport/pick.h"
#include "ui/viewport/view_camera.h"

class QOpenGLShaderProgram;

namespace ui {

class GlTarget;
class GpuScene;
struct GlPrograms;
struct Colours;

/// What is behind a pixel, as the picture shows it.
struct PickedThing {
  Pick::Kind kind = Pick::Kind::nothing;
  std::uint32_t index = 0;  ///< of the face, shard corner / 3, node, bond, collider
  bool shard = false;
  sim::Vec3 point = sim::Vec3::Zero();
  sim::Vec3 normal = sim::Vec3::UnitZ();
};

/// Everything of a picture that is not in the draw data.
struct PictureFrame {
  const ViewCamera& camera;
  QSizeF size;         ///< logical pixels
  double ratio = 1.0;  ///< device pixels a logical one
  GLuint target = 0;   ///< framebuffer
  const Colours& colours;
  std::vector<sim::PartIndex> outlinedParts;
  std::vector<std::size_t> outlinedColliders;  ///< of the draw data's
  std::vector<sim::PartIndex> passedParts;     ///< picking looks through their surface
  std::vector<std::size_t> passedColliders;    ///< likewise; of the draw data's
};

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
  void useCamera(QOpenGLShaderProgram& program, const PictureFrame& frame);
  void useLight(QOpenGLShaderProgram& program, const PictureFrame& frame);
  void paintShadowMap();
  void paintOcclusion(const PictureFrame& frame);
  void paintBackground(const PictureFrame& frame);
  void paintSolids(const PictureFrame& frame);
  void paintBalls(const PictureFrame& frame);
  void paintBonds(const PictureFrame& frame);
  void paintGround(const PictureFrame& frame);
  void paintXray(const PictureFrame& frame);
  void paintOutline(const PictureFrame& frame);
  void drawGround(QOpenGLShaderProgram& program, const sim::Collider* floor);
  void identifySolids(const PictureFrame& frame);
  void identifyFaces(QOpenGLShaderProgram& program, const PictureFrame& frame);
  void identifySurface(const PictureFrame& frame);
  void identifyLattice(const PictureFrame& frame, double reach);
  PickedThing readNearest(const PictureFrame& frame, const QPointF& at, int reach);
  Eigen::AlignedBox3d casters() const;

  Gl gl_;
  DrawStatistics statistics_;
  std::unique_ptr<GlPrograms> programs_;
  std::unique_ptr<GpuScene> scene_;
  std::unique_ptr<GlTarget> mask_;
  std::unique_ptr<GlTarget> identities_;
  std::unique_ptr<GlTarget> places_;     ///< where what is seen is, and how it is turned
  std::unique_ptr<GlTarget> occlusion_;  ///< what of the sky it sees
  GLuint shadowMap_ = 0;
  GLuint shadowBuffer_ = 0;
  std::shared_ptr<const DrawData> shadowOf_;
  QMatrix4x4 shadowFromWorld_;
  float shadowRadius_ = 0.0F;
  float shadowOffset_ = 0.0F;
};

}  // namespace ui
