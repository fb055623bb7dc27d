#pragma once

#include <string>

#include "modeling/import/raw_mesh.h"
#include "modeling/shapes/mesh_shape.h"

namespace modeling {

/// How a mesh is taken.
struct MeshInterpretation {
  double unit = 1.0;                ///< cm
  std::array<sim::Vec3, 3> axes{};  ///< right, away from who looks from the front, and up, in the file's axes
  std::string words;                ///< "in centimetres and with z up, as the file states"

  sim::Vec3 operator()(const sim::Vec3& point) const {
    return unit * sim::Vec3(axes[0].dot(point), axes[1].dot(point), axes[2].dot(point));
  }
  /// The axes are those of a mirror.
  bool isMirrored() const { return axes[0].cross(axes[1]).dot(axes[2]) < 0.0; }
};

/// As the scene says; else as the file or its format says; else by a guess: the unit in which a mesh of this
/// extent (in its own) is as large as dishware, millimetres first for STL, and z up. `ending` is that of its
/// name.
MeshInterpretation interpretationOf(const MeshSource& source, const RawMesh& raw, const std::string& ending,
                                    const sim::Vec3& extent);

}  // namespace modeling
