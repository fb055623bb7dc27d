#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "ui/document/document.h"

namespace ui {

/// What of a scene can be selected and has properties. Items are named by their place in the scene's lists.
enum class ItemKind { scene, part, gluing, collider, material, track };

struct Item {
  ItemKind kind = ItemKind::scene;
  std::size_t index = 0;  ///< in its list; 0 for the scene

  bool operator==(const Item&) const = default;
};

/// How many of a kind there are.
std::size_t countOf(const modeling::Scene& scene, ItemKind kind);
/// What to call it, as people see it: a gluing is "handle to body", a track is what it drives.
QString nameOf(const modeling::Scene& scene, const Item& item);

/// What is selected, in the order of selecting; the last is the one whose properties are shown. An item stays
/// selected where edits and undo move it to in its list, and is dropped where they take it away.
class Selection : public QObject {
  Q_OBJECT

 public:
  explicit Selection(Document& document);

  const std::vector<Item>& items() const { return items_; }
  /// The last selected; the scene itself where nothing is.
  Item current() const { return items_.empty() ? Item{} : items_.back(); }
  bool contains(const Item& item) const;

  void set(std::vector<Item> items);
  void select(const Item& item) { set({item}); }
  void toggle(const Item& item);
  void clear() { set({}); }

 signals:
  void changed();

 private:
  void follow();
  void remember();
  std::optional<Item> followed(std::size_t place) const;

  Document& document_;
  std::vector<Item> items_;
  std::vector<QString> names_;       ///< of the items, when they were selected or followed
  std::vector<std::size_t> counts_;  ///< of each kind, then
};

}  // namespace ui
