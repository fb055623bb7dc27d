#pragma once

#include <QString>

#include "ui/theme/theme.h"

namespace ui {

/// What a palette cannot say: spacing, corners, the look of docks, bars and fields.
QString styleSheetOf(const Colours& colours);

}  // namespace ui
