#pragma once

#include <functional>
#include <optional>

#include "ui/viewport/tool.h"

namespace ui {

/// Touches what is under the pointer: a click hands over the point and the direction of sight.
class TouchTool : public Tool {
 public:
  enum class Kind { poke, knock };
  using Touch = std::function<void(const sim::Vec3& point, const sim::Vec3& direction)>;

  TouchTool(Kind kind, Touch touch) : kind_(kind), touch_(std::move(touch)) {}

  Kind kind() const { return kind_; }
  QString hint() const override;
  QCursor cursor() const override { return Qt::CrossCursor; }
  bool press(Viewport& viewport, const PointerEvent& event) override;
  void move(Viewport& viewport, const PointerEvent& event) override;
  void release(Viewport& viewport, const PointerEvent& event) override;
  void hover(Viewport& viewport, const PointerEvent& event) override;
  void draw(const Viewport& viewport, Overlay& overlay) override;

 private:
  Kind kind_;
  Touch touch_;
  std::optional<sim::Vec3> target_;
};

}  // namespace ui
