#pragma once

#include <QObject>
#include <QPointF>
#include <QRectF>
#include <QTimer>
#include <optional>

#include "ui/viewport/axis_gizmo.h"
#include "ui/viewport/navigator.h"

class QKeyEvent;
class QMouseEvent;

namespace ui {

class CameraFlight;
class Viewport;

/// What pointer, wheel and keys do in the viewport. A press is the axes', the camera's, the tool's, or
/// selects: as a click, or as a frame around things once the pointer has moved. The viewport passes its
/// events on.
class ViewportInput : public QObject {
  Q_OBJECT

 public:
  ViewportInput(Viewport& viewport, ViewCamera& camera, CameraFlight& flight);

  Navigator& navigator() { return navigator_; }
  const Navigator& navigator() const { return navigator_; }
  /// While it is over the viewport, logical pixels.
  const std::optional<QPointF>& pointer() const { return pointer_; }
  /// The frame that is being drawn around things to select; empty where none is.
  QRectF band() const;
  /// The tool is another one, or was cancelled: its press is over.
  void forgetToolPress();
  /// What the pointer can do, or the tool asks to do next.
  QString hint() const;
  /// The camera or the tool has the pointer, or the axes are there: nothing behind is looked for.
  bool isBusyAt(const QPointF& at) const;

  void press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  void release(const QMouseEvent& event);
  void leave();
  void wheel(const QWheelEvent& event);
  /// Two fingers on a trackpad; `change` of the size of what lies between them.
  void pinch(double change, const QPointF& at);
  /// True: taken.
  bool key(const QKeyEvent& event);
  /// Esc, with a tool. True: taken.
  bool escape();

 signals:
  void cameraMoved();
  /// What the pointer is over changed.
  void hovered(const Pick& pick);
  void clicked(const Pick& pick);

 private:
  /// Whose the press is.
  enum class Hold : std::uint8_t { nothing, axes, camera, tool, click, band };

  void showHover();
  void letGo(const QMouseEvent& event);
  void releaseAxes(const QPointF& at);

  Viewport& viewport_;
  ViewCamera& camera_;
  CameraFlight& flight_;
  Navigator navigator_;
  AxisGizmo axes_;
  Hold hold_ = Hold::nothing;
  QPointF from_;  ///< where the left button was pressed
  QPointF last_;  ///< where the axes were last dragged to
  std::optional<QPointF> pointer_;
  Pick hover_;
  QTimer hovering_;
};

}  // namespace ui
