#include "modeling/import/mesh_reader.h"

#include "modeling/import/assimp_reader.h"
#include "modeling/import/file_bytes.h"
#include "modeling/import/gltf_reader.h"
#include "modeling/import/mesh_text.h"
#include "modeling/import/obj_reader.h"
#include "modeling/import/ply_reader.h"
#include "modeling/import/reading_process.h"
#include "modeling/import/stl_reader.h"

namespace modeling {
namespace {

using sim::Problem;

Reading readByEnding(const std::filesystem::path& file, std::string_view bytes, const std::string& ending) {
  if (ending == ".fbx" || ending == ".dae") return readByAssimp(file, bytes, ending);
  if (ending == ".gltf" || ending == ".glb") return readGltf(bytes, file.parent_path());
  if (ending == ".stl") return readStl(bytes);
  return ending == ".ply" ? readPly(bytes) : readObj(bytes);
}

/// What there is in place of faces.
Problem noFaces(const RawMesh& raw) {
  const std::string what = "there are no faces in this file";
  if (raw.flatFaces > 0)
    return {"", "none of the " + std::to_string(raw.flatFaces) + " faces of this mesh has an area",
            "export a mesh of faces"};
  if (raw.wires > 0) return {"", what + ", only lines", "export a mesh of faces"};
  if (raw.loosePoints > 0 || !raw.points.empty())
    return {"", what + ", only points", "make a mesh of them first, by a program for scans, and export that"};
  return {"", what, "export a mesh of faces"};
}

Reading readHere(const std::filesystem::path& file) {
  const auto bytes = fileBytes(file);
  if (!bytes) return bytes.problem();
  const std::string ending = endingOf(file);
  if (const auto other = whatElse(*bytes, ending)) return *other;
  std::string_view text = *bytes;
  static constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";
  if (text.starts_with(kUtf8Mark)) text.remove_prefix(kUtf8Mark.size());
  Reading raw = readByEnding(file, text, ending);
  return raw.ok() && raw->triangles.empty() ? noFaces(*raw) : std::move(raw);
}

}  // namespace

std::string endingOf(const std::filesystem::path& file) {
  return inLowerCase(file.extension().string());
}

Reading readMeshApart(const std::filesystem::path& file, const Attendance& attendance) {
  const auto bytes = readApart(
      file.filename().string(), [&] { return bytesOf(readHere(file)); }, {}, attendance);
  return bytes ? readingOf(*bytes) : bytes.problem();
}

}  // namespace modeling
