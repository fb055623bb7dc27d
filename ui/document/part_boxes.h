#pragma once

#include <span>

#include <Eigen/Geometry>

#include "modeling/scene/scene.h"
#include "ui/document/selection.h"

/// Where things of a scene are, in the world (cm), told from their outlines alone: good enough to place
/// something beside them, and at once there, while a lattice has to be built first.
namespace ui {

/// Of the parts and colliders (but floors) among the items.
Eigen::AlignedBox3d boxOf(const modeling::Scene& scene, std::span<const Item> items);
/// Of all parts and colliders (but floors).
Eigen::AlignedBox3d boxOf(const modeling::Scene& scene);

}  // namespace ui
