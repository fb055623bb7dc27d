#include "ui/panels/touch_tool.h"

#include <QCoreApplication>

#include "ui/theme/theme.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

std::optional<sim::Vec3> bodyUnder(Viewport& viewport, const QPointF& pixel) {
  const Pick pick = viewport.pickAt(pixel);
  if (pick.kind == Pick::Kind::nothing || pick.kind == Pick::Kind::collider) return std::nullopt;
  return pick.point;
}

}  // namespace

QString TouchTool::hint() const {
  return kind_ == Kind::poke
             ? QCoreApplication::translate("TouchTool", "Poke: click where the finger pushes. Esc: done")
             : QCoreApplication::translate("TouchTool",
                                           "Knock: click where the ball flies through. Esc: done");
}

bool TouchTool::press(Viewport& viewport, const PointerEvent& event) {
  // A press that misses is meant for nothing else.
  if (const std::optional<sim::Vec3> point = bodyUnder(viewport, event.position))
    touch_(*point, viewport.rayThrough(event.position).direction.normalized());
  return true;
}

void TouchTool::move(Viewport&, const PointerEvent&) {}

void TouchTool::release(Viewport&, const PointerEvent&) {}

void TouchTool::hover(Viewport& viewport, const PointerEvent& event) {
  target_ = bodyUnder(viewport, event.position);
  viewport.update();
}

void TouchTool::draw(const Viewport&, Overlay& overlay) {
  if (target_) overlay.point(*target_, Theme::instance().colours().warning, kind_ == Kind::poke ? 9.0 : 18.0);
}

}  // namespace ui
