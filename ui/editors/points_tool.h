#pragma once

#include <optional>
#include <set>
#include <string>

#include "ui/kinds/shape_points.h"
#include "ui/session/session.h"
#include "ui/viewport/tool.h"
#include "ui/viewport/viewport.h"

namespace ui {

/// Drags the control points of one part in the viewport: a patch's net, a curve's points, handles and section
/// sizes. They move in the plane of the picture, or along an axis of the world after X, Y or Z was pressed.
/// Ctrl and a click on a curve adds a point; Delete takes those away that are selected.
class PointsTool : public Tool {
 public:
  PointsTool(Session& session, std::string part) : session_(session), part_(std::move(part)) {}

  const std::string& part() const { return part_; }
  const std::set<std::size_t>& selected() const { return selected_; }
  /// Keys that mean something here, though they may be shortcuts elsewhere: X must not delete the part.
  static bool takes(int key, Qt::KeyboardModifiers modifiers);

  QString hint() const override;
  QCursor cursor() const override { return hovered_ ? Qt::SizeAllCursor : Qt::ArrowCursor; }
  bool press(Viewport& viewport, const PointerEvent& event) override;
  void move(Viewport& viewport, const PointerEvent& event) override;
  void release(Viewport& viewport, const PointerEvent& event) override;
  void hover(Viewport& viewport, const PointerEvent& event) override;
  bool cancel(Viewport& viewport) override;
  bool key(Viewport& viewport, int key, Qt::KeyboardModifiers modifiers) override;
  void draw(const Viewport& viewport, Overlay& overlay) override;

 private:
  const modeling::Part* find() const;
  /// Undo and others change the part under the hand: what is held of another shape is let go.
  void follow();
  std::optional<std::size_t> pointAt(const Viewport& viewport, const QPointF& pixel) const;
  /// Where the pointer drags the grabbed point to, cm in the world.
  modeling::Vec3 target(const Viewport& viewport, const QPointF& pixel) const;
  void write(const modeling::Vec3& worldBy, bool free);
  void selectAll();
  /// The place on a curve under a pixel.
  std::optional<CurvePoint> curveAt(const Viewport& viewport, const QPointF& pixel) const;
  std::optional<CurvePoint> insertionAt(const Viewport& viewport, const PointerEvent& event) const;
  void insertAt(const CurvePoint& place);
  void removeSelected();
  void edit(const QString& name, const modeling::PartShape& shape);

  Session& session_;
  std::string part_;
  std::set<std::size_t> selected_;
  std::optional<std::size_t> hovered_;
  std::optional<modeling::Vec3> insertion_;  ///< cm, world: where a click would add a point
  std::optional<Eigen::Index> axis_;         ///< of the world, that dragging keeps to

  std::optional<std::size_t> grabbed_;
  bool dragging_ = false;
  QPointF pressed_;
  modeling::Vec3 grabbedAt_ = modeling::Vec3::Zero();  ///< cm, world, at the press
  modeling::PartShape shapeAtPress_;
  std::optional<modeling::PartShape> known_;  ///< that all of the above are of
};

}  // namespace ui
