#pragma once

#include <QColor>
#include <QVector3D>

#include "ui/viewport/gl_programs.h"
#include "ui/viewport/gpu_scene.h"
#include "ui/viewport/picture_frame.h"

/// What all passes of a picture share. Used with the context current.
namespace ui {

/// What draws, and what is drawn.
struct RenderContext {
  Gl& gl;
  GlPrograms& programs;
  GpuScene& scene;

  const DrawData& data() const { return scene.data(); }
};

QVector3D single(const sim::Vec3& vector);
QVector3D rgbOf(const QColor& colour);

/// Around all bodies and visible colliders, cm.
Eigen::AlignedBox3d castersOf(const DrawData& data);
/// The frame in device pixels.
QSize pixelsOf(const PictureFrame& frame);
/// Binds the program and tells it from where the frame is seen.
void useCamera(RenderContext& context, QOpenGLShaderProgram& program, const PictureFrame& frame);
/// A large square in the plane of the floor; where there is none, in that of the world's axes x and y.
void drawGround(RenderContext& context, QOpenGLShaderProgram& program, const sim::Collider* floor);
/// Whether the eye is on the side of the floor that things stand on: from below it would hide all there is.
bool isSeenFromAbove(const sim::Collider& floor, const PictureFrame& frame);

}  // namespace ui
