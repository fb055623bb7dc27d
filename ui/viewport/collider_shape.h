#pragma once

#include <array>
#include <utility>
#include <vector>

#include "sim/collider/collider.h"
#include "ui/viewport/draw_data.h"

namespace ui {

/// Corners in the collider's own coordinates; none of a floor.
LevelDraw colliderMesh(const sim::Collider& collider);
/// Edges and circles, in the world.
std::vector<std::array<sim::Vec3, 2>> colliderOutline(const sim::Collider& collider);
/// Of a floor: empty.
Eigen::AlignedBox3d boxOf(const sim::Collider& collider);
/// They have the same mesh, wherever they are.
bool sameShape(const sim::Collider& left, const sim::Collider& right);

}  // namespace ui
