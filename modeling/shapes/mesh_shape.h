#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Geometry>

namespace modeling {

/// What a length of 1 in a file means. Some formats say so; where one does not, a guess is the unit in which
/// the thing would have a size that dishware has.
enum class MeshUnit { guess, millimetre, centimetre, metre, inch };

/// Which axis of a file points up. A guess is what the format is usually written in.
enum class MeshUp { guess, y, z };

/// A mesh in a file, and how to take it.
struct MeshSource {
  std::string file;  ///< relative to the scene's folder
  MeshUnit unit = MeshUnit::guess;
  MeshUp up = MeshUp::guess;

  bool operator==(const MeshSource&) const = default;
};

/// A closed mesh filled with cells that end at its surface (mesh_lattice.h).
struct MeshShape {
  static constexpr std::string_view kName = "mesh";

  std::string file;  ///< see MeshSource
  MeshUnit unit = MeshUnit::guess;
  MeshUp up = MeshUp::guess;
  double cellSize = 0.5;  ///< cm, > 0

  MeshSource source() const { return {file, unit, up}; }
  /// Empty: only the file says where it is.
  Eigen::AlignedBox3d box() const { return {}; }
  std::optional<double> cellEdge() const { return cellSize; }

  bool operator==(const MeshShape&) const = default;
};

}  // namespace modeling
