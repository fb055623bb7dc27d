#include "modeling/import/raw_mesh.h"

#include "modeling/import/polygon.h"

namespace modeling {
namespace {

using sim::Problem;
using sim::Vec3;

const char* const kAnew = "export it anew, as glTF, OBJ, PLY or STL";

sim::Status checkCorner(std::int64_t corner, const std::string& which, const RawMesh& raw) {
  const auto count = static_cast<std::int64_t>(raw.points.size());
  if (corner >= 0 && corner < count) return sim::Done{};
  return Problem{"",
                 which + ": this face names corner number " + std::to_string(corner + 1) + " of " +
                     std::to_string(count),
                 kAnew};
}

sim::Status checkCount(const RawMesh& raw) {
  if (raw.triangles.size() <= kMostTriangles) return sim::Done{};
  return Problem{"", "it has more than " + std::to_string(kMostTriangles) + " triangles",
                 "use a mesh of fewer faces"};
}

}  // namespace

void RawMesh::stateUp(char axis, Statement by) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  axesSaid = by;
  if (axis == 'x') axes = {Vec3(-y), Vec3(-z), x};
  if (axis == 'y') axes = {x, Vec3(-z), y};
  if (axis == 'z') axes = {x, y, z};
}

sim::Status addPolygon(const std::vector<std::int64_t>& corners, const std::string& which, RawMesh& raw) {
  std::vector<std::uint32_t> ring;
  for (const std::int64_t corner : corners) {
    if (auto status = checkCorner(corner, which, raw); !status) return status;
    ring.push_back(static_cast<std::uint32_t>(corner));
  }
  const std::size_t before = raw.triangles.size();
  addTrianglesOf(ring, raw.points, raw.triangles);
  if (raw.triangles.size() == before) ++raw.flatFaces;
  return checkCount(raw);
}

sim::Status addStrip(const std::vector<std::int64_t>& corners, const std::string& which, RawMesh& raw) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const bool isOdd = i % 2 == 1;
    const std::array<std::int64_t, 3> three{corners[i - (isOdd ? 1 : 2)], corners[i - (isOdd ? 2 : 1)],
                                            corners[i]};
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t c = 0; c < 3; ++c) {
      if (auto status = checkCorner(three[c], which, raw); !status) return status;
      triangle[c] = static_cast<std::uint32_t>(three[c]);
    }
    raw.triangles.push_back(triangle);
  }
  return checkCount(raw);
}

sim::ByteWriter bytesOf(const Reading& reading) {
  sim::ByteWriter bytes;
  bytes.put<std::uint8_t>(reading.ok() ? 1 : 0);
  if (!reading) {
    bytes.putString(reading.problem().what);
    bytes.putString(reading.problem().remedy);
    return bytes;
  }
  bytes.putVector(reading->points);
  bytes.putVector(reading->triangles);
  bytes.put(reading->unit);
  bytes.put(reading->unitSaid);
  bytes.put(reading->axesSaid);
  for (const Vec3& axis : reading->axes) bytes.put(axis);
  bytes.put(reading->loosePoints);
  bytes.put(reading->wires);
  bytes.put(reading->flatFaces);
  bytes.putString(reading->note);
  return bytes;
}

Reading readingOf(const std::vector<std::byte>& bytes) {
  sim::ByteReader reader(bytes);
  const Problem damaged{"", "the reader of this format failed at this file, which may be sound or damaged",
                        kAnew};
  std::uint8_t isMesh = 0;
  reader.read(isMesh);
  if (isMesh == 0) {
    Problem problem;
    reader.readString(problem.what);
    reader.readString(problem.remedy);
    return reader.finished() ? problem : damaged;
  }
  RawMesh raw;
  reader.readVector(raw.points);
  reader.readVector(raw.triangles);
  reader.read(raw.unit);
  reader.read(raw.unitSaid);
  reader.read(raw.axesSaid);
  for (Vec3& axis : raw.axes) reader.read(axis);
  reader.read(raw.loosePoints);
  reader.read(raw.wires);
  reader.read(raw.flatFaces);
  reader.readString(raw.note);
  for (const auto& triangle : raw.triangles)
    for (const std::uint32_t point : triangle)
      if (point >= raw.points.size()) return damaged;
  return reader.finished() ? Reading(std::move(raw)) : damaged;
}

}  // namespace modeling
