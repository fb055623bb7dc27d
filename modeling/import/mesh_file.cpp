#include "modeling/import/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "modeling/import/file_bytes.h"
#include "modeling/import/mesh_bodies.h"
#include "modeling/import/mesh_reader.h"
#include "modeling/import/mesh_units.h"
#include "modeling/text/printable.h"
#include "sim/collider/surface_check.h"

namespace modeling {
namespace {

using sim::Problem;
using sim::Vec3;

/// Corners nearer than this share of the mesh's size are one.
constexpr double kOnePlace = 1e-7;

/// Corners in one place made one: formats without shared corners (STL), and seams of textures, list them
/// anew.
class Welder {
 public:
  explicit Welder(double tolerance) : tolerance_(tolerance) {}

  std::uint32_t add(const Vec3& point) {
    std::array<std::int64_t, 3> key{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      key[axis] = std::llround(point[static_cast<Eigen::Index>(axis)] / tolerance_);
    const auto [found, isNew] = known_.try_emplace(key, static_cast<std::uint32_t>(points.size()));
    if (isNew) points.push_back(point);
    return found->second;
  }

  std::vector<Vec3> points;

 private:
  double tolerance_;
  std::map<std::array<std::int64_t, 3>, std::uint32_t> known_;
};

struct Surface {
  std::vector<Vec3> points;
  std::vector<sim::TriangleMesh::Triangle> triangles;
};

/// `raw` has points in cm.
Surface welded(const RawMesh& raw, double size) {
  Welder welder(size * kOnePlace);
  std::vector<std::uint32_t> place(raw.points.size(), sim::kNone);
  Surface surface;
  for (const auto& triangle : raw.triangles) {
    sim::TriangleMesh::Triangle made{};
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t& at = place[triangle[c]];
      if (at == sim::kNone) at = welder.add(raw.points[triangle[c]]);
      made[c] = at;
    }
    if (made[0] != made[1] && made[1] != made[2] && made[2] != made[0]) surface.triangles.push_back(made);
  }
  surface.points = std::move(welder.points);
  return surface;
}

/// Endings of archives and of files that are packed.
constexpr std::array<std::string_view, 11> kPacked{".gz",  ".tgz", ".zip", ".7z",  ".bz2", ".xz",
                                                   ".zst", ".rar", ".tar", ".zae", ".lz4"};

const Problem kUnreadable{"", "cannot read this file", "look at its name and place"};

sim::Status checkFile(const std::filesystem::path& file, const std::string& ending) {
  const auto& endings = meshFileEndings();
  const auto isKnown = [&](const std::string& one) {
    return std::find(endings.begin(), endings.end(), one) != endings.end();
  };
  std::error_code error;
  if (!isKnown(ending)) {
    if (std::find(kPacked.begin(), kPacked.end(), ending) != kPacked.end() &&
        std::filesystem::exists(file, error))
      return Problem{"", "this file is packed (" + ending + ")", "unpack it first"};
    std::string known;
    for (const std::string& name : endings) known += (known.empty() ? "" : ", ") + name;
    return Problem{"", "this is no format of meshes that can be read", "use one of " + known};
  }
  if (!std::filesystem::is_regular_file(file, error)) return kUnreadable;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return kUnreadable;
  if (size > kLargestMeshFile) {
    return Problem{"", "this file is larger than " + std::to_string(kLargestMeshFile >> 20U) + " MB",
                   "use a mesh of fewer faces"};
  }
  return sim::Done{};
}

Eigen::AlignedBox3d boxOf(const RawMesh& raw) {
  Eigen::AlignedBox3d box;
  for (const auto& triangle : raw.triangles)
    for (const std::uint32_t point : triangle)
      if (raw.points[point].allFinite()) box.extend(raw.points[point]);
  return box;
}

std::string bodiesText(const MeshBodies& bodies) {
  std::string words;
  if (bodies.turned > 0 && bodies.turned == bodies.closed) {
    words = "; it was inside out, and was turned";
  } else if (bodies.turned > 0) {
    words = "; " + std::to_string(bodies.turned) + " of its " + std::to_string(bodies.closed) + " bodies " +
            (bodies.turned == 1 ? "was inside out, and was turned" : "were inside out, and were turned");
  }
  if (bodies.filled > 0) {
    const bool isOne = bodies.filled == 1;
    words += isOne ? "; a closed body lies within another and faces the same way, so that it is filled (to "
                     "make it hollow, "
                     "flip its normals)"
                   : "; " + std::to_string(bodies.filled) +
                         " closed bodies lie within others and face the same way, so that they are filled "
                         "(to make it "
                         "hollow, flip their normals)";
  }
  return words;
}

std::string remarkOn(const MeshSource& source, const sim::TriangleMesh& mesh,
                     const MeshInterpretation& reading, const MeshBodies& bodies, const std::string& note) {
  std::ostringstream words;
  words.precision(3);
  const Vec3 size = mesh.box().diagonal();
  words << std::filesystem::path(source.file).filename().string() << " is taken " << reading.words << ": "
        << size.x() << " x " << size.y() << " x " << size.z() << " cm, " << mesh.triangles().size()
        << " triangles" << bodiesText(bodies);
  if (!note.empty()) words << "; " << note;
  return words.str();
}

sim::Result<MeshFile> load(const std::filesystem::path& folder, const MeshSource& source,
                           const Attendance& attendance) {
  const std::filesystem::path file = folder / source.file;
  const std::string ending = endingOf(file);
  if (const auto status = checkFile(file, ending); !status) return status.problem();
  auto raw = readMeshApart(file, attendance);
  if (!raw) return raw.problem();
  const Eigen::AlignedBox3d box = boxOf(*raw);
  const Vec3 extent = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.diagonal());
  const MeshInterpretation reading = interpretationOf(source, *raw, ending, extent);
  for (Vec3& point : raw->points) point = reading(point);
  if (const auto status = sim::checkSurface(raw->points, raw->triangles); !status) return status.problem();
  Surface surface = welded(*raw, extent.maxCoeff() * reading.unit);
  if (reading.isMirrored())
    for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
  const MeshBodies bodies = turnOutwards(surface.points, surface.triangles);
  sim::TriangleMesh mesh(std::move(surface.points), surface.triangles);
  std::string remark = remarkOn(source, mesh, reading, bodies, raw->note);
  return MeshFile{std::move(mesh), std::move(remark)};
}

}  // namespace

const std::vector<std::string>& meshFileEndings() {
  static const std::vector<std::string> kEndings{".obj", ".ply", ".stl", ".gltf", ".glb", ".fbx", ".dae"};
  return kEndings;
}

sim::Result<MeshFile> loadMesh(const std::filesystem::path& folder, const MeshSource& source,
                               const Attendance& attendance) {
  auto loaded = load(folder, source, attendance);
  if (loaded.ok()) return loaded;
  const Problem& problem = loaded.problem();
  // It may quote what stands in the file, whatever that is.
  return Problem{problem.place, printable(source.file + ": " + problem.what), problem.remedy};
}

}  // namespace modeling
