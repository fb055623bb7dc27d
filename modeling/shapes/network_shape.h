#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

namespace modeling {

enum class NetworkFormat { lammps };

/// Constants of the bonds of one type of a network file.
struct BondType {
  double stiffness = 0.0;            ///< dyn/cm, > 0
  std::optional<double> restLength;  ///< cm, > 0; absent: the bond's length in the file
  double damping = 0.0;              ///< g/s
  std::optional<double> threshold;   ///< t_ij; absent: unbreakable

  bool operator==(const BondType&) const = default;
};

struct NamedBondType {
  std::string type;  ///< as the file names it: a whole number
  BondType constants;

  bool operator==(const NamedBondType&) const = default;
};

/// Raw nodes and bonds from a file. No cells.
struct NetworkShape {
  static constexpr std::string_view kName = "network";

  std::string file;  ///< relative to the scene's folder
  NetworkFormat format = NetworkFormat::lammps;
  std::vector<NamedBondType> bondTypes;

  /// Empty: only the file says where its nodes are.
  Eigen::AlignedBox3d box() const { return {}; }
  std::optional<double> cellEdge() const { return std::nullopt; }

  bool operator==(const NetworkShape&) const = default;
};

}  // namespace modeling
