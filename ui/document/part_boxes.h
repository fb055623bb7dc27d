#pragma once

#include <span>

#include <Eigen/Geometry>

#include "modeling/scene/scene.h"
#include "ui/document/selection.h"

/// Where things of a scene are, told from their outlines alone: good enough to place something beside them,
/// and at once there, while a lattice has to be built first.
namespace ui {

/// World coordinates, cm; contains the part. Empty for a network, whose file only says where its nodes are.
Eigen::AlignedBox3d boxOf(const modeling::Part& part);
/// In the part's own coordinates.
Eigen::AlignedBox3d boxOf(const modeling::PartShape& shape);
/// Of the parts and colliders (but floors) among the items.
Eigen::AlignedBox3d boxOf(const modeling::Scene& scene, std::span<const Item> items);
/// Of all parts and colliders (but floors).
Eigen::AlignedBox3d boxOf(const modeling::Scene& scene);

}  // namespace ui
