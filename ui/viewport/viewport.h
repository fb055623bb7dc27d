#pragma once

#include <QOpenGLWidget>
#include <memory>

#include "ui/session/session.h"
#include "ui/viewport/tool.h"
#include "ui/viewport/view_camera.h"

namespace ui {

class ViewportRenderer;

/// The picture of what the session shows, with navigation, picking and tools.
class Viewport : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit Viewport(Session& session, QWidget* parent = nullptr);
  ~Viewport() override;

  Session& session() { return session_; }
  const ViewCamera& camera() const { return camera_; }
  ViewCamera& camera() { return camera_; }
  QSizeF viewSize() const { return QSizeF(size()); }

  void frameAll();
  /// The parts and colliders that are selected; everything where none is.
  void frameSelection();

  Pick pickAt(const QPointF& pixel);
  Ray rayThrough(const QPointF& pixel) const { return camera_.rayThrough(pixel, viewSize()); }
  std::optional<QPointF> project(const sim::Vec3& point) const { return camera_.project(point, viewSize()); }

  /// Null: select.
  void setTool(std::unique_ptr<Tool> tool);
  Tool* tool() const { return tool_.get(); }

 signals:
  void toolChanged();
  /// What the pointer is over changed.
  void hovered(const Pick& pick);
  void clicked(const Pick& pick);
  void cameraChanged();

 protected:
  void initializeGL() override;
  void paintGL() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  Session& session_;
  ViewCamera camera_;
  std::unique_ptr<Tool> tool_;
  std::unique_ptr<ViewportRenderer> renderer_;
  QPointF lastPointer_;
};

}  // namespace ui
