#pragma once

#include <QPainter>
#include <optional>

#include "ui/editors/profile_model.h"
#include "ui/editors/profile_view.h"

namespace ui {

/// Draws a profile: grid, wall, its mirror image, curves and controls.
class ProfileDrawing {
 public:
  ProfileDrawing(QPainter& painter, const ProfileView& view, const QSizeF& size)
      : painter_(painter), view_(view), size_(size) {}

  void grid();
  void wall(const ProfileModel& model);
  void handle(const ProfileModel& model, const ControlId& handle, bool selected, bool hovered);
  void point(const ProfileModel& model, const ControlId& point, bool selected, bool hovered);
  /// Where a point would be inserted.
  void insertion(const modeling::Vec2& at);
  void snap(const modeling::Vec2& at);
  void selectionBox(const QRectF& box);
  /// Which colour is which, in the corner.
  void legend();

 private:
  void gridLines(double step, const QColor& colour);
  void numbers(double step);

  QPainter& painter_;
  const ProfileView& view_;
  QSizeF size_;
};

/// In which colour a profile is drawn.
QColor colourOf(ProfileSide side);

}  // namespace ui
