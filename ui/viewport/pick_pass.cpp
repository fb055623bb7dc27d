#include "ui/viewport/pick_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "ui/viewport/identities.h"

namespace ui {
namespace {

/// Device pixels around the pointer, from the lower left corner of the picture.
struct Window {
  int middleX = 0;
  int middleY = 0;
  int left = 0;
  int bottom = 0;
  int width = 0;
  int height = 0;
};

Window windowAround(const PictureFrame& frame, const QPointF& at, int reach) {
  const QSize pixels = pixelsOf(frame);
  Window window;
  window.middleX = static_cast<int>(frame.ratio * at.x());
  window.middleY = pixels.height() - 1 - static_cast<int>(frame.ratio * at.y());
  window.left = std::max(window.middleX - reach, 0);
  window.bottom = std::max(window.middleY - reach, 0);
  window.width = std::min(window.middleX + reach + 1, pixels.width()) - window.left;
  window.height = std::min(window.middleY + reach + 1, pixels.height()) - window.bottom;
  return window;
}

PickedThing thingOf(Identity kind, GLuint index) {
  PickedThing thing;
  thing.index = index;
  switch (kind) {
    case Identity::face:
    case Identity::level:
      thing.kind = Pick::Kind::part;
      thing.index = kind == Identity::level ? sim::kNone : index;
      break;
    case Identity::shard:
      thing.kind = Pick::Kind::part;
      thing.shard = true;
      break;
    case Identity::node:
      thing.kind = Pick::Kind::node;
      break;
    case Identity::bond:
      thing.kind = Pick::Kind::bond;
      break;
    case Identity::collider:
      thing.kind = Pick::Kind::collider;
      break;
    case Identity::nothing:
      break;
  }
  return thing;
}

/// A thing, and the pixel that shows it.
struct Found {
  PickedThing thing;
  int x = 0;
  int y = 0;
};

Found nearestIn(const std::vector<std::array<GLuint, 4>>& identities, const Window& window, int reach) {
  Found nearest;
  int least = std::numeric_limits<int>::max();
  for (int y = 0; y < window.height; ++y) {
    for (int x = 0; x < window.width; ++x) {
      const auto& [number, index, unused, filled] =
          identities[static_cast<std::size_t>(y * window.width + x)];
      const auto identity = static_cast<Identity>(number);
      if (filled == 0 || identity == Identity::nothing) continue;
      const int awayX = window.left + x - window.middleX;
      const int awayY = window.bottom + y - window.middleY;
      // Nodes and bonds are small: they win over what is larger, from a few pixels away.
      const bool small = identity == Identity::node || identity == Identity::bond;
      const int squared = awayX * awayX + awayY * awayY;
      const int cost = small ? squared : squared + reach * reach;
      if ((!small && squared > 1) || cost >= least) continue;
      least = cost;
      nearest = {thingOf(identity, index), window.left + x, window.bottom + y};
    }
  }
  return nearest;
}

/// Reads from the target that is bound what was drawn there.
PickedThing readNearest(Gl& gl, const Window& window, int reach) {
  if (window.width <= 0 || window.height <= 0) return {};
  std::vector<std::array<GLuint, 4>> identities(static_cast<std::size_t>(window.width * window.height));
  gl.glReadBuffer(GL_COLOR_ATTACHMENT0);
  gl.glReadPixels(window.left, window.bottom, window.width, window.height, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                  identities.data());
  Found nearest = nearestIn(identities, window, reach);
  if (nearest.thing.kind == Pick::Kind::nothing) return nearest.thing;
  std::array<GLfloat, 4> place{};
  std::array<GLfloat, 4> facing{};
  gl.glReadBuffer(GL_COLOR_ATTACHMENT1);
  gl.glReadPixels(nearest.x, nearest.y, 1, 1, GL_RGBA, GL_FLOAT, place.data());
  gl.glReadBuffer(GL_COLOR_ATTACHMENT2);
  gl.glReadPixels(nearest.x, nearest.y, 1, 1, GL_RGBA, GL_FLOAT, facing.data());
  nearest.thing.point = Eigen::Map<const Eigen::Vector3f>(place.data()).cast<double>();
  const sim::Vec3 normal = Eigen::Map<const Eigen::Vector3f>(facing.data()).cast<double>();
  if (normal.norm() > 0.0) nearest.thing.normal = normal.normalized();
  return nearest.thing;
}

}  // namespace

PickPass::PickPass()
    : target_(std::vector<GlTarget::Format>{{GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT},
                                            {GL_RGBA32F, GL_RGBA, GL_FLOAT},
                                            {GL_RGBA16F, GL_RGBA, GL_FLOAT}}) {}

PickedThing PickPass::pick(RenderContext& context, const PictureFrame& frame, const QPointF& at,
                           double reach) {
  Gl& gl = context.gl;
  const QSize pixels = pixelsOf(frame);
  const int pixelReach = static_cast<int>(std::ceil(reach * frame.ratio));
  target_.bind(gl, pixels);
  gl.glEnable(GL_SCISSOR_TEST);
  gl.glScissor(static_cast<int>(frame.ratio * at.x()) - pixelReach,
               pixels.height() - 1 - static_cast<int>(frame.ratio * at.y()) - pixelReach, 2 * pixelReach + 1,
               2 * pixelReach + 1);
  gl.glDisable(GL_BLEND);
  gl.glDisable(GL_CULL_FACE);
  gl.glEnable(GL_DEPTH_TEST);
  gl.glDepthMask(GL_TRUE);
  gl.glDepthFunc(GL_LEQUAL);
  const std::array<GLuint, 4> none{};
  gl.glClearBufferuiv(GL_COLOR, 0, none.data());
  gl.glClear(GL_DEPTH_BUFFER_BIT);
  identifySolids(context, frame);
  identifyBodies(context, frame, reach);
  const PickedThing thing = readNearest(gl, windowAround(frame, at, pixelReach), pixelReach);
  gl.glDisable(GL_SCISSOR_TEST);
  gl.glDisable(GL_DEPTH_TEST);
  gl.glBindVertexArray(0);
  gl.glUseProgram(0);
  gl.glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
  return thing;
}

}  // namespace ui
