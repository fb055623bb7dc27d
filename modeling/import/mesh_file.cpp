#include "modeling/import/mesh_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "modeling/import/mesh_reader.h"

namespace modeling {

namespace {

using sim::Vec3;

using sim::Problem;

struct UnitName {
  MeshUnit unit;
  double centimetres;
  const char* name;
};
/// In the order in which they are guessed.
constexpr std::array<UnitName, 4> kUnits{{{MeshUnit::centimetre, 1.0, "centimetres"},
                                          {MeshUnit::millimetre, 0.1, "millimetres"},
                                          {MeshUnit::metre, 100.0, "metres"},
                                          {MeshUnit::inch, 2.54, "inches"}}};
/// What dishware measures at its longest, cm: from an egg cup to a platter.
constexpr double kSmallestDish = 3.0;
constexpr double kLargestDish = 60.0;
/// Corners nearer than this share of the mesh's size are one.
constexpr double kOnePlace = 1e-7;

std::string endingOf(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

bool isMetric(const std::string& ending) {
  return ending == ".glb" || ending == ".gltf" || ending == ".dae";
}

struct Unit {
  double centimetres = 1.0;
  std::string words;
};

Unit named(MeshUnit unit) {
  for (const UnitName& known : kUnits)
    if (known.unit == unit) return {known.centimetres, std::string("in ") + known.name};
  return {};
}

/// The unit as asked for, as the format says, or in which the mesh is as large as dishware.
Unit unitOf(const MeshSource& source, const RawMesh& raw, const std::string& ending, double size) {
  if (source.unit != MeshUnit::guess) return named(source.unit);
  if (isMetric(ending)) return {100.0, "in metres, as its format says"};
  if (raw.unit > 0.0 && std::isfinite(raw.unit)) return {raw.unit, "in the unit that it states"};
  for (const UnitName& guess : kUnits) {
    const double length = size * guess.centimetres;
    if (length < kSmallestDish || length > kLargestDish) continue;
    Unit unit = named(guess.unit);
    unit.words += " by a guess at its size (state its unit to be sure)";
    return unit;
  }
  Unit unit = named(MeshUnit::centimetre);
  unit.words += ", as no unit makes it as large as dishware (state its unit)";
  return unit;
}

bool isYUp(const MeshSource& source, const RawMesh& raw, const std::string& ending) {
  if (source.up != MeshUp::guess) return source.up == MeshUp::y;
  return isMetric(ending) || raw.up == 1 || (raw.up == 0 && ending == ".fbx");
}

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

sim::TriangleMesh welded(const RawMesh& raw, double scale, bool yUp, double size) {
  Welder welder(size * scale * kOnePlace);
  std::vector<std::uint32_t> place(raw.points.size(), sim::kNone);
  std::vector<sim::TriangleMesh::Triangle> triangles;
  for (const auto& triangle : raw.triangles) {
    sim::TriangleMesh::Triangle& made = triangles.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t& at = place[triangle[c]];
      const Vec3 point = scale * raw.points[triangle[c]];
      if (at == sim::kNone) at = welder.add(yUp ? Vec3(point.x(), -point.z(), point.y()) : point);
      made[c] = at;
    }
  }
  return {std::move(welder.points), triangles};
}

sim::TriangleMesh turnedInsideOut(const sim::TriangleMesh& mesh) {
  auto triangles = mesh.triangles();
  for (auto& triangle : triangles) std::swap(triangle[1], triangle[2]);
  return {mesh.points(), triangles};
}

sim::Status checkFile(const std::filesystem::path& file, const std::string& ending) {
  std::string known;
  for (const std::string& name : meshFileEndings()) known += (known.empty() ? "" : ", ") + name;
  const auto& endings = meshFileEndings();
  if (std::find(endings.begin(), endings.end(), ending) == endings.end())
    return Problem{file.string(), "this is no format of meshes that can be read", "use one of " + known};
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return Problem{file.string(), "cannot read this file", "look at its name and place"};
  if (size > kLargestMeshFile) {
    return Problem{file.string(),
                   "this file is larger than " + std::to_string(kLargestMeshFile >> 20U) + " MB",
                   "use a mesh of fewer faces"};
  }
  return sim::Done{};
}

sim::Result<double> sizeOf(const RawMesh& raw, const std::filesystem::path& file) {
  Eigen::AlignedBox3d box;
  for (const auto& triangle : raw.triangles) {
    for (const std::uint32_t point : triangle) {
      if (point >= raw.points.size() || !raw.points[point].allFinite() ||
          raw.points[point].cwiseAbs().maxCoeff() > 1e12)
        return Problem{file.string(), "a corner of this mesh is nowhere", "export it anew"};
      box.extend(raw.points[point]);
    }
  }
  if (box.isEmpty() || !(box.diagonal().maxCoeff() > 0.0))
    return Problem{file.string(), "there are no faces in this file", "export a mesh of faces"};
  return box.diagonal().maxCoeff();
}

std::string remarkOn(const std::filesystem::path& file, const sim::TriangleMesh& mesh, const Unit& unit,
                     bool yUp, bool turned) {
  std::ostringstream words;
  words.precision(3);
  const Vec3 size = mesh.box().diagonal();
  words << file.filename().string() << " is taken " << unit.words << " and with " << (yUp ? "y" : "z")
        << " up: " << size.x() << " x " << size.y() << " x " << size.z() << " cm, " << mesh.triangles().size()
        << " triangles";
  if (turned) words << "; it was inside out, and was turned";
  return words.str();
}

}  // namespace

const std::vector<std::string>& meshFileEndings() {
  static const std::vector<std::string> kEndings{".obj", ".ply", ".stl", ".gltf", ".glb", ".fbx", ".dae"};
  return kEndings;
}

sim::Result<MeshFile> loadMesh(const std::filesystem::path& folder, const MeshSource& source) {
  const std::filesystem::path file = folder / source.file;
  const std::string ending = endingOf(file);
  if (auto status = checkFile(file, ending); !status) return status.problem();
  const auto raw = readMeshApart(file);
  if (!raw) return raw.problem();
  const auto size = sizeOf(*raw, file);
  if (!size) return size.problem();
  const Unit unit = unitOf(source, *raw, ending, *size);
  const bool yUp = isYUp(source, *raw, ending);
  sim::TriangleMesh mesh = welded(*raw, unit.centimetres, yUp, *size);
  const bool insideOut = mesh.closed() && mesh.volume() < 0.0;
  if (insideOut) mesh = turnedInsideOut(mesh);
  std::string remark = remarkOn(file, mesh, unit, yUp, insideOut);
  return MeshFile{std::move(mesh), std::move(remark)};
}

}  // namespace modeling
