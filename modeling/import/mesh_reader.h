#pragma once

#include <filesystem>
#include <string>

#include "modeling/import/attendance.h"
#include "modeling/import/raw_mesh.h"

namespace modeling {

/// In small letters, with its dot.
std::string endingOf(const std::filesystem::path& file);

/// Reads the file by the reader of its ending in a process of its own (reading_process.h). A Problem without
/// a place when it is none of the formats, damaged, too much, or has no faces.
Reading readMeshApart(const std::filesystem::path& file, const Attendance& attendance);

}  // namespace modeling
