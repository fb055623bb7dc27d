#include "ui/document/selection.h"

#include <algorithm>

#include "ui/document/track_titles.h"

namespace ui {

std::size_t countOf(const modeling::Scene& scene, ItemKind kind) {
  switch (kind) {
    case ItemKind::scene:
      return 1;
    case ItemKind::part:
      return scene.parts.size();
    case ItemKind::gluing:
      return scene.glue.size();
    case ItemKind::collider:
      return scene.environment.colliders.size();
    case ItemKind::material:
      return scene.materials.size();
    case ItemKind::track:
      return scene.tracks.size();
  }
  return 0;
}

QString nameOf(const modeling::Scene& scene, const Item& item) {
  if (item.index >= countOf(scene, item.kind)) return {};
  switch (item.kind) {
    case ItemKind::scene:
      return QString::fromStdString(scene.name);
    case ItemKind::part:
      return QString::fromStdString(scene.parts[item.index].name);
    case ItemKind::gluing: {
      const modeling::Gluing& gluing = scene.glue[item.index];
      return QObject::tr("%1 to %2").arg(QString::fromStdString(gluing.a), QString::fromStdString(gluing.b));
    }
    case ItemKind::collider:
      return QString::fromStdString(scene.environment.colliders[item.index].name);
    case ItemKind::material:
      return QString::fromStdString(scene.materials[item.index].name);
    case ItemKind::track:
      return titleOf(scene.tracks[item.index].target);
  }
  return {};
}

Selection::Selection(Document& document) : QObject(&document), document_(document) {
  connect(&document, &Document::replaced, this, &Selection::clear);
  connect(&document, &Document::sceneChanged, this, &Selection::follow);
}

bool Selection::contains(const Item& item) const {
  return std::find(items_.begin(), items_.end(), item) != items_.end();
}

void Selection::set(std::vector<Item> items) {
  std::erase_if(items, [&](const Item& item) { return item.index >= countOf(document_.scene(), item.kind); });
  if (items == items_) return;
  items_ = std::move(items);
  remember();
  emit changed();
}

void Selection::toggle(const Item& item) {
  std::vector<Item> items = items_;
  if (std::erase(items, item) == 0) items.push_back(item);
  set(std::move(items));
}

void Selection::remember() {
  names_.clear();
  counts_.clear();
  for (const Item& item : items_) {
    names_.push_back(nameOf(document_.scene(), item));
    counts_.push_back(countOf(document_.scene(), item.kind));
  }
}

/// What an item has become in the scene as it is now.
std::optional<Item> Selection::followed(std::size_t place) const {
  const modeling::Scene& scene = document_.scene();
  const Item& item = items_[place];
  const std::size_t count = countOf(scene, item.kind);
  if (item.index < count && nameOf(scene, item) == names_[place]) return item;
  for (std::size_t i = 0; i < count; ++i)
    if (nameOf(scene, {item.kind, i}) == names_[place]) return Item{item.kind, i};
  // Under no other name there are as many as before: it is called otherwise.
  const bool renamed = count == counts_[place] && item.index < count;
  return renamed ? std::optional(item) : std::nullopt;
}

void Selection::follow() {
  std::vector<Item> items;
  for (std::size_t place = 0; place < items_.size(); ++place)
    if (const std::optional<Item> item = followed(place)) items.push_back(*item);
  set(std::move(items));
  remember();
}

}  // namespace ui
