#pragma once

#include <array>
#include <cstdint>

namespace ui {

using Rgb = std::array<float, 3>;  ///< sRGB, 0 to 1

/// Coefficients, constant first, of a polynomial through the map viridis of Smith and van der Walt: equal
/// steps of the value look equally far apart, also to the colour-blind and in print. The shaders evaluate
/// the same ones.
inline constexpr std::array<Rgb, 7> kViridis{{{0.2777273F, 0.0054073F, 0.3340998F},
                                              {0.1050930F, 1.4046135F, 1.3845902F},
                                              {-0.3308618F, 0.2148476F, 0.0950952F},
                                              {-4.6342305F, -5.7991010F, -19.3324410F},
                                              {6.2282699F, 14.1799334F, 56.6905526F},
                                              {4.7763850F, -13.7451454F, -65.3530326F},
                                              {-5.4354559F, 4.6458526F, 26.3124352F}}};

/// 0: dark violet, 1: yellow; clamped.
Rgb viridis(float value);

/// One for each fragment, neighbours in number far apart in hue and lightness.
Rgb fragmentColour(std::uint32_t fragment);

/// Red in the lowest byte, as OpenGL reads four bytes; alpha carries what the shader wants to know besides.
std::uint32_t packed(const Rgb& colour, float alpha);

}  // namespace ui
