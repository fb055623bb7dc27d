#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/take/take.h"

namespace modeling {

/// What to write of a take, and where.
struct ExportRequest {
  std::filesystem::path path;
  std::size_t firstFrame = 0;
  std::size_t lastFrame = 0;  ///< inclusive, below the take's frame count
  /// Told the share that is done; answers false to cancel. Files that are whole by then stay.
  std::function<bool(double)> progress;
};

/// A file format that takes can be written in. Every file appears whole or not at all.
struct ExportFormat {
  std::string name;     ///< as it is asked for, and the usual end of its file names
  std::string summary;  ///< for help
  sim::Status (*write)(const sim::TakeReader& take, const ExportRequest& request);
};

/// All formats, in the order in which help lists them.
const std::vector<ExportFormat>& exportFormats();

/// A Problem that names the formats there are.
sim::Result<ExportFormat> exportFormatNamed(const std::string& name);

/// Extended XYZ, read by OVITO and ASE: all frames in one file, nodes in network order, cm and cm/s with 17
/// significant digits, which read back to the same numbers. The comment line of a frame names the columns and
/// states Time (s) and Step (count). The species is the node's material.
sim::Status writeXyz(const sim::TakeReader& take, const ExportRequest& request);

/// Wavefront OBJ of the surface (sim/network/surface_mesh.h): one file a frame, numbered as numberedPath()
/// says, or the path itself for a single frame, and one .mtl for all. cm, z up; a group a fragment; vertex
/// normals; materials MATERIAL_outside and MATERIAL_inside.
sim::Status writeObj(const sim::TakeReader& take, const ExportRequest& request);

/// "folder/name.png" and 12 -> "folder/name.0012.png".
std::filesystem::path numberedPath(const std::filesystem::path& path, std::size_t number);

}  // namespace modeling
