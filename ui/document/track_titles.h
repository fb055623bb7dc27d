#pragma once

#include <QString>

#include "modeling/scene/scene.h"

namespace ui {

/// As people call it: "Gravity", "Stiffness of glass", "Position of ball".
QString titleOf(const modeling::TargetName& target);

}  // namespace ui
