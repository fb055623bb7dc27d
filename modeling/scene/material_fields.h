#pragma once

#include "modeling/material/material.h"
#include "modeling/text/json_fields.h"

/// The fields of materials.
namespace modeling {

template <>
struct Fields<Look> {
  static constexpr auto list() {
    using T = Look;
    return std::tuple{
        field("outside", &T::outside, "Outside", "Colour, sRGB.").atLeast(0).atMost(1),
        field("inside", &T::inside, "Where broken", "Colour that breaking bares, sRGB.").atLeast(0).atMost(1),
        field("glaze", &T::glaze, "Glaze", "Strength of the glossy coat, from matt to glossy.")
            .step(0.05)
            .between(0, 1)
            .gauge(),
        field(
            "finish", &T::finish, "In pictures",
            "What light does at the surface in pictures: glazed: a clear coat over the colour; glass: clear "
            "throughout, and outside is what passes through three centimetres.")};
  }
};

template <>
struct Fields<ThresholdSpec> {
  static constexpr auto list() {
    using T = ThresholdSpec;
    return std::tuple{field("mean", &T::mean, "Strain", "Relative stretch at which bonds break.")
                          .in(Dimension::share, 0.005)
                          .logarithmic()
                          .absent("none")
                          .atLeast(1e-9)
                          .where([](const T& threshold) { return threshold.mean.has_value(); }),
                      field("spread", &T::spread, "Spread", "Standard deviation relative to the mean.")
                          .in(Dimension::share, 0.02)
                          .between(0, 10)};
  }
};

template <>
struct Fields<Plastic> {
  static constexpr auto list() {
    using T = Plastic;
    return std::tuple{
        field("yieldStrain", &T::yieldStrain, "Yields at", "Strain above which rest lengths flow.")
            .required()
            .in(Dimension::share, 0.001)
            .logarithmic()
            .atLeast(1e-9),
        field("rate", &T::rate, "Rate", "Share of the excess strain that flows a second.")
            .required()
            .in(Dimension::rate, 1.0)
            .logarithmic()
            .atLeast(1e-6)};
  }
};

template <>
struct Fields<Material> {
  static constexpr auto list() {
    using T = Material;
    return std::tuple{
        field("pattern", &T::pattern, "Pattern", "Which corners of a cell are joined."),
        field("youngsModulus", &T::youngsModulus, "Stiffness",
              "Young's modulus E (1 GPa = 1e10): porcelain 70 GPa, rubber 1.5 MPa, jelly 4 kPa.")
            .in(Dimension::pressure, 1e7)
            .logarithmic()
            .atLeast(1),
        field("density", &T::density, "Density", "Mass of a cubic centimetre.")
            .in(Dimension::density, 0.1)
            .atLeast(1e-6),
        field("lossFactor", &T::lossFactor, "Loss factor",
              "Twice the damping ratio at the lattice's highest frequency.")
            .step(0.02)
            .between(0, 10),
        field("threshold", &T::threshold, "Breaking", "At which strain bonds break."),
        field("strength", &T::strength, "Strength", "Tensile strength, in place of threshold.mean.")
            .in(Dimension::pressure, 1e6)
            .logarithmic()
            .absent("none")
            .atLeast(1)
            .where([](const T& material) { return material.strength.has_value(); }),
        field("fractureToughness", &T::fractureToughness, "Toughness",
              "Fracture toughness K_IC, in place of threshold.mean.")
            .in(Dimension::toughness, 1e7)
            .logarithmic()
            .absent("none")
            .atLeast(1)
            .where([](const T& material) { return material.fractureToughness.has_value(); }),
        field("plastic", &T::plastic, "Staying Bent", "Plastic flow: what is bent far enough stays bent.")
            .present("Flows beyond a strain")
            .absent("elastic"),
        field("look", &T::look, "Look", "Colours and gloss."),
        field("source", &T::source, "Source", "Where the numbers come from.")};
  }
};

}  // namespace modeling
