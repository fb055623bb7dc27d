#pragma once

#include <QString>
#include <array>
#include <vector>

#include "modeling/scene/part.h"
#include "ui/kinds/new_thing.h"

namespace ui {

class PointHandles;

/// Where the form of a part is drawn by hand.
enum class ShapeEditor {
  none,     ///< nowhere: by numbers only
  points,   ///< by points in the viewport
  profile,  ///< in the profile editor
};

/// What the window knows of a kind of part.
struct PartKind {
  QString title;                ///< over its properties
  QString icon;                 ///< of resources/icons
  std::array<QString, 3> axes;  ///< what its u, v and w are called, along which its cells are counted
  ShapeEditor editor = ShapeEditor::none;
  const PointHandles* points = nullptr;  ///< not null where `editor` is points
};

/// Of the shape's kind; the axes are the shape's own.
PartKind kindOf(const modeling::PartShape& shape);

/// What the add menu offers of all kinds, in its order. Kinds that stand in a file of their own have none.
std::vector<NewThing> newParts();

}  // namespace ui
