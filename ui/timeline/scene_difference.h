#pragma once

#include <QStringList>

#include "modeling/scene/scene.h"

namespace ui {

/// What of two scenes differs and changes the motion, in the words of the window: "materials", "gravity"...
QStringList differencesOf(const modeling::Scene& left, const modeling::Scene& right);

}  // namespace ui
