#pragma once

namespace modeling {

/// cm of glass that give it its look's colour: a thick-walled dish seen through both sides.
inline constexpr double kGlassDepth = 3.0;

}  // namespace modeling
