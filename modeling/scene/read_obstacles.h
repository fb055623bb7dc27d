#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeling/import/attendance.h"
#include "modeling/scene/scene.h"

namespace modeling {

/// An obstacle stands in the head of every take of its scene, as text.
inline constexpr std::size_t kMostObstacleTriangles = 100'000;

/// Reads the surfaces of obstacles that only name their file. `remarks` gets how each was taken. A Problem's
/// place is a path of the scene, and it names the file.
sim::Status readObstacles(Scene& scene, const std::filesystem::path& folder,
                          std::vector<std::string>& remarks, const Attendance& attendance);

/// Gives obstacles that only name their file the surfaces that obstacles of the same file have in another
/// scene. A Problem where one has none there: its place is a path of the scene.
sim::Status takeOverSurfaces(const Scene& from, Scene& scene);

}  // namespace modeling
