#include "modeling/exchange/obj_surface.h"

#include <algorithm>
#include <tuple>

#include "modeling/exchange/surface_vertices.h"
#include "modeling/text/text_output.h"
#include "sim/surface/level_surface.h"

namespace modeling {

namespace {

/// Far below anything seen (0.1 nm in a metre), and half the size of the full 17.
constexpr int kDigits = 9;

void writeMaterial(const std::string& name, const Colour& colour, double gloss, TextOutput& out) {
  // Blinn-Phong stand-ins for a glaze: its reflectance straight on, and a highlight as wide as a window's.
  const double specular = 0.04 * gloss;
  out << "newmtl " << name << "\nKa 0 0 0\nKd " << sim::Vec3(colour[0], colour[1], colour[2]) << "\nKs "
      << sim::Vec3::Constant(specular) << "\nNs " << 10.0 + 490.0 * gloss << "\nd 1\nillum 2\n\n";
}

void writeFaces(const sim::SurfaceMesh& mesh, const SurfaceVertices& made,
                const std::vector<std::string>& names, TextOutput& out) {
  auto corner = made.corners.begin();
  sim::FragmentId fragment = sim::kNone;
  std::tuple<sim::MaterialIndex, bool> material;
  for (const auto& face : mesh.faces) {
    const bool newFragment = face.fragment != fragment;
    if (newFragment) out << "g fragment_" << static_cast<std::uint64_t>(face.fragment) << "\n";
    if (newFragment || material != std::tuple(face.material, face.inside)) {
      out << "usemtl " << names[face.material] << (face.inside ? "_inside" : "_outside") << "\n";
    }
    fragment = face.fragment;
    material = {face.material, face.inside};
    out << "f";
    for (unsigned c = 0; c < face.cornerCount; ++c, ++corner)
      out << " " << std::uint64_t{*corner + 1U} << "//" << std::uint64_t{*corner + 1U};
    out << "\n";
  }
}

sim::Status writeMaterialLibrary(const std::filesystem::path& path, const std::vector<std::string>& names,
                                 const std::vector<Look>& looks) {
  TextOutput out(path, kDigits);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
        names.begin() + static_cast<std::ptrdiff_t>(i))
      continue;
    writeMaterial(names[i] + "_outside", looks[i].outside, looks[i].glaze, out);
    writeMaterial(names[i] + "_inside", looks[i].inside, 0.0, out);
  }
  return out.finish();
}

}  // namespace

sim::SurfaceMesh surfaceOf(const sim::TakeReader& take, const sim::Snapshot& frame,
                           const ExportRequest& request, sim::SurfaceBuilder& builder) {
  return request.levelSurface ? sim::levelSurfaceOf(take.network(), frame, {}) : builder.build(frame);
}

std::vector<std::string> materialNames(const sim::Network& network) {
  std::vector<std::string> names;
  for (const sim::Material& material : network.materials) {
    names.push_back(oneWord(material.name, "material"));
  }
  return names;
}

sim::Status writeObjSurface(const std::filesystem::path& path, const std::vector<std::string>& names,
                            const std::vector<Look>& looks, const sim::SurfaceMesh& mesh,
                            const std::string& remark) {
  std::filesystem::path library = path;
  library += ".mtl";
  if (auto status = writeMaterialLibrary(library, names, looks); !status) return status;
  const SurfaceVertices made = verticesOf(mesh);
  TextOutput out(path, kDigits);
  out << "# Smithereens surface, cm, z up\n" << remark << "mtllib " << library.filename().string() << "\n";
  for (const SurfaceVertex& vertex : made.vertices) out << "v " << mesh.points[vertex.point] << "\n";
  for (const SurfaceVertex& vertex : made.vertices) out << "vn " << mesh.normals[vertex.normal] << "\n";
  writeFaces(mesh, made, names, out);
  return out.finish();
}

}  // namespace modeling
