#include "modeling/exchange/export.h"

#include <algorithm>
#include <cstdio>

#include "modeling/text/spelling.h"

namespace modeling {

const std::vector<ExportFormat>& exportFormats() {
  static const std::vector<ExportFormat> kFormats{
      {"glb", "fragments as rigid pieces that move, for Blender and others (glTF 2.0)", writeGlb,
       ExportedSurface::cells},
      {"xyz", "positions and velocities of all nodes (extended XYZ)", writeXyz},
      {"obj", "the surface of each frame (Wavefront OBJ)", writeObj, ExportedSurface::cellsOrLevel},
      {"ply", "the surface of each frame, with damage and fragments (binary PLY)", writePly,
       ExportedSurface::cellsOrLevel},
      {"pc2", "the surface with all its breaks from the start, deforming (point cache and OBJ)", writePc2,
       ExportedSurface::cells},
      {"vtk", "nodes, bonds and their strain, for ParaView (.vtu and .pvd)", writeVtk},
      {"csv", "tables of fragments, breaks and energies", writeCsv},
      {"lammps", "a run that goes on from the first frame on LAMMPS (data and input)", writeLammps},
  };
  return kFormats;
}

sim::Result<ExportFormat> exportFormatNamed(const std::string& name) {
  std::string known;
  for (const ExportFormat& format : exportFormats()) {
    if (format.name == name) return format;
    known.append(known.empty() ? "" : ", ").append(format.name);
  }
  return sim::Problem{"--format", "there is no export format " + inQuotes(name), "use one of: " + known};
}

std::filesystem::path numberedPath(const std::filesystem::path& path, std::size_t number) {
  std::string digits = std::to_string(number);
  digits.insert(0, 4 - std::min<std::size_t>(4, digits.size()), '0');
  std::filesystem::path numbered = path;
  return numbered.replace_extension("." + digits + path.extension().string());
}

}  // namespace modeling
