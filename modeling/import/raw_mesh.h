#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/base/bytes.h"
#include "sim/base/result.h"
#include "sim/base/types.h"

namespace modeling {

/// More are refused.
inline constexpr std::size_t kMostTriangles = 2'000'000;

/// Who says what a number of a file means.
enum class Statement : std::uint8_t { nobody, theFormat, theFile };

/// What a file says, in its own units and axes.
struct RawMesh {
  std::vector<sim::Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of points
  double unit = 0.0;                                    ///< what a length of 1 is, cm; 0: nobody says
  Statement unitSaid = Statement::nobody;
  Statement axesSaid = Statement::nobody;
  /// Which way is right, away from who looks from the front, and up, as the file's axes; where somebody says.
  std::array<sim::Vec3, 3> axes{sim::Vec3::UnitX(), sim::Vec3::UnitY(), sim::Vec3::UnitZ()};
  /// What there is beside triangles, for who finds none.
  std::uint64_t loosePoints = 0, wires = 0, flatFaces = 0;
  std::string note;  ///< what was passed over or applied, for a person; empty: nothing

  void stateUnit(double centimetres, Statement by) {
    unit = centimetres;
    unitSaid = by;
  }
  /// x, y or z is up, and the mesh stands otherwise as most programs have it.
  void stateUp(char axis, Statement by);
  void addNote(const std::string& words) { note += (note.empty() ? "" : "; ") + words; }
};

using Reading = sim::Result<RawMesh>;

/// Takes the polygon apart into triangles (polygon.h); one of fewer than three different corners is counted.
/// A Problem where a corner is not there, or where there would be too many triangles; `which` names the
/// polygon: "line 7".
sim::Status addPolygon(const std::vector<std::int64_t>& corners, const std::string& which, RawMesh& raw);
/// Triangles of which each shares an edge with the one before it.
sim::Status addStrip(const std::vector<std::int64_t>& corners, const std::string& which, RawMesh& raw);

/// Into bytes and back. From damaged bytes: a Problem.
sim::ByteWriter bytesOf(const Reading& reading);
Reading readingOf(const std::vector<std::byte>& bytes);

}  // namespace modeling
