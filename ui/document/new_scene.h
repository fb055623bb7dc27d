#pragma once

#include "modeling/scene/scene.h"

namespace ui {

/// What a person starts from: nothing but a floor, and a ceramic that breaks well at the size of dishes.
modeling::Scene newScene();

}  // namespace ui
