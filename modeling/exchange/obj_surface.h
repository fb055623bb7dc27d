#pragma once

#include <string>
#include <vector>

#include "modeling/exchange/export.h"
#include "modeling/exchange/take_scene.h"
#include "sim/surface/surface_mesh.h"

/// The pieces of Wavefront OBJ files that several formats are made of.
namespace modeling {

/// The surface of a frame that was asked for.
sim::SurfaceMesh surfaceOf(const sim::TakeReader& take, const sim::Snapshot& frame,
                           const ExportRequest& request, sim::SurfaceBuilder& builder);

/// One word a material. Entries of one name are one material to look at.
std::vector<std::string> materialNames(const sim::Network& network);

/// Writes FILE.obj, and beside it its materials, NAME_outside and NAME_inside for each name. They are in
/// FILE.obj.mtl, where VTK looks for them whatever the file says. A vertex is a point with one normal, in the
/// order of verticesOf(). `remark`: lines for the head, each with its "# ".
sim::Status writeObjSurface(const std::filesystem::path& path, const std::vector<std::string>& names,
                            const std::vector<Look>& looks, const sim::SurfaceMesh& mesh,
                            const std::string& remark);

}  // namespace modeling
