#pragma once

#include <QOpenGLWidget>
#include <functional>
#include <memory>
#include <vector>

#include "ui/session/session.h"
#include "ui/viewport/draw_feed.h"
#include "ui/viewport/gl.h"
#include "ui/viewport/heartbeat.h"
#include "ui/viewport/picture_frame.h"
#include "ui/viewport/tool.h"
#include "ui/viewport/view_camera.h"
#include "ui/viewport/viewport_input.h"

class QLabel;

namespace ui {

class BreakHistory;
class CameraFlight;
class ViewportRenderer;

/// The picture of what the session shows, with navigation, picking and tools. Where there is no OpenGL 3.3 it
/// says so in its place, and nothing else of it does anything.
class Viewport : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit Viewport(Session& session, QWidget* parent = nullptr);
  ~Viewport() override;

  Session& session() const { return session_; }
  const ViewCamera& camera() const { return camera_; }
  ViewCamera& camera() { return camera_; }
  QSizeF viewSize() const { return QSizeF(size()); }

  const ViewSettings& viewSettings() const { return feed_.settings(); }
  void setViewSettings(const ViewSettings& settings);
  NavigationPreset navigationPreset() const { return input_.navigator().preset(); }
  void setNavigationPreset(NavigationPreset preset) { input_.navigator().setPreset(preset); }

  void frameAll();
  /// The parts and colliders that are selected; everything where none is.
  void frameSelection();
  void lookAlong(ViewCamera::Axis axis);
  void setOrthographic(bool orthographic);
  /// Goes there smoothly.
  void flyTo(const ViewCamera& camera);

  Pick pickAt(const QPointF& pixel);
  /// What it is, in the words of the person: for the tooltip.
  QString describe(const Pick& pick);
  Ray rayThrough(const QPointF& pixel) const { return camera_.rayThrough(pixel, viewSize()); }
  std::optional<QPointF> project(const sim::Vec3& point) const { return camera_.project(point, viewSize()); }
  /// Around what is selected, cm; empty where nothing is, or it is not shown.
  Eigen::AlignedBox3d selectionBox() const;

  /// Esc, wherever the keyboard is: ends what is under way, else the tool. False: there is neither.
  bool leaveTool() { return tool_ && input_.escape(); }
  /// Null: select.
  void setTool(std::unique_ptr<Tool> tool);
  Tool* tool() const { return tool_.get(); }
  /// Draws over the picture, below what the tool draws, for as long as there is a viewport.
  void addOverlay(std::function<void(Overlay&)> paint) { overlays_.push_back(std::move(paint)); }

  /// What is shown by the session and chosen to view is what is drawn.
  bool isUpToDate() const { return feed_.isUpToDate(); }
  const std::shared_ptr<const DrawData>& drawn() const { return feed_.drawn(); }
  DrawStatistics statistics() const;

 signals:
  void toolChanged();
  /// What the pointer can do, or the tool asks to do next, is another thing than before.
  void hintChanged(const QString& hint);
  void viewSettingsChanged();
  /// What the pointer is over changed.
  void hovered(const Pick& pick);
  void clicked(const Pick& pick);
  void cameraChanged();

 protected:
  void initializeGL() override;
  void paintGL() override;
  bool event(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void frameFirst();
  void destroyRenderer();
  void sayWhatIsMissing(const QString& why);
  MarkedThings marked() const;
  PictureFrame pictureFrame() const;
  ViewCamera framed(const Eigen::AlignedBox3d& box) const;
  void moved();
  void noteHint();
  bool showToolTip(const QPoint& at);
  void paintOver();

  Session& session_;
  ViewCamera camera_;
  CameraFlight* flight_ = nullptr;
  QLabel* missing_ = nullptr;  ///< says why there is no picture
  std::unique_ptr<Tool> tool_;
  std::vector<std::function<void(Overlay&)>> overlays_;
  std::unique_ptr<ViewportRenderer> renderer_;
  std::unique_ptr<BreakHistory> breaks_;
  bool frameWhenShown_ = true;
  QString hint_;  ///< that was told last
  Heartbeat heartbeat_;
  DrawFeed feed_;
  ViewportInput input_;
};

}  // namespace ui
