#include <QPainter>
#include <algorithm>

#include "ui/document/scene_edits.h"
#include "ui/theme/theme.h"
#include "ui/viewport/viewport.h"

namespace ui {

void Viewport::select(const Pick& pick, Qt::KeyboardModifiers modifiers) {
  Selection& selection = session_.selection();
  if (pick.item && isLocked(session_.document().scene(), *pick.item)) return;
  const bool adds = modifiers.testFlag(Qt::ShiftModifier) || modifiers.testFlag(Qt::ControlModifier);
  if (pick.item && adds) {
    selection.toggle(*pick.item);
  } else if (pick.item) {
    selection.select(*pick.item);
  } else if (!adds) {
    selection.clear();
  }
}

QRectF Viewport::band() const {
  return bandFrom_ && pointer_ ? QRectF(*bandFrom_, *pointer_).normalized() : QRectF();
}

/// Shown parts of which a node is in the frame, and colliders whose middle is.
std::vector<Item> Viewport::itemsIn(const QRectF& frame) const {
  const auto inside = [&](const sim::Vec3& point) {
    const std::optional<QPointF> at = project(point);
    return at && frame.contains(*at);
  };
  const modeling::Scene& scene = session_.document().scene();
  std::vector<Item> items;
  const Shown& shown = session_.shown();
  if (shown.network && shown.moment) {
    std::vector<std::uint8_t> touched(shown.network->partNames.size(), 0);
    for (std::size_t node = 0; node < shown.moment->positions.size(); ++node) {
      std::uint8_t& part = touched[shown.network->nodeParts[node]];
      if (part == 0 && inside(shown.moment->positions[node])) part = 1;
    }
    for (std::size_t part = 0; part < scene.parts.size(); ++part) {
      const auto name = std::ranges::find(shown.network->partNames, scene.parts[part].name);
      const auto place = static_cast<std::size_t>(name - shown.network->partNames.begin());
      if (place < touched.size() && touched[place] != 0) items.push_back({ItemKind::part, part});
    }
  }
  for (std::size_t collider = 0; collider < scene.environment.colliders.size(); ++collider) {
    const modeling::SceneCollider& one = scene.environment.colliders[collider];
    // A floor has no middle that anyone sees.
    if (!one.isFloor() && inside(one.position)) items.push_back({ItemKind::collider, collider});
  }
  std::erase_if(items, [&](const Item& item) { return isLocked(scene, item) || ui::isHidden(scene, item); });
  return items;
}

void Viewport::selectInBand(Qt::KeyboardModifiers modifiers) {
  std::vector<Item> items = itemsIn(band());
  bandFrom_.reset();
  update();
  Selection& selection = session_.selection();
  if (modifiers.testFlag(Qt::ShiftModifier) || modifiers.testFlag(Qt::ControlModifier)) {
    std::erase_if(items, [&](const Item& item) { return selection.contains(item); });
    items.insert(items.begin(), selection.items().begin(), selection.items().end());
  }
  selection.set(std::move(items));
}

void Viewport::paintBand(QPainter& painter) const {
  const QRectF frame = band();
  if (frame.isEmpty()) return;
  QColor colour = Theme::instance().colours().accent;
  painter.setPen(QPen(colour, 1.0));
  colour.setAlphaF(0.15F);
  painter.setBrush(colour);
  painter.drawRect(frame);
  painter.setBrush(Qt::NoBrush);
}

QString Viewport::hint() const {
  if (tool_) return tool_->hint();
  const QString turning = navigator_.preset() == NavigationPreset::maya
                              ? tr("Alt and a drag orbits, pans and zooms")
                              : tr("middle button orbits, with Shift pans; wheel zooms");
  return tr("Click selects, with Shift more; drag selects what is in a box; %1").arg(turning);
}

void Viewport::noteHint() {
  const QString hint = this->hint();
  if (hint == hint_) return;
  hint_ = hint;
  emit hintChanged(hint_);
}

}  // namespace ui
