#pragma once

#include <QString>
#include <array>

#include "modeling/shapes/revolution.h"

namespace ui {

/// Dishes to start from.
enum class ProfilePreset { cup, bowl, plate, vase, bottle, teapotBody };

inline constexpr std::array kProfilePresets{ProfilePreset::cup,    ProfilePreset::bowl,
                                            ProfilePreset::plate,  ProfilePreset::vase,
                                            ProfilePreset::bottle, ProfilePreset::teapotBody};

/// As menus call it.
QString nameOf(ProfilePreset preset);
/// As the scene calls it.
const char* nameInScene(ProfilePreset preset);

/// Standing on z = 0, of a usual size, with cells that suit it; both profiles run from the middle of the base
/// to the rim.
modeling::RevolutionShape shapeOf(ProfilePreset preset);

}  // namespace ui
