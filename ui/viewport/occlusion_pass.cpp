#include "ui/viewport/occlusion_pass.h"

#include <algorithm>
#include <array>

#include "ui/viewport/identities.h"

namespace ui {
namespace {

/// How far off something darkens a corner, relative to all there is.
constexpr double kReach = 0.10;

/// It is the surface that occludes, where there is one; through one that is transparent it would be seen
/// where nothing is.
bool occludes(const DrawData& data) {
  if (data.box.isEmpty()) return false;
  const ViewSettings& settings = data.settings;
  return settings.occlusion && !settings.xray && (settings.surface || settings.levelSurface);
}

}  // namespace

OcclusionPass::OcclusionPass()
    : places_(std::vector<GlTarget::Format>{{GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE},
                                            {GL_RGBA32F, GL_RGBA, GL_FLOAT},
                                            {GL_RGBA16F, GL_RGBA, GL_FLOAT}}),
      result_(std::vector<GlTarget::Format>{{GL_R8, GL_RED, GL_UNSIGNED_BYTE}}) {}

void OcclusionPass::destroy(Gl& gl) {
  places_.destroy(gl);
  result_.destroy(gl);
}

void OcclusionPass::paint(RenderContext& context, const PictureFrame& frame) {
  if (!occludes(context.data())) return;
  Gl& gl = context.gl;
  const QSize pixels = pixelsOf(frame);
  const QSize half(std::max((pixels.width() + 1) / 2, 1), std::max((pixels.height() + 1) / 2, 1));
  places_.bind(gl, half);
  gl.glEnable(GL_DEPTH_TEST);
  const std::array<GLfloat, 4> nothing{};
  gl.glClearBufferfv(GL_COLOR, 1, nothing.data());
  gl.glClear(GL_DEPTH_BUFFER_BIT);
  identifySolids(context, frame);
  if (context.data().settings.surface) identifySurface(context, frame);

  result_.bind(gl, half);
  gl.glDisable(GL_DEPTH_TEST);
  QOpenGLShaderProgram& program = context.programs.occlusion;
  useCamera(context, program, frame);
  const sim::Vec3 ahead = frame.camera.eye() + frame.camera.forward();
  const double cmAPixel = frame.camera.pixelSize(ahead, frame.size);
  program.setUniformValue("places", 0);
  program.setUniformValue("normals", 3);
  program.setUniformValue("radius", static_cast<float>(kReach * castersOf(context.data()).diagonal().norm()));
  program.setUniformValue("pixelsAtOne", static_cast<float>(0.5 * frame.ratio / cmAPixel));
  gl.glActiveTexture(GL_TEXTURE3);
  gl.glBindTexture(GL_TEXTURE_2D, places_.texture(2));
  gl.glActiveTexture(GL_TEXTURE0);
  gl.glBindTexture(GL_TEXTURE_2D, places_.texture(1));
  context.scene.drawScreen();
  // Read between its pixels, which blurs it.
  gl.glBindTexture(GL_TEXTURE_2D, result_.texture(0));
  gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void OcclusionPass::use(RenderContext& context, QOpenGLShaderProgram& program) const {
  const bool used = occludes(context.data());
  program.setUniformValue("occlusion", 2);
  program.setUniformValue("occludes", used);
  if (!used) return;
  context.gl.glActiveTexture(GL_TEXTURE2);
  context.gl.glBindTexture(GL_TEXTURE_2D, result_.texture(0));
  context.gl.glActiveTexture(GL_TEXTURE0);
}

}  // namespace ui
