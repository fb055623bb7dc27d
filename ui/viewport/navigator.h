#pragma once

#include <cstdint>

#include "ui/viewport/tool.h"
#include "ui/viewport/view_camera.h"

class QWheelEvent;

namespace ui {

/// Which buttons turn the view, as in which program.
enum class NavigationPreset : std::uint8_t {
  blender,  ///< middle button: orbit, with shift pan, with ctrl zoom
  maya,     ///< with Alt, left: orbit, middle: pan, right: zoom
};

/// Moves the camera by pointer, wheel and trackpad. Whatever the preset, the wheel zooms to the pointer, and
/// two fingers on a trackpad orbit, with shift pan, with ctrl zoom.
class Navigator {
 public:
  explicit Navigator(ViewCamera& camera) : camera_(camera) {}

  void setPreset(NavigationPreset preset) { preset_ = preset; }
  NavigationPreset preset() const { return preset_; }
  bool isMoving() const { return motion_ != Motion::none; }

  /// True: the press is the camera's.
  bool press(const PointerEvent& event);
  void move(const PointerEvent& event, const QSizeF& size);
  void release() { motion_ = Motion::none; }
  void orbitBy(const QPointF& pixels);
  void wheel(const QWheelEvent& event, const QSizeF& size);
  void pinch(double change, const QPointF& at, const QSizeF& size);

 private:
  enum class Motion : std::uint8_t { none, orbit, pan, zoom };
  Motion motionOf(const PointerEvent& event) const;

  ViewCamera& camera_;
  NavigationPreset preset_ = NavigationPreset::blender;
  Motion motion_ = Motion::none;
  QPointF last_;
  QPointF start_;
};

}  // namespace ui
