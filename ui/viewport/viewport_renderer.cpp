#include "ui/viewport/viewport_renderer.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QSurfaceFormat>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/theme/theme.h"
#include "ui/viewport/collider_shape.h"
#include "ui/viewport/colour_map.h"
#include "ui/viewport/gl_programs.h"
#include "ui/viewport/gl_target.h"
#include "ui/viewport/gpu_scene.h"

namespace ui {
namespace {

constexpr GLsizei kShadowMapSize = 2048;
/// From the front left above, as a photographer would for someone who looks from the front.
const sim::Vec3 kLight = sim::Vec3(-0.45, -0.55, 1.0).normalized();
/// Of the penumbra, relative to what casts shadows.
constexpr float kPenumbra = 0.008F;
/// How far off something darkens a corner, relative to all there is.
constexpr double kOcclusionReach = 0.10;
constexpr float kBondWidth = 1.4F;  ///< logical pixels

QVector3D single(const sim::Vec3& vector) {
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()), static_cast<float>(vector.z())};
}

QVector3D rgbOf(const QColor& colour) {
  return {static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()),
          static_cast<float>(colour.blueF())};
}

/// How far floor and grid reach, cm.
double groundReach(const Eigen::AlignedBox3d& box) {
  return std::max(60.0, box.isEmpty() ? 0.0 : 5.0 * box.diagonal().norm());
}

/// It is the surface that occludes, where there is one; through one that is transparent it would be seen
/// where nothing is.
bool occludes(const DrawData& data) {
  if (data.box.isEmpty()) return false;
  const ViewSettings& settings = data.settings;
  return settings.occlusion && !settings.xray && (settings.surface || settings.levelSurface);
}

bool isDark(const Colours& colours) {
  return colours.viewBottom.lightnessF() < 0.5F;
}

}  // namespace

ViewportRenderer::ViewportRenderer()
    : programs_(std::make_unique<GlPrograms>()),
      mask_(std::make_unique<GlTarget>(std::vector<GlTarget::Format>{{GL_R8, GL_RED, GL_UNSIGNED_BYTE}})),
      identities_(std::make_unique<GlTarget>(
          std::vector<GlTarget::Format>{{GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT},
                                        {GL_RGBA32F, GL_RGBA, GL_FLOAT},
                                        {GL_RGBA16F, GL_RGBA, GL_FLOAT}})),
      places_(std::make_unique<GlTarget>(
          std::vector<GlTarget::Format>{{GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE},
                                        {GL_RGBA32F, GL_RGBA, GL_FLOAT},
                                        {GL_RGBA16F, GL_RGBA, GL_FLOAT}})),
      occlusion_(
          std::make_unique<GlTarget>(std::vector<GlTarget::Format>{{GL_R8, GL_RED, GL_UNSIGNED_BYTE}})) {}

ViewportRenderer::~ViewportRenderer() {
  if (!scene_) return;
  mask_->destroy(gl_);
  identities_->destroy(gl_);
  places_->destroy(gl_);
  occlusion_->destroy(gl_);
  gl_.glDeleteFramebuffers(1, &shadowBuffer_);
  gl_.glDeleteTextures(1, &shadowMap_);
}

void ViewportRenderer::askForContexts(int samplesAPixel) {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setSamples(samplesAPixel);
  QSurfaceFormat::setDefaultFormat(format);
}

std::unique_ptr<ViewportRenderer> ViewportRenderer::create(QString& why) {
  std::unique_ptr<ViewportRenderer> renderer(new ViewportRenderer);
  if (!renderer->initialise(why)) return nullptr;
  return renderer;
}

bool ViewportRenderer::initialise(QString& why) {
  if (!gl_.initializeOpenGLFunctions()) {
    why = QCoreApplication::translate("ui::Viewport", "This graphics driver has no OpenGL 3.3.");
    return false;
  }
  if (!programs_->build(why)) return false;
  gl_.glGenTextures(1, &shadowMap_);
  gl_.glBindTexture(GL_TEXTURE_2D, shadowMap_);
  gl_.glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kShadowMapSize, kShadowMapSize, 0,
                   GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl_.glGenFramebuffers(1, &shadowBuffer_);
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, shadowBuffer_);
  gl_.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, shadowMap_, 0);
  gl_.glDrawBuffer(GL_NONE);
  gl_.glReadBuffer(GL_NONE);
  scene_ = std::make_unique<GpuScene>(gl_, statistics_);
  return true;
}

void ViewportRenderer::show(const std::shared_ptr<const DrawData>& data) {
  statistics_.uploadedBytes = 0;
  scene_->show(data);
}

void ViewportRenderer::useCamera(QOpenGLShaderProgram& program, const PictureFrame& frame) {
  Eigen::AlignedBox3d all = casters();
  all.extend(frame.camera.target());
  const sim::Vec3 ground = sim::Vec3(1.0, 1.0, 0.0) * groundReach(casters());
  all.extend(sim::Vec3(all.center() + ground));
  all.extend(sim::Vec3(all.center() - ground));
  program.bind();
  program.setUniformValue("clipFromWorld",
                          frame.camera.clipFromView(frame.size, all) * frame.camera.viewFromWorld());
  program.setUniformValue("eye", single(frame.camera.eye()));
  program.setUniformValue("forward", single(frame.camera.forward()));
  program.setUniformValue("orthographic", frame.camera.isOrthographic());
  program.setUniformValue("nodePositions", 0);
  scene_->bindNodePositions();
}

void ViewportRenderer::useLight(QOpenGLShaderProgram& program, const PictureFrame& frame) {
  const bool dark = isDark(frame.colours);
  program.setUniformValue("lightDirection", single(kLight));
  program.setUniformValue("shadowFromWorld", shadowFromWorld_);
  program.setUniformValue("shadowRadius", shadowRadius_);
  program.setUniformValue("shadowOffset", shadowOffset_);
  program.setUniformValue("shadows", scene_->data().settings.shadows && !casters().isEmpty());
  program.setUniformValue("shadowMap", 1);
  program.setUniformValue("occlusion", 2);
  program.setUniformValue("occludes", occludes(scene_->data()));
  program.setUniformValue("skyLight", dark ? QVector3D(0.50F, 0.53F, 0.58F) : QVector3D(0.66F, 0.68F, 0.71F));
  program.setUniformValue("groundLight",
                          dark ? QVector3D(0.13F, 0.13F, 0.135F) : QVector3D(0.33F, 0.32F, 0.31F));
  gl_.glActiveTexture(GL_TEXTURE1);
  gl_.glBindTexture(GL_TEXTURE_2D, shadowMap_);
  if (occludes(scene_->data())) {
    gl_.glActiveTexture(GL_TEXTURE2);
    gl_.glBindTexture(GL_TEXTURE_2D, occlusion_->texture(0));
  }
  gl_.glActiveTexture(GL_TEXTURE0);
}

Eigen::AlignedBox3d ViewportRenderer::casters() const {
  Eigen::AlignedBox3d box = scene_->data().box;
  for (const sim::Collider& collider : scene_->data().colliders) {
    if (collider.visible) box.extend(boxOf(collider));
  }
  return box;
}

void ViewportRenderer::paintShadowMap() {
  const DrawData& data = scene_->data();
  const Eigen::AlignedBox3d box = casters();
  if (!data.settings.shadows || box.isEmpty()) return;
  const auto radius = static_cast<float>(0.5 * box.diagonal().norm() + 1e-3);
  QMatrix4x4 view;
  view.lookAt(single(box.center() + 2.0 * static_cast<double>(radius) * kLight), single(box.center()),
              QVector3D(0.0F, 1.0F, 0.0F));
  QMatrix4x4 clip;
  clip.ortho(-radius, radius, -radius, radius, radius, 3.0F * radius);
  QMatrix4x4 halfAndHalf;
  halfAndHalf.translate(0.5F, 0.5F, 0.5F);
  halfAndHalf.scale(0.5F);
  shadowFromWorld_ = halfAndHalf * clip * view;
  shadowRadius_ = kPenumbra;
  shadowOffset_ = 1.6F * radius * kPenumbra;

  gl_.glBindFramebuffer(GL_FRAMEBUFFER, shadowBuffer_);
  gl_.glViewport(0, 0, kShadowMapSize, kShadowMapSize);
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDepthMask(GL_TRUE);
  gl_.glClear(GL_DEPTH_BUFFER_BIT);
  QOpenGLShaderProgram& program = programs_->solidDepth;
  program.bind();
  program.setUniformValue("clipFromWorld", clip * view);
  program.setUniformValue("nodePositions", 0);
  scene_->bindNodePositions();
  if (data.settings.surface) scene_->drawSurface(program);
  scene_->drawLevel(program);
  for (std::size_t i = 0; i < data.colliders.size(); ++i) {
    if (data.colliders[i].visible) scene_->drawCollider(program, i);
  }
  QOpenGLShaderProgram& balls = programs_->ballPick;
  balls.bind();
  balls.setUniformValue("clipFromWorld", clip * view);
  balls.setUniformValue("forward", single(-kLight));
  balls.setUniformValue("orthographic", true);
  balls.setUniformValue("nodePositions", 0);
  scene_->drawBalls();
}

void ViewportRenderer::paintOcclusion(const PictureFrame& frame) {
  const Eigen::AlignedBox3d box = casters();
  if (!occludes(scene_->data())) return;
  const QSize pixels = (frame.ratio * frame.size).toSize();
  const QSize half(std::max((pixels.width() + 1) / 2, 1), std::max((pixels.height() + 1) / 2, 1));
  places_->bind(gl_, half);
  gl_.glEnable(GL_DEPTH_TEST);
  const std::array<GLfloat, 4> nothing{};
  gl_.glClearBufferfv(GL_COLOR, 1, nothing.data());
  gl_.glClear(GL_DEPTH_BUFFER_BIT);
  identifySolids(frame);
  if (scene_->data().settings.surface) identifySurface(frame);

  occlusion_->bind(gl_, half);
  gl_.glDisable(GL_DEPTH_TEST);
  QOpenGLShaderProgram& program = programs_->occlusion;
  useCamera(program, frame);
  const sim::Vec3 ahead = frame.camera.eye() + frame.camera.forward();
  const double cmAPixel = frame.camera.pixelSize(ahead, frame.size);
  program.setUniformValue("places", 0);
  program.setUniformValue("normals", 3);
  program.setUniformValue("radius", static_cast<float>(kOcclusionReach * box.diagonal().norm()));
  program.setUniformValue("pixelsAtOne", static_cast<float>(0.5 * frame.ratio / cmAPixel));
  gl_.glActiveTexture(GL_TEXTURE3);
  gl_.glBindTexture(GL_TEXTURE_2D, places_->texture(2));
  gl_.glActiveTexture(GL_TEXTURE0);
  gl_.glBindTexture(GL_TEXTURE_2D, places_->texture(1));
  scene_->drawScreen();
  // Read between its pixels, which blurs it.
  gl_.glBindTexture(GL_TEXTURE_2D, occlusion_->texture(0));
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void ViewportRenderer::paintBackground(const PictureFrame& frame) {
  gl_.glDisable(GL_DEPTH_TEST);
  QOpenGLShaderProgram& program = programs_->background;
  program.bind();
  program.setUniformValue("top", rgbOf(frame.colours.viewTop));
  program.setUniformValue("bottom", rgbOf(frame.colours.viewBottom));
  scene_->drawScreen();
  gl_.glEnable(GL_DEPTH_TEST);
}

void ViewportRenderer::paintSolids(const PictureFrame& frame) {
  const DrawData& data = scene_->data();
  QOpenGLShaderProgram& program = programs_->solid;
  useCamera(program, frame);
  useLight(program, frame);
  program.setUniformValue("opacity", 1.0F);
  for (std::size_t i = 0; i < data.colliders.size(); ++i) {
    if (data.colliders[i].visible) scene_->drawCollider(program, i);
  }
  scene_->drawLevel(program);
  if (data.settings.surface && !data.settings.xray) scene_->drawSurface(program);
}

void ViewportRenderer::paintXray(const PictureFrame& frame) {
  const DrawData& data = scene_->data();
  if (!data.settings.surface || !data.settings.xray) return;
  QOpenGLShaderProgram& program = programs_->solid;
  useCamera(program, frame);
  useLight(program, frame);
  program.setUniformValue("opacity", 0.16F);
  gl_.glEnable(GL_BLEND);
  gl_.glDepthMask(GL_FALSE);
  scene_->drawSurface(program);
  gl_.glDepthMask(GL_TRUE);
  gl_.glDisable(GL_BLEND);
}

void ViewportRenderer::paintBalls(const PictureFrame& frame) {
  useCamera(programs_->ball, frame);
  useLight(programs_->ball, frame);
  scene_->drawBalls();
}

void ViewportRenderer::paintBonds(const PictureFrame& frame) {
  const ViewSettings& settings = scene_->data().settings;
  if (!settings.bonds && !settings.gluePairs) return;
  QOpenGLShaderProgram& program = programs_->bond;
  useCamera(program, frame);
  std::array<QVector3D, kViridis.size()> viridis;
  for (std::size_t i = 0; i < viridis.size(); ++i)
    viridis[i] = QVector3D(kViridis[i][0], kViridis[i][1], kViridis[i][2]);
  const bool dark = isDark(frame.colours);
  program.setUniformValueArray("viridis", viridis.data(), static_cast<int>(viridis.size()));
  program.setUniformValue("pixels", QVector2D(static_cast<float>(frame.ratio * frame.size.width()),
                                              static_cast<float>(frame.ratio * frame.size.height())));
  program.setUniformValue("brokenToo", settings.brokenBonds);
  program.setUniformValue("brokenColour", rgbOf(frame.colours.bad));
  program.setUniformValue("slackColour",
                          dark ? QVector3D(0.36F, 0.39F, 0.43F) : QVector3D(0.62F, 0.65F, 0.69F));
  program.setUniformValue("glueColour", rgbOf(frame.colours.accent));
  gl_.glEnable(GL_BLEND);
  if (settings.bonds) {
    program.setUniformValue("glueOnly", false);
    program.setUniformValue("width", static_cast<float>(frame.ratio) * kBondWidth);
    scene_->drawBonds();
  }
  if (settings.gluePairs) {
    // Glue is inside: it shows through.
    gl_.glDisable(GL_DEPTH_TEST);
    program.setUniformValue("glueOnly", true);
    program.setUniformValue("width", static_cast<float>(frame.ratio) * 1.3F * kBondWidth);
    scene_->drawBonds();
    gl_.glEnable(GL_DEPTH_TEST);
  }
  gl_.glDisable(GL_BLEND);
}

void ViewportRenderer::drawGround(QOpenGLShaderProgram& program, const sim::Collider* floor) {
  Eigen::Affine3d worldFromPlane = Eigen::Affine3d::Identity();
  // Near the origin the plane keeps the world's coordinates, so that the grid stands on whole centimetres.
  if (floor != nullptr) worldFromPlane = Eigen::Translation3d(floor->position) * floor->rotation;
  Eigen::AlignedBox3d box = casters();
  if (box.isEmpty()) box.extend(sim::Vec3::Zero());
  const sim::Vec3 about = worldFromPlane.inverse() * box.center();
  const double reach = groundReach(box);
  const Eigen::Matrix<float, 4, 4, Eigen::RowMajor> matrix = worldFromPlane.matrix().cast<float>();
  program.setUniformValue("worldFromModel", QMatrix4x4(matrix.data()));
  program.setUniformValue("about", QVector2D(static_cast<float>(about.x()), static_cast<float>(about.y())));
  program.setUniformValue("reach", static_cast<float>(reach));
  scene_->drawSquare();
}

void ViewportRenderer::paintGround(const PictureFrame& frame) {
  const DrawData& data = scene_->data();
  const bool dark = isDark(frame.colours);
  QOpenGLShaderProgram& program = programs_->ground;
  useCamera(program, frame);
  useLight(program, frame);
  program.setUniformValue("gridColour", rgbOf(frame.colours.grid));
  program.setUniformValue("gridStrongColour", rgbOf(frame.colours.gridStrong));
  program.setUniformValue("axisXColour", rgbOf(frame.colours.axisX));
  program.setUniformValue("axisYColour", rgbOf(frame.colours.axisY));
  program.setUniformValue("axes", true);
  program.setUniformValue("gridOpacity", data.settings.grid ? 1.0F : 0.0F);
  gl_.glEnable(GL_BLEND);
  gl_.glDepthMask(GL_FALSE);
  bool any = false;
  for (const sim::Collider& collider : data.colliders) {
    if (!collider.isFloor() || !collider.visible) continue;
    any = true;
    // From below a floor would hide all there is.
    const bool above =
        (frame.camera.eye() - collider.position).dot(collider.rotation * sim::Vec3::UnitZ()) > 0;
    const QVector3D colour = dark ? QVector3D(0.235F, 0.245F, 0.26F) : QVector3D(0.90F, 0.905F, 0.91F);
    program.setUniformValue("floorColour", QVector4D(colour, above ? 0.85F : 0.0F));
    program.setUniformValue("shadowStrength", above ? (dark ? 0.42F : 0.28F) : 0.0F);
    drawGround(program, &collider);
  }
  if (!any && data.settings.grid) {
    program.setUniformValue("floorColour", QVector4D());
    program.setUniformValue("shadowStrength", 0.0F);
    drawGround(program, nullptr);
  }
  gl_.glDepthMask(GL_TRUE);
  gl_.glDisable(GL_BLEND);
}

void ViewportRenderer::paintOutline(const PictureFrame& frame) {
  if (frame.outlinedParts.empty() && frame.outlinedColliders.empty()) return;
  const QSize pixels = (frame.ratio * frame.size).toSize();
  mask_->bind(gl_, pixels);
  gl_.glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  gl_.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  useCamera(programs_->solidMask, frame);
  for (const sim::PartIndex part : frame.outlinedParts) scene_->drawSurface(programs_->solidMask, part);
  for (const std::size_t collider : frame.outlinedColliders) {
    if (collider < scene_->data().colliders.size()) scene_->drawCollider(programs_->solidMask, collider);
  }
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
  gl_.glViewport(0, 0, pixels.width(), pixels.height());
  gl_.glDisable(GL_DEPTH_TEST);
  gl_.glEnable(GL_BLEND);
  QOpenGLShaderProgram& program = programs_->outline;
  program.bind();
  program.setUniformValue("mask", 0);
  program.setUniformValue("colour", rgbOf(frame.colours.accent));
  program.setUniformValue("width", static_cast<float>(1.8 * frame.ratio));
  gl_.glBindTexture(GL_TEXTURE_2D, mask_->texture(0));
  scene_->drawScreen();
  gl_.glDisable(GL_BLEND);
}

void ViewportRenderer::paint(const PictureFrame& frame) {
  QElapsedTimer timer;
  timer.start();
  statistics_.drawCalls = 0;
  const QSize pixels = (frame.ratio * frame.size).toSize();
  gl_.glDisable(GL_CULL_FACE);
  gl_.glDisable(GL_SCISSOR_TEST);
  gl_.glDisable(GL_STENCIL_TEST);
  gl_.glDisable(GL_BLEND);
  gl_.glEnable(GL_MULTISAMPLE);
  gl_.glDepthFunc(GL_LEQUAL);
  gl_.glDepthMask(GL_TRUE);
  gl_.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (scene_->dataPointer() != shadowOf_) {
    paintShadowMap();
    shadowOf_ = scene_->dataPointer();
  }
  paintOcclusion(frame);
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
  gl_.glViewport(0, 0, pixels.width(), pixels.height());
  gl_.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  paintBackground(frame);
  paintSolids(frame);
  paintBalls(frame);
  paintGround(frame);
  paintBonds(frame);
  paintXray(frame);
  paintOutline(frame);
  gl_.glDisable(GL_DEPTH_TEST);
  gl_.glBindVertexArray(0);
  gl_.glUseProgram(0);
  gl_.glBindBuffer(GL_ARRAY_BUFFER, 0);
  statistics_.paintMilliseconds = 1e-6 * static_cast<double>(timer.nsecsElapsed());
}

}  // namespace ui
