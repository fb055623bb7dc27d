#pragma once

#include <filesystem>
#include <vector>

#include "modeling/assembly/assembly.h"
#include "modeling/glue/glue.h"
#include "modeling/import/attendance.h"
#include "modeling/material/material.h"
#include "modeling/scene/scene.h"
#include "sim/base/result.h"

namespace modeling {

/// The scene's parts in the world, and the materials they refer to: the scene's own in their order, then
/// those that raw networks need for their bond types.
struct BuiltParts {
  std::vector<AssemblyPart> parts;
  std::vector<Material> materials;
  std::vector<std::string> remarks;  ///< how meshes were taken and filled
};

/// A Problem's place is as build() says.
sim::Result<BuiltParts> buildParts(const Scene& scene, const std::filesystem::path& folder,
                                   const Attendance& attendance = {});

/// The parts, and the scene's gluings of them, as glue() takes them.
std::vector<GluePart> glueParts(const std::vector<AssemblyPart>& parts);
std::vector<GlueSettings> glueSettings(const Scene& scene, const std::vector<AssemblyPart>& parts);

}  // namespace modeling
