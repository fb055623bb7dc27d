#include "ui/viewport/shadow_pass.h"

namespace ui {
namespace {

constexpr GLsizei kShadowMapSize = 2048;
/// Of the penumbra, relative to what casts shadows.
constexpr float kPenumbra = 0.008F;

}  // namespace

const sim::Vec3& lightDirection() {
  // From the front left above, as a photographer would for someone who looks from the front.
  static const sim::Vec3 light = sim::Vec3(-0.45, -0.55, 1.0).normalized();
  return light;
}

void ShadowPass::make(Gl& gl) {
  gl.glGenTextures(1, &map_);
  gl.glBindTexture(GL_TEXTURE_2D, map_);
  gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kShadowMapSize, kShadowMapSize, 0,
                  GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl.glGenFramebuffers(1, &buffer_);
  gl.glBindFramebuffer(GL_FRAMEBUFFER, buffer_);
  gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map_, 0);
  gl.glDrawBuffer(GL_NONE);
  gl.glReadBuffer(GL_NONE);
}

void ShadowPass::destroy(Gl& gl) {
  gl.glDeleteFramebuffers(1, &buffer_);
  gl.glDeleteTextures(1, &map_);
}

void ShadowPass::paint(RenderContext& context) {
  if (context.scene.dataPointer() == of_) return;
  of_ = context.scene.dataPointer();
  const DrawData& data = context.data();
  const Eigen::AlignedBox3d box = castersOf(data);
  if (!data.settings.shadows || box.isEmpty()) return;
  const auto radius = static_cast<float>(0.5 * box.diagonal().norm() + 1e-3);
  QMatrix4x4 view;
  view.lookAt(single(box.center() + 2.0 * static_cast<double>(radius) * lightDirection()),
              single(box.center()), QVector3D(0.0F, 1.0F, 0.0F));
  QMatrix4x4 clip;
  clip.ortho(-radius, radius, -radius, radius, radius, 3.0F * radius);
  QMatrix4x4 halfAndHalf;
  halfAndHalf.translate(0.5F, 0.5F, 0.5F);
  halfAndHalf.scale(0.5F);
  shadowFromWorld_ = halfAndHalf * clip * view;
  radius_ = kPenumbra;
  offset_ = 1.6F * radius * kPenumbra;
  drawCasters(context, clip, view);
}

void ShadowPass::drawCasters(RenderContext& context, const QMatrix4x4& clip, const QMatrix4x4& view) {
  const DrawData& data = context.data();
  Gl& gl = context.gl;
  GpuScene& scene = context.scene;
  gl.glBindFramebuffer(GL_FRAMEBUFFER, buffer_);
  gl.glViewport(0, 0, kShadowMapSize, kShadowMapSize);
  gl.glEnable(GL_DEPTH_TEST);
  gl.glDepthMask(GL_TRUE);
  gl.glClear(GL_DEPTH_BUFFER_BIT);
  QOpenGLShaderProgram& program = context.programs.solidDepth;
  program.bind();
  program.setUniformValue("clipFromWorld", clip * view);
  program.setUniformValue("nodePositions", 0);
  scene.bindNodePositions();
  if (data.settings.surface) scene.drawSurface(program);
  scene.drawLevel(program);
  for (std::size_t i = 0; i < data.colliders.size(); ++i) {
    if (data.colliders[i].visible) scene.drawCollider(program, i);
  }
  QOpenGLShaderProgram& balls = context.programs.ballPick;
  balls.bind();
  balls.setUniformValue("clipFromWorld", clip * view);
  balls.setUniformValue("forward", single(-lightDirection()));
  balls.setUniformValue("orthographic", true);
  balls.setUniformValue("nodePositions", 0);
  scene.drawBalls();
}

void ShadowPass::use(RenderContext& context, QOpenGLShaderProgram& program) const {
  const DrawData& data = context.data();
  program.setUniformValue("shadowFromWorld", shadowFromWorld_);
  program.setUniformValue("shadowRadius", radius_);
  program.setUniformValue("shadowOffset", offset_);
  program.setUniformValue("shadows", data.settings.shadows && !castersOf(data).isEmpty());
  program.setUniformValue("shadowMap", 1);
  context.gl.glActiveTexture(GL_TEXTURE1);
  context.gl.glBindTexture(GL_TEXTURE_2D, map_);
  context.gl.glActiveTexture(GL_TEXTURE0);
}

}  // namespace ui
