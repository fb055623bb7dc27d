#include "ui/viewport/render_context.h"

#include <algorithm>

#include "ui/viewport/collider_shape.h"

namespace ui {
namespace {

/// How far floor and grid reach, cm.
double groundReach(const Eigen::AlignedBox3d& box) {
  return std::max(60.0, box.isEmpty() ? 0.0 : 5.0 * box.diagonal().norm());
}

}  // namespace

QVector3D single(const sim::Vec3& vector) {
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()), static_cast<float>(vector.z())};
}

QVector3D rgbOf(const QColor& colour) {
  return {static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()),
          static_cast<float>(colour.blueF())};
}

Eigen::AlignedBox3d castersOf(const DrawData& data) {
  Eigen::AlignedBox3d box = data.box;
  for (const sim::Collider& collider : data.colliders) {
    if (collider.visible) box.extend(boxOf(collider));
  }
  return box;
}

QSize pixelsOf(const PictureFrame& frame) {
  return (frame.ratio * frame.size).toSize();
}

void useCamera(RenderContext& context, QOpenGLShaderProgram& program, const PictureFrame& frame) {
  const Eigen::AlignedBox3d casters = castersOf(context.data());
  Eigen::AlignedBox3d all = casters;
  all.extend(frame.camera.target());
  const sim::Vec3 ground = sim::Vec3(1.0, 1.0, 0.0) * groundReach(casters);
  all.extend(sim::Vec3(all.center() + ground));
  all.extend(sim::Vec3(all.center() - ground));
  program.bind();
  program.setUniformValue("clipFromWorld",
                          frame.camera.clipFromView(frame.size, all) * frame.camera.viewFromWorld());
  program.setUniformValue("eye", single(frame.camera.eye()));
  program.setUniformValue("forward", single(frame.camera.forward()));
  program.setUniformValue("orthographic", frame.camera.isOrthographic());
  program.setUniformValue("nodePositions", 0);
  context.scene.bindNodePositions();
}

void drawGround(RenderContext& context, QOpenGLShaderProgram& program, const sim::Collider* floor) {
  Eigen::Affine3d worldFromPlane = Eigen::Affine3d::Identity();
  // Near the origin the plane keeps the world's coordinates, so that the grid stands on whole centimetres.
  if (floor != nullptr) worldFromPlane = Eigen::Translation3d(floor->position) * floor->rotation;
  Eigen::AlignedBox3d box = castersOf(context.data());
  if (box.isEmpty()) box.extend(sim::Vec3::Zero());
  const sim::Vec3 about = worldFromPlane.inverse() * box.center();
  const double reach = groundReach(box);
  const Eigen::Matrix<float, 4, 4, Eigen::RowMajor> matrix = worldFromPlane.matrix().cast<float>();
  program.setUniformValue("worldFromModel", QMatrix4x4(matrix.data()));
  program.setUniformValue("about", QVector2D(static_cast<float>(about.x()), static_cast<float>(about.y())));
  program.setUniformValue("reach", static_cast<float>(reach));
  context.scene.drawSquare();
}

bool isSeenFromAbove(const sim::Collider& floor, const PictureFrame& frame) {
  return (frame.camera.eye() - floor.position).dot(floor.rotation * sim::Vec3::UnitZ()) > 0;
}

}  // namespace ui
