#pragma once

#include <functional>

#include "ui/panels/property_form.h"

namespace ui {

/// A row of degrees about x, then y, then z. One that was written as a quaternion is shown as such angles,
/// and becomes them when it is changed.
void addRotation(PropertyForm& form, const RowLabel& label, const NumberFormat& format,
                 const std::function<modeling::Rotation*(modeling::Scene&, const Item&)>& place);

/// The angles of a rotation, degrees.
sim::Vec3 anglesOf(const modeling::Rotation& rotation);

}  // namespace ui
