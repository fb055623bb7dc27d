#include "ui/viewport/colour_map.h"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

/// sRGB of a colour of the OKLab space (B. Ottosson, 2020), in which steps of equal size look equal.
Rgb fromOklab(float lightness, float a, float b) {
  const auto cube = [](float value) { return value * value * value; };
  const float l = cube(lightness + 0.3963378F * a + 0.2158038F * b);
  const float m = cube(lightness - 0.1055613F * a - 0.0638542F * b);
  const float s = cube(lightness - 0.0894842F * a - 1.2914855F * b);
  const auto encode = [](float linear) {
    const float clamped = std::clamp(linear, 0.0F, 1.0F);
    return clamped <= 0.0031308F ? 12.92F * clamped : 1.055F * std::pow(clamped, 1.0F / 2.4F) - 0.055F;
  };
  return {encode(4.0767416F * l - 3.3077116F * m + 0.2309699F * s),
          encode(-1.2684380F * l + 2.6097574F * m - 0.3413194F * s),
          encode(-0.0041961F * l - 0.7034186F * m + 1.7076147F * s)};
}

}  // namespace

Rgb viridis(float value) {
  const float x = std::clamp(value, 0.0F, 1.0F);
  Rgb colour{};
  for (std::size_t channel = 0; channel < colour.size(); ++channel) {
    float sum = 0.0F;
    for (std::size_t power = kViridis.size(); power-- > 0;) sum = sum * x + kViridis[power][channel];
    colour[channel] = std::clamp(sum, 0.0F, 1.0F);
  }
  return colour;
}

Rgb fragmentColour(std::uint32_t fragment) {
  // Turning by the golden angle never comes back near one of the last few hues.
  constexpr float kGoldenAngle = 2.3999632F;
  const float hue = kGoldenAngle * static_cast<float>(fragment % 4096U) + 0.9F;
  const float lightness = 0.60F + 0.12F * static_cast<float>(fragment % 3U);
  return fromOklab(lightness, 0.115F * std::cos(hue), 0.115F * std::sin(hue));
}

std::uint32_t packed(const Rgb& colour, float alpha) {
  const auto byte = [](float value) {
    return static_cast<std::uint32_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
  };
  return byte(colour[0]) | byte(colour[1]) << 8U | byte(colour[2]) << 16U | byte(alpha) << 24U;
}

}  // namespace ui
