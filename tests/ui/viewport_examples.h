#pragma once

#include "ui/viewport/draw_data.h"

/// Small things to look at, for the tests of the viewport.
namespace examples {

/// A block of clay on a floor beside a ball, called "block", "floor" and "ball".
modeling::Scene blockAndBall();

/// The block, broken across the middle: one half turned away, one corner gone off by itself, the rest a
/// little stretched.
ui::Shown brokenBlock();

}  // namespace examples
