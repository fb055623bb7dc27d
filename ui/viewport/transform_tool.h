#pragma once

#include <QObject>
#include <array>
#include <optional>

#include "ui/viewport/tool.h"
#include "ui/viewport/transform_gizmo.h"

namespace ui {

class Session;

/// Moves, turns or scales the selected parts and colliders: by handles, or, once grab() was called, with the
/// pointer alone. X, Y, Z hold to an axis, with shift to the plane across it; a number typed meanwhile counts
/// instead of the pointer; ctrl snaps.
class TransformTool : public QObject, public Tool {
  Q_OBJECT

 public:
  explicit TransformTool(TransformMode mode) : mode_(mode) {}

  TransformMode mode() const { return mode_; }
  /// Always snap, and with ctrl not.
  void setSnaps(bool snaps) { snaps_ = snaps; }
  /// Begins without a button; the pointer is there. False where nothing is selected that could be moved.
  bool grab(Viewport& viewport, const QPointF& pointer);
  bool isDragging() const { return drag_.has_value(); }

  QString hint() const override;
  QCursor cursor() const override { return Qt::ArrowCursor; }
  bool press(Viewport& viewport, const PointerEvent& event) override;
  void move(Viewport& viewport, const PointerEvent& event) override;
  void release(Viewport& viewport, const PointerEvent& event) override;
  void hover(Viewport& viewport, const PointerEvent& event) override;
  bool cancel(Viewport& viewport) override;
  void leave(Viewport& viewport) override;
  bool key(Viewport& viewport, int key, Qt::KeyboardModifiers modifiers) override;
  bool wantsKey(int key, Qt::KeyboardModifiers modifiers) const override;
  void draw(const Viewport& viewport, Overlay& overlay) override;

 private:
  struct Drag {
    TransformStart start;
    std::vector<Item> items;
    TransformStart present;  ///< the same things as they were put last
    TransformGizmo gizmo;
    TransformHold hold;
    QPointF from;
    QPointF at;
    bool grabbed = false;  ///< without a button
    bool snaps = false;
    QString typed;
    double turned = 0.0;  ///< radians, summed up so that several turns count
    Transform result;
  };

  std::optional<TransformGizmo> gizmo(const Viewport& viewport) const;
  bool begin(Viewport& viewport, const TransformHold& hold, const QPointF& at, bool grabbed);
  void follow(Viewport& viewport, const PointerEvent& event);
  void update(Viewport& viewport);
  void end(Viewport& viewport);
  void followScene(Session& session);
  void unfollow();
  void apply(Viewport& viewport, const Transform& transform);
  Transform transformOf(const Viewport& viewport) const;
  sim::Vec3 pointerOffset(const Viewport& viewport) const;
  double pointerFactor(const Viewport& viewport) const;
  void addTurn(const Viewport& viewport, const QPointF& from, const QPointF& to);
  sim::Vec3 turnAxis(const Viewport& viewport) const;
  QString nameOfEdit() const;
  QString readout() const;

  TransformMode mode_;
  bool snaps_ = false;
  std::optional<Drag> drag_;
  std::optional<TransformHold> lit_;
  bool applying_ = false;
  std::array<QMetaObject::Connection, 2> following_;  ///< of the document, while something is dragged
};

}  // namespace ui
