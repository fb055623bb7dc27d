#pragma once

#include <QString>
#include <optional>
#include <string>
#include <variant>

#include "modeling/scene/part.h"
#include "modeling/scene/scene_collider.h"
#include "ui/kinds/part_presets.h"

namespace ui {

/// Something that the add menu offers, of a usual size.
struct NewThing {
  /// What it is at the wall of a dish, in the dish's coordinates; nothing where the wall is too low.
  using AtWall = std::optional<modeling::PartShape> (*)(const modeling::RevolutionShape& dish);

  std::string name;  ///< in the scene, and among newThings()
  QString title;     ///< in menus
  QString help;      ///< one sentence for a tooltip
  QString icon;      ///< of resources/icons
  std::variant<modeling::PartShape, modeling::ColliderForm> form;
  std::optional<ProfilePreset> preset;  ///< of a dish
  AtWall atWall = nullptr;              ///< null: it is never fitted to a dish

  bool isCollider() const { return std::holds_alternative<modeling::ColliderForm>(form); }
};

}  // namespace ui
