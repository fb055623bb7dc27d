#include "ui/viewport/viewport_renderer.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QSurfaceFormat>
#include <array>

#include "ui/theme/theme.h"
#include "ui/viewport/colour_map.h"

namespace ui {
namespace {

constexpr float kBondWidth = 1.4F;  ///< logical pixels

bool isDark(const Colours& colours) {
  return colours.viewBottom.lightnessF() < 0.5F;
}

}  // namespace

ViewportRenderer::ViewportRenderer()
    : mask_(std::vector<GlTarget::Format>{{GL_R8, GL_RED, GL_UNSIGNED_BYTE}}) {}

ViewportRenderer::~ViewportRenderer() {
  if (!scene_) return;
  mask_.destroy(gl_);
  picking_.destroy(gl_);
  occlusion_.destroy(gl_);
  shadow_.destroy(gl_);
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
  if (!programs_.build(why)) return false;
  shadow_.make(gl_);
  scene_ = std::make_unique<GpuScene>(gl_, statistics_);
  context_.emplace(RenderContext{gl_, programs_, *scene_});
  return true;
}

void ViewportRenderer::show(const std::shared_ptr<const DrawData>& data) {
  statistics_.uploadedBytes = 0;
  scene_->show(data);
}

void ViewportRenderer::useLight(QOpenGLShaderProgram& program, const PictureFrame& frame) {
  const bool dark = isDark(frame.colours);
  program.setUniformValue("lightDirection", single(lightDirection()));
  shadow_.use(*context_, program);
  occlusion_.use(*context_, program);
  program.setUniformValue("skyLight", dark ? QVector3D(0.50F, 0.53F, 0.58F) : QVector3D(0.66F, 0.68F, 0.71F));
  program.setUniformValue("groundLight",
                          dark ? QVector3D(0.13F, 0.13F, 0.135F) : QVector3D(0.33F, 0.32F, 0.31F));
}

void ViewportRenderer::paintBackground(const PictureFrame& frame) {
  gl_.glDisable(GL_DEPTH_TEST);
  QOpenGLShaderProgram& program = programs_.background;
  program.bind();
  program.setUniformValue("top", rgbOf(frame.colours.viewTop));
  program.setUniformValue("bottom", rgbOf(frame.colours.viewBottom));
  scene_->drawScreen();
  gl_.glEnable(GL_DEPTH_TEST);
}

void ViewportRenderer::paintSolids(const PictureFrame& frame) {
  const DrawData& data = context_->data();
  QOpenGLShaderProgram& program = programs_.solid;
  useCamera(*context_, program, frame);
  useLight(program, frame);
  program.setUniformValue("opacity", 1.0F);
  for (std::size_t i = 0; i < data.colliders.size(); ++i) {
    if (data.colliders[i].visible) scene_->drawCollider(program, i);
  }
  scene_->drawLevel(program);
  if (data.settings.surface && !data.settings.xray) scene_->drawSurface(program);
}

void ViewportRenderer::paintXray(const PictureFrame& frame) {
  const DrawData& data = context_->data();
  if (!data.settings.surface || !data.settings.xray) return;
  QOpenGLShaderProgram& program = programs_.solid;
  useCamera(*context_, program, frame);
  useLight(program, frame);
  program.setUniformValue("opacity", 0.16F);
  gl_.glEnable(GL_BLEND);
  gl_.glDepthMask(GL_FALSE);
  scene_->drawSurface(program);
  gl_.glDepthMask(GL_TRUE);
  gl_.glDisable(GL_BLEND);
}

void ViewportRenderer::paintBalls(const PictureFrame& frame) {
  useCamera(*context_, programs_.ball, frame);
  useLight(programs_.ball, frame);
  scene_->drawBalls();
}

void ViewportRenderer::paintBonds(const PictureFrame& frame) {
  const ViewSettings& settings = context_->data().settings;
  if (!settings.bonds && !settings.gluePairs) return;
  QOpenGLShaderProgram& program = programs_.bond;
  useCamera(*context_, program, frame);
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

void ViewportRenderer::paintGround(const PictureFrame& frame) {
  const DrawData& data = context_->data();
  const bool dark = isDark(frame.colours);
  QOpenGLShaderProgram& program = programs_.ground;
  useCamera(*context_, program, frame);
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
    const bool above = isSeenFromAbove(collider, frame);
    const QVector3D colour = dark ? QVector3D(0.235F, 0.245F, 0.26F) : QVector3D(0.90F, 0.905F, 0.91F);
    program.setUniformValue("floorColour", QVector4D(colour, above ? 0.85F : 0.0F));
    program.setUniformValue("shadowStrength", above ? (dark ? 0.42F : 0.28F) : 0.0F);
    drawGround(*context_, program, &collider);
  }
  if (!any && data.settings.grid) {
    program.setUniformValue("floorColour", QVector4D());
    program.setUniformValue("shadowStrength", 0.0F);
    drawGround(*context_, program, nullptr);
  }
  gl_.glDepthMask(GL_TRUE);
  gl_.glDisable(GL_BLEND);
}

void ViewportRenderer::paintOutline(const PictureFrame& frame) {
  if (frame.marked.outlinedParts.empty() && frame.marked.outlinedColliders.empty()) return;
  const QSize pixels = pixelsOf(frame);
  mask_.bind(gl_, pixels);
  gl_.glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  gl_.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  useCamera(*context_, programs_.solidMask, frame);
  for (const sim::PartIndex part : frame.marked.outlinedParts) scene_->drawSurface(programs_.solidMask, part);
  for (const std::size_t collider : frame.marked.outlinedColliders) {
    if (collider < context_->data().colliders.size()) scene_->drawCollider(programs_.solidMask, collider);
  }
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
  gl_.glViewport(0, 0, pixels.width(), pixels.height());
  gl_.glDisable(GL_DEPTH_TEST);
  gl_.glEnable(GL_BLEND);
  QOpenGLShaderProgram& program = programs_.outline;
  program.bind();
  program.setUniformValue("mask", 0);
  program.setUniformValue("colour", rgbOf(frame.colours.accent));
  program.setUniformValue("width", static_cast<float>(1.8 * frame.ratio));
  gl_.glBindTexture(GL_TEXTURE_2D, mask_.texture(0));
  scene_->drawScreen();
  gl_.glDisable(GL_BLEND);
}

void ViewportRenderer::paint(const PictureFrame& frame) {
  QElapsedTimer timer;
  timer.start();
  statistics_.drawCalls = 0;
  const QSize pixels = pixelsOf(frame);
  gl_.glDisable(GL_CULL_FACE);
  gl_.glDisable(GL_SCISSOR_TEST);
  gl_.glDisable(GL_STENCIL_TEST);
  gl_.glDisable(GL_BLEND);
  gl_.glEnable(GL_MULTISAMPLE);
  gl_.glDepthFunc(GL_LEQUAL);
  gl_.glDepthMask(GL_TRUE);
  gl_.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  shadow_.paint(*context_);
  occlusion_.paint(*context_, frame);
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

PickedThing ViewportRenderer::pick(const PictureFrame& frame, const QPointF& at, double reach) {
  return picking_.pick(*context_, frame, at, reach);
}

}  // namespace ui
