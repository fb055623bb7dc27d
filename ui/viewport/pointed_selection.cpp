#include "ui/viewport/pointed_selection.h"

#include <algorithm>

#include "ui/document/scene_edits.h"
#include "ui/session/session.h"
#include "ui/viewport/view_camera.h"

namespace ui {
namespace {

bool adds(Qt::KeyboardModifiers modifiers) {
  return modifiers.testFlag(Qt::ShiftModifier) || modifiers.testFlag(Qt::ControlModifier);
}

/// By part of the network: whether one of its nodes satisfies `inside`.
template <class Inside>
std::vector<std::uint8_t> touchedParts(const Shown& shown, const Inside& inside) {
  std::vector<std::uint8_t> touched(shown.network->partNames.size(), 0);
  for (std::size_t node = 0; node < shown.moment->positions.size(); ++node) {
    std::uint8_t& part = touched[shown.network->nodeParts[node]];
    if (part == 0 && inside(shown.moment->positions[node])) part = 1;
  }
  return touched;
}

}  // namespace

void selectPicked(Session& session, const Pick& pick, Qt::KeyboardModifiers modifiers) {
  Selection& selection = session.selection();
  if (pick.item && isLocked(session.document().scene(), *pick.item)) return;
  if (pick.item && adds(modifiers)) {
    selection.toggle(*pick.item);
  } else if (pick.item) {
    selection.select(*pick.item);
  } else if (!adds(modifiers)) {
    selection.clear();
  }
}

std::vector<Item> itemsIn(const QRectF& frame, Session& session, const ViewCamera& camera,
                          const QSizeF& size) {
  const auto inside = [&](const sim::Vec3& point) {
    const std::optional<QPointF> at = camera.project(point, size);
    return at && frame.contains(*at);
  };
  const modeling::Scene& scene = session.document().scene();
  std::vector<Item> items;
  const Shown& shown = session.shown();
  if (shown.network && shown.moment) {
    const std::vector<std::uint8_t> touched = touchedParts(shown, inside);
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
  std::erase_if(items, [&](const Item& item) { return isLocked(scene, item) || isHidden(scene, item); });
  return items;
}

void selectFramed(Session& session, std::vector<Item> items, Qt::KeyboardModifiers modifiers) {
  Selection& selection = session.selection();
  if (adds(modifiers)) {
    std::erase_if(items, [&](const Item& item) { return selection.contains(item); });
    items.insert(items.begin(), selection.items().begin(), selection.items().end());
  }
  selection.set(std::move(items));
}

}  // namespace ui
