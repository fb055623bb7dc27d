#pragma once

#include <optional>

#include "modeling/scene/part.h"

/// Handles and spouts: by themselves, or as they fit the wall of a dish.
namespace ui {

modeling::CurvedCylinderShape usualHandle();
modeling::CurvedCylinderShape usualSpout();

/// In the dish's coordinates; nothing where its wall is too low.
std::optional<modeling::PartShape> handleAt(const modeling::RevolutionShape& dish);
std::optional<modeling::PartShape> spoutAt(const modeling::RevolutionShape& dish);

/// Where an outside profile is farthest from the axis at height z, cm; nothing where it does not reach that
/// height.
std::optional<double> outsideRadiusAt(const modeling::RevolutionShape& shape, double z);

}  // namespace ui
