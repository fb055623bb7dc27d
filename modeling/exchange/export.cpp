#include "modeling/exchange/export.h"

#include <algorithm>
#include <cstdio>

#include "modeling/exchange/frame_loop.h"
#include "modeling/text/spelling.h"

namespace modeling {
namespace {

using Files = std::vector<PlannedFile>;

std::filesystem::path withEnding(std::filesystem::path path, const std::string& ending) {
  return path.replace_extension(ending);
}

Files framesOf(const ExportRequest& request, const FileKind& kind) {
  Files files;
  for (std::size_t frame = request.firstFrame; frame <= request.lastFrame; ++frame)
    files.push_back({framePath(request, frame), &kind});
  return files;
}

Files filesOfGlb(const ExportRequest& request) {
  return {{request.path, &kinds::glb}};
}

Files filesOfXyz(const ExportRequest& request) {
  return {{request.path, &kinds::xyz}};
}

/// FILE.obj.mtl, beside each surface.
PlannedFile materialsOf(std::filesystem::path surface) {
  return {surface += ".mtl", &kinds::mtl};
}

Files filesOfObj(const ExportRequest& request) {
  Files files;
  for (PlannedFile& frame : framesOf(request, kinds::obj)) {
    files.push_back(materialsOf(frame.path));
    files.push_back(std::move(frame));
  }
  return files;
}

Files filesOfPly(const ExportRequest& request) {
  return framesOf(request, kinds::ply);
}

Files filesOfPc2(const ExportRequest& request) {
  return {{request.path, &kinds::pc2},
          {withEnding(request.path, ".obj"), &kinds::obj},
          materialsOf(withEnding(request.path, ".obj"))};
}

Files filesOfVtk(const ExportRequest& request) {
  ExportRequest grids = request;
  grids.path.replace_extension(".vtu");
  Files files = framesOf(grids, kinds::vtk);
  files.push_back({withEnding(request.path, ".pvd"), &kinds::vtk});
  return files;
}

Files filesOfCsv(const ExportRequest& request) {
  return {{request.path, &kinds::csv},
          {sideTable(request.path, "events"), &kinds::csv},
          {sideTable(request.path, "ledger"), &kinds::csv}};
}

Files filesOfLammps(const ExportRequest& request) {
  return {{withEnding(request.path, ".data"), &kinds::lammps},
          {withEnding(request.path, ".in"), &kinds::lammps}};
}

}  // namespace

const std::vector<ExportFormat>& exportFormats() {
  static const std::vector<ExportFormat> kFormats{
      {"glb", "fragments as rigid pieces that move, for Blender and others (glTF 2.0)", writeGlb, filesOfGlb,
       ExportedSurface::cells},
      {"xyz", "positions and velocities of all nodes (extended XYZ)", writeXyz, filesOfXyz},
      {"obj", "the surface of each frame (Wavefront OBJ)", writeObj, filesOfObj,
       ExportedSurface::cellsOrLevel},
      {"ply", "the surface of each frame, with damage and fragments (binary PLY)", writePly, filesOfPly,
       ExportedSurface::cellsOrLevel},
      {"pc2", "the surface with all its breaks from the start, deforming (point cache and OBJ)", writePc2,
       filesOfPc2, ExportedSurface::cells},
      {"vtk", "nodes, bonds and their strain, for ParaView (.vtu and .pvd)", writeVtk, filesOfVtk},
      {"csv", "tables of fragments, breaks and energies", writeCsv, filesOfCsv},
      {"lammps", "a run that goes on from the first frame on LAMMPS (data and input)", writeLammps,
       filesOfLammps},
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
