#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ui/viewport/gl_programs.h"
#include "ui/viewport/gl_target.h"
#include "ui/viewport/gpu_scene.h"
#include "ui/viewport/viewport_renderer.h"

namespace ui {
namespace {

/// What stands in the first number of a pixel. Uniforms are signed, since Qt sets no others.
enum : GLuint { kNothing, kFace, kShard, kNode, kBond, kCollider, kLevel };

/// Wider than it is drawn, so that a hand can hit it; logical pixels.
constexpr double kBondReach = 3.0;

PickedThing thingOf(GLuint kind, GLuint index) {
  PickedThing thing;
  thing.index = index;
  switch (kind) {
    case kFace:
    case kLevel:
      thing.kind = Pick::Kind::part;
      thing.index = kind == kLevel ? sim::kNone : index;
      break;
    case kShard:
      thing.kind = Pick::Kind::part;
      thing.shard = true;
      break;
    case kNode:
      thing.kind = Pick::Kind::node;
      break;
    case kBond:
      thing.kind = Pick::Kind::bond;
      break;
    case kCollider:
      thing.kind = Pick::Kind::collider;
      break;
    default:
      break;
  }
  return thing;
}

}  // namespace

void ViewportRenderer::identifySolids(const PictureFrame& frame) {
  const DrawData& data = scene_->data();
  const auto passes = [&](std::size_t collider) {
    return std::ranges::find(frame.passedColliders, collider) != frame.passedColliders.end();
  };
  QOpenGLShaderProgram& ground = programs_->groundPick;
  useCamera(ground, frame);
  ground.setUniformValue("kind", static_cast<GLint>(kCollider));
  for (std::size_t i = 0; i < data.colliders.size(); ++i) {
    const sim::Collider& collider = data.colliders[i];
    const bool above =
        (frame.camera.eye() - collider.position).dot(collider.rotation * sim::Vec3::UnitZ()) > 0;
    if (!collider.isFloor() || !collider.visible || !above || passes(i)) continue;
    ground.setUniformValue("firstIndex", static_cast<GLint>(i));
    drawGround(ground, &collider);
  }
  QOpenGLShaderProgram& solid = programs_->solidPick;
  useCamera(solid, frame);
  solid.setUniformValue("kind", static_cast<GLint>(kCollider));
  solid.setUniformValue("primitivesEach", 0);
  for (std::size_t i = 0; i < data.colliders.size(); ++i) {
    if (!data.colliders[i].visible || passes(i)) continue;
    solid.setUniformValue("firstIndex", static_cast<GLint>(i));
    scene_->drawCollider(solid, i);
  }
  solid.setUniformValue("kind", static_cast<GLint>(kLevel));
  solid.setUniformValue("firstIndex", 0);
  scene_->drawLevel(solid);
}

void ViewportRenderer::identifyFaces(QOpenGLShaderProgram& program, const PictureFrame& frame) {
  if (frame.passedParts.empty() || !scene_->data().topology) {
    scene_->drawFacesOfCells(program);
    return;
  }
  for (const TopologyDraw::Range& range : scene_->data().topology->partFaces) {
    if (std::ranges::find(frame.passedParts, range.part) != frame.passedParts.end()) continue;
    // Primitives are counted anew in each call.
    program.setUniformValue("firstIndex", static_cast<GLint>(range.first));
    scene_->drawFacesOfCells(program, range);
  }
  program.setUniformValue("firstIndex", 0);
}

void ViewportRenderer::identifySurface(const PictureFrame& frame) {
  QOpenGLShaderProgram& solid = programs_->solidPick;
  useCamera(solid, frame);
  solid.setUniformValue("firstIndex", 0);
  solid.setUniformValue("kind", static_cast<GLint>(kFace));
  solid.setUniformValue("primitivesEach", 2);
  identifyFaces(solid, frame);
  solid.setUniformValue("kind", static_cast<GLint>(kShard));
  solid.setUniformValue("primitivesEach", 1);
  scene_->drawShards(solid);
}

void ViewportRenderer::identifyLattice(const PictureFrame& frame, double reach) {
  const ViewSettings& settings = scene_->data().settings;
  // Who looks through the surface at nodes or bonds means those.
  const bool seesThrough = settings.xray && (settings.nodes || settings.bonds);
  if (settings.surface && !seesThrough) identifySurface(frame);
  if (settings.bonds) {
    QOpenGLShaderProgram& bond = programs_->bondPick;
    useCamera(bond, frame);
    bond.setUniformValue("kind", static_cast<GLint>(kBond));
    bond.setUniformValue("pixels", QVector2D(static_cast<float>(frame.ratio * frame.size.width()),
                                             static_cast<float>(frame.ratio * frame.size.height())));
    bond.setUniformValue("brokenToo", settings.brokenBonds);
    bond.setUniformValue("glueOnly", false);
    bond.setUniformValue("width", static_cast<float>(frame.ratio * std::min(reach, kBondReach)));
    scene_->drawBonds();
  }
  QOpenGLShaderProgram& ball = programs_->ballPick;
  useCamera(ball, frame);
  ball.setUniformValue("kind", static_cast<GLint>(kNode));
  scene_->drawBalls();
}

PickedThing ViewportRenderer::readNearest(const PictureFrame& frame, const QPointF& at, int reach) {
  const QSize pixels = (frame.ratio * frame.size).toSize();
  const int middleX = static_cast<int>(frame.ratio * at.x());
  const int middleY = pixels.height() - 1 - static_cast<int>(frame.ratio * at.y());
  const int left = std::max(middleX - reach, 0);
  const int bottom = std::max(middleY - reach, 0);
  const int width = std::min(middleX + reach + 1, pixels.width()) - left;
  const int height = std::min(middleY + reach + 1, pixels.height()) - bottom;
  if (width <= 0 || height <= 0) return {};
  std::vector<std::array<GLuint, 4>> identities(static_cast<std::size_t>(width * height));
  gl_.glReadBuffer(GL_COLOR_ATTACHMENT0);
  gl_.glReadPixels(left, bottom, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, identities.data());

  PickedThing nearest;
  int nearestX = 0;
  int nearestY = 0;
  int least = std::numeric_limits<int>::max();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto& [kind, index, unused, filled] = identities[static_cast<std::size_t>(y * width + x)];
      if (filled == 0 || kind == kNothing) continue;
      const int awayX = left + x - middleX;
      const int awayY = bottom + y - middleY;
      // Nodes and bonds are small: they win over what is larger, from a few pixels away.
      const bool small = kind == kNode || kind == kBond;
      const int squared = awayX * awayX + awayY * awayY;
      const int cost = small ? squared : squared + reach * reach;
      if ((!small && squared > 1) || cost >= least) continue;
      least = cost;
      nearest = thingOf(kind, index);
      nearestX = left + x;
      nearestY = bottom + y;
    }
  }
  if (nearest.kind == Pick::Kind::nothing) return nearest;
  std::array<GLfloat, 4> place{};
  std::array<GLfloat, 4> facing{};
  gl_.glReadBuffer(GL_COLOR_ATTACHMENT1);
  gl_.glReadPixels(nearestX, nearestY, 1, 1, GL_RGBA, GL_FLOAT, place.data());
  gl_.glReadBuffer(GL_COLOR_ATTACHMENT2);
  gl_.glReadPixels(nearestX, nearestY, 1, 1, GL_RGBA, GL_FLOAT, facing.data());
  nearest.point = Eigen::Map<const Eigen::Vector3f>(place.data()).cast<double>();
  const sim::Vec3 normal = Eigen::Map<const Eigen::Vector3f>(facing.data()).cast<double>();
  if (normal.norm() > 0.0) nearest.normal = normal.normalized();
  return nearest;
}

PickedThing ViewportRenderer::pick(const PictureFrame& frame, const QPointF& at, double reach) {
  const QSize pixels = (frame.ratio * frame.size).toSize();
  const int pixelReach = static_cast<int>(std::ceil(reach * frame.ratio));
  identities_->bind(gl_, pixels);
  gl_.glEnable(GL_SCISSOR_TEST);
  gl_.glScissor(static_cast<int>(frame.ratio * at.x()) - pixelReach,
                pixels.height() - 1 - static_cast<int>(frame.ratio * at.y()) - pixelReach, 2 * pixelReach + 1,
                2 * pixelReach + 1);
  gl_.glDisable(GL_BLEND);
  gl_.glDisable(GL_CULL_FACE);
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDepthMask(GL_TRUE);
  gl_.glDepthFunc(GL_LEQUAL);
  const std::array<GLuint, 4> none{};
  gl_.glClearBufferuiv(GL_COLOR, 0, none.data());
  gl_.glClear(GL_DEPTH_BUFFER_BIT);
  identifySolids(frame);
  identifyLattice(frame, reach);
  const PickedThing thing = readNearest(frame, at, pixelReach);
  gl_.glDisable(GL_SCISSOR_TEST);
  gl_.glDisable(GL_DEPTH_TEST);
  gl_.glBindVertexArray(0);
  gl_.glUseProgram(0);
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
  return thing;
}

}  // namespace ui
