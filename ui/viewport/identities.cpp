#include "ui/viewport/identities.h"

#include <algorithm>

namespace ui {
namespace {

constexpr double kBondReach = 3.0;  ///< logical pixels

void identifyFaces(RenderContext& context, QOpenGLShaderProgram& program, const PictureFrame& frame) {
  if (frame.marked.passedParts.empty() || !context.data().topology) {
    context.scene.drawFacesOfCells(program);
    return;
  }
  for (const TopologyDraw::Range& range : context.data().topology->partFaces) {
    if (std::ranges::find(frame.marked.passedParts, range.part) != frame.marked.passedParts.end()) continue;
    // Primitives are counted anew in each call.
    program.setUniformValue("firstIndex", static_cast<GLint>(range.first));
    context.scene.drawFacesOfCells(program, range);
  }
  program.setUniformValue("firstIndex", 0);
}

}  // namespace

void identifySolids(RenderContext& context, const PictureFrame& frame) {
  const DrawData& data = context.data();
  const auto passes = [&](std::size_t collider) {
    return std::ranges::find(frame.marked.passedColliders, collider) != frame.marked.passedColliders.end();
  };
  QOpenGLShaderProgram& ground = context.programs.groundPick;
  useCamera(context, ground, frame);
  ground.setUniformValue("kind", static_cast<GLint>(Identity::collider));
  for (std::size_t i = 0; i < data.colliders.size(); ++i) {
    const sim::Collider& collider = data.colliders[i];
    if (!collider.isFloor() || !collider.visible || passes(i)) continue;
    if (!isSeenFromAbove(collider, frame)) continue;
    ground.setUniformValue("firstIndex", static_cast<GLint>(i));
    drawGround(context, ground, &collider);
  }
  QOpenGLShaderProgram& solid = context.programs.solidPick;
  useCamera(context, solid, frame);
  solid.setUniformValue("kind", static_cast<GLint>(Identity::collider));
  solid.setUniformValue("primitivesEach", 0);
  for (std::size_t i = 0; i < data.colliders.size(); ++i) {
    if (!data.colliders[i].visible || passes(i)) continue;
    solid.setUniformValue("firstIndex", static_cast<GLint>(i));
    context.scene.drawCollider(solid, i);
  }
  solid.setUniformValue("kind", static_cast<GLint>(Identity::level));
  solid.setUniformValue("firstIndex", 0);
  context.scene.drawLevel(solid);
}

void identifySurface(RenderContext& context, const PictureFrame& frame) {
  QOpenGLShaderProgram& solid = context.programs.solidPick;
  useCamera(context, solid, frame);
  solid.setUniformValue("firstIndex", 0);
  solid.setUniformValue("kind", static_cast<GLint>(Identity::face));
  solid.setUniformValue("primitivesEach", 2);
  identifyFaces(context, solid, frame);
  solid.setUniformValue("kind", static_cast<GLint>(Identity::shard));
  solid.setUniformValue("primitivesEach", 1);
  context.scene.drawShards(solid);
}

void identifyBodies(RenderContext& context, const PictureFrame& frame, double reach) {
  const ViewSettings& settings = context.data().settings;
  // Who looks through the surface at nodes or bonds means those.
  const bool seesThrough = settings.xray && (settings.nodes || settings.bonds);
  if (settings.surface && !seesThrough) identifySurface(context, frame);
  if (settings.bonds) {
    QOpenGLShaderProgram& bond = context.programs.bondPick;
    useCamera(context, bond, frame);
    bond.setUniformValue("kind", static_cast<GLint>(Identity::bond));
    bond.setUniformValue("pixels", QVector2D(static_cast<float>(frame.ratio * frame.size.width()),
                                             static_cast<float>(frame.ratio * frame.size.height())));
    bond.setUniformValue("brokenToo", settings.brokenBonds);
    bond.setUniformValue("glueOnly", false);
    bond.setUniformValue("width", static_cast<float>(frame.ratio * std::min(reach, kBondReach)));
    context.scene.drawBonds();
  }
  QOpenGLShaderProgram& ball = context.programs.ballPick;
  useCamera(context, ball, frame);
  ball.setUniformValue("kind", static_cast<GLint>(Identity::node));
  context.scene.drawBalls();
}

}  // namespace ui
