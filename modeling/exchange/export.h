#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "modeling/files/output_guard.h"
#include "sim/surface/surface_mesh.h"
#include "sim/take/take.h"

namespace modeling {

/// What to write of a take, and where.
struct ExportRequest {
  std::filesystem::path path;
  std::size_t firstFrame = 0;
  std::size_t lastFrame = 0;  ///< inclusive, below the take's frame count
  /// Told the share that is done; answers false to cancel. Files that are whole by then stay.
  std::function<bool(double)> progress;
  /// Told, in a sentence, what a person should know of what was written.
  std::function<void(const std::string&)> remark = {};
  /// Of formats that hold a surface.
  sim::LooseNodes looseNodes = sim::LooseNodes::shards;
  bool levelSurface = false;  ///< in place of the cells' surface, for formats that can have it
};

/// What a format has of the surface (sim/surface/surface_mesh.h).
enum class ExportedSurface : std::uint8_t {
  none,
  cells,        ///< of the cells, with loose nodes as they are asked for
  cellsOrLevel  ///< or, in place of it, the level surface of the nodes' potential field
};

/// A file format that takes can be written in. Every file appears whole or not at all.
struct ExportFormat {
  std::string name;     ///< as it is asked for, and the usual end of its file names
  std::string summary;  ///< for help
  sim::Status (*write)(const sim::TakeReader& take, const ExportRequest& request);
  /// All files that `write` makes, of which kinds.
  std::vector<PlannedFile> (*files)(const ExportRequest& request);
  ExportedSurface surface = ExportedSurface::none;
};

/// All formats, in the order in which help lists them.
const std::vector<ExportFormat>& exportFormats();

/// A Problem that names the formats there are.
sim::Result<ExportFormat> exportFormatNamed(const std::string& name);

/// Extended XYZ, read by OVITO and ASE: all frames in one file, nodes in network order, cm and cm/s with 17
/// significant digits, which read back to the same numbers. The comment line of a frame names the columns and
/// states Time (s), Step (count) and the names of materials. `species` is a chemical element that stands for
/// the node's material, `material` its number from 0, `masses` the mass in g, 0 of held nodes, `fragment` its
/// fragment, -1 of none.
sim::Status writeXyz(const sim::TakeReader& take, const ExportRequest& request);

/// Wavefront OBJ of the surface (sim/surface/surface_mesh.h): one file a frame, numbered as numberedPath()
/// says, or the path itself for a single frame, each with its .obj.mtl. cm, z up; a group a fragment; a
/// normal a vertex; materials MATERIAL_outside and MATERIAL_inside.
sim::Status writeObj(const sim::TakeReader& take, const ExportRequest& request);

/// PLY, binary: the surface, one file a frame. cm, z up. Vertices have normals, `damage` (damage.h), and of
/// the faces they belong to `fragment`, `material` (numbers that the head explains) and `inside`.
sim::Status writePly(const sim::TakeReader& take, const ExportRequest& request);

/// Point cache (.pc2) with the .obj of the same name, and its .obj.mtl, that it moves: the surface of all
/// frames with the breaks of the last, so that its points are the same ones throughout, deformed. cm, z up; a
/// sample a frame; the head of the .obj states the frames a second.
sim::Status writePc2(const sim::TakeReader& take, const ExportRequest& request);

/// VTK: a .vtu a frame and a .pvd that puts them in time. Nodes with `velocity`, `fragment` and `damage`;
/// bonds as lines with `strain`, against the rest length they had before any plastic flow, `broken` and
/// `material`. cm, z up.
sim::Status writeVtk(const sim::TakeReader& take, const ExportRequest& request);

/// Comma-separated tables with units in their heads. NAME.csv: each fragment in each frame, where its centre
/// of mass is, how it is turned since the first exported frame (as nearly as its nodes' best fit says), and
/// its velocities; NAME.events.csv: breaks; NAME.ledger.csv: energies and momenta.
sim::Status writeCsv(const sim::TakeReader& take, const ExportRequest& request);

/// LAMMPS: FILE.data and FILE.in, which goes on from the first requested frame to the end of the scene's
/// duration and dumps what importLammps() (lammps_import.h) brings back. What LAMMPS does otherwise stands at
/// the head of FILE.in and is told.
sim::Status writeLammps(const sim::TakeReader& take, const ExportRequest& request);

/// How far any point of a rigid piece in a .glb may be from where all frames as keys would have it, cm. Half
/// of what single precision keeps of a scene ten metres wide.
inline constexpr double kKeyTolerance = 5e-5;

/// glTF 2.0, binary (.glb): metres, y up. Each fragment is a node "fragment_ID" that moves as the rigid
/// motion which fits its nodes best; how well is told and stands in its `extras`, with id, parent, birth
/// time, mass, part and frames a second. It is there from the frame in which it is born, as one closed mesh,
/// rounded as pictures draw it; where something breaks off it, a mesh takes the place of another. So a body
/// is whole until it breaks. Materials MATERIAL_outside and MATERIAL_inside, vertex normals, texture
/// coordinates, and damage (damage.h) as `_DAMAGE`, of the frame in which a mesh is first seen. Keys are left
/// out within kKeyTolerance.
sim::Status writeGlb(const sim::TakeReader& take, const ExportRequest& request);

/// "folder/name.png" and 12 -> "folder/name.0012.png".
std::filesystem::path numberedPath(const std::filesystem::path& path, std::size_t number);

}  // namespace modeling
