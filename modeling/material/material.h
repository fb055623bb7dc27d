#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/network/network.h"

/// A substance in physical units, and what a network of a given cell size makes of it. cgs: dyn/cm^2, g/cm^3
/// (1 GPa = 1e10 dyn/cm^2; 1 MPa m^(1/2) = 1e8 dyn/cm^(3/2)).
namespace modeling {

/// Which of a cell's 28 corner pairs carry a bond (docs/numerics.md, "Bonds of a lattice of cubes").
enum class BondPattern {
  full,   ///< 12 edges, 12 face diagonals, 4 body diagonals: rigid and isotropic (default)
  fig1,   ///< the paper's Fig. 1: 12 edges, 4 body diagonals. Three hourglass motions cost no energy
  fig2,   ///< the paper's Fig. 2: 12 edges and one diagonal on each face, joining every second corner
  faces,  ///< 12 edges, 12 face diagonals
};

/// "full", "fig1", "fig2", "faces"; nothing for any other name.
std::optional<BondPattern> bondPatternFromName(std::string_view name);
std::string_view nameOf(BondPattern pattern);
/// All names, for messages and help.
const std::vector<std::string>& bondPatternNames();

/// Colours are sRGB, each component in [0, 1], as a person picks them.
using Colour = std::array<double, 3>;

/// What light does at a surface.
enum class Finish : std::uint8_t {
  glazed,  ///< a clear coat over the coloured body
  matte,   ///< the coloured body alone
  glass,   ///< clear throughout: what is not reflected is refracted, and coloured on its way
};

/// How a material looks. What breaking bares shows the inside colour and no glaze; of glass it is clear too.
struct Look {
  Colour outside{0.85, 0.84, 0.80};
  Colour inside{0.93, 0.91, 0.87};
  double glaze = 0.5;  ///< strength of the glossy coat of the outside, 0 (matt) to 1
  Finish finish = Finish::glazed;

  bool operator==(const Look&) const = default;
};

/// Break strain of the bonds, stated directly (docs/numerics.md, Breaking 2).
struct ThresholdSpec {
  std::optional<double> mean;  ///< stretch past rest length, relative; absent: from strength or toughness
  double spread = 0.0;         ///< standard deviation relative to the mean, whatever the mean comes from

  bool operator==(const ThresholdSpec&) const = default;
};

/// Plastic flow: the rest length of a bond that varies in time (paper, "Dynamic solid models").
struct Plastic {
  double yieldStrain = 0.0;  ///< |strain| above which a bond's rest length flows
  double rate = 0.0;         ///< 1/s: share of the excess strain that flows a second

  bool operator==(const Plastic&) const = default;
};

/// At most one of threshold.mean, strength and fractureToughness is given; with none of them the material
/// never breaks. Poisson's ratio is not a choice: a network of central forces has 1/4 (docs/numerics.md).
struct Material {
  std::string name;
  BondPattern pattern = BondPattern::full;
  double youngsModulus = 6.5e11;  ///< E, dyn/cm^2
  double density = 2.4;           ///< rho, g/cm^3
  /// eta = 2 zeta at the network's highest frequency (dampingTime()): there 0.2 means a tenth of critical
  /// damping; a motion n times slower is damped n times less. It belongs to the resolution, as the shortest
  /// waves do: its task is to take out what the lattice cannot represent. It is not the substance's loss at
  /// audible frequencies.
  double lossFactor = 0.2;
  ThresholdSpec threshold;
  std::optional<double> strength;           ///< tensile, dyn/cm^2: threshold = strength / E, at any cell size
  std::optional<double> fractureToughness;  ///< K_IC, dyn/cm^(3/2): the threshold falls as 1/sqrt(cell size)
  std::optional<Plastic> plastic;
  Look look;
  std::string source;  ///< where the numbers come from; "" where nobody says

  bool operator==(const Material&) const = default;
};

/// Poisson's ratio of every isotropic central-force network.
inline constexpr double kPoissonRatio = 0.25;

/// Whether every value is usable. The Problem's place is the key within the material, such as
/// "threshold.mean".
sim::Status validate(const Material& material);

/// Mean break strain t of the bonds of cells of size h (cm), infinite where the material never breaks.
/// From toughness: the bonds that cross a (100) plane hold, at strain t, the energy G = K^2 (1 - nu^2)/E per
/// area.
double breakStrain(const Material& material, double cellSize);

/// The highest frequency (rad/s) of a longitudinal plane wave in the undistorted lattice, at half a wave a
/// cell: 2 sqrt(C11/rho)/h with C11 = 1.2 E. Every pattern here has the same C11, so the same value.
double highestFrequency(const Material& material, double cellSize);

/// beta (s) of bond damping d = beta k: lossFactor / highestFrequency.
double dampingTime(const Material& material, double cellSize);

/// What the simulation needs of the material in a network of cells of this size.
sim::Material resolve(const Material& material, double cellSize);

}  // namespace modeling
