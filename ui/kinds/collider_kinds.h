#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "modeling/scene/scene_collider.h"
#include "ui/kinds/new_thing.h"

namespace ui {

/// What the window knows of a kind of collider.
struct ColliderKind {
  QString title;  ///< in menus
  QString icon;   ///< of resources/icons
  QString help;   ///< one sentence for a tooltip
  /// What the add menu makes; nothing where it asks for a file first.
  std::optional<modeling::ColliderForm> usual;
};

ColliderKind kindOf(const modeling::ColliderForm& form);

/// What the add menu offers of all kinds, in their order.
std::vector<NewThing> newColliders();

}  // namespace ui
