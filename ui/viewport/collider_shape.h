#pragma once

#include "sim/collider/collider.h"
#include "ui/viewport/draw_data.h"

namespace ui {

/// Corners in the collider's own coordinates; none of a floor.
LevelDraw colliderMesh(const sim::Collider& collider);

}  // namespace ui
