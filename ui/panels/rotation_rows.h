#pragma once

#include <functional>

#include "ui/panels/property_form.h"

namespace ui {

/// Degrees about x, then y, then z. One that was written as a quaternion is shown as such angles, and becomes
/// them when it is changed.
void addRotation(PropertyForm& form, const RowLabel& label,
                 const std::function<modeling::Rotation*(modeling::Scene&, const Item&)>& place);

/// The angles of a rotation, degrees.
sim::Vec3 anglesOf(const modeling::Rotation& rotation);

}  // namespace ui
