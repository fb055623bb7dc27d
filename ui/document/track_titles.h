#pragma once

#include <QString>

#include "modeling/scene/tracks.h"

namespace ui {

/// As people call it: "Gravity", "Stiffness of glass", "Position of ball".
QString titleOf(const modeling::TargetName& target);
/// As it stands behind a number: "cm", "\u00d7" for a factor.
QString unitText(modeling::TrackUnit unit);

}  // namespace ui
