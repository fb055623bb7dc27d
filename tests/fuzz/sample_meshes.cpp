#include "tests/fuzz/sample_meshes.h"

#include <bit>
#include <sstream>

#include "sim/base/bytes.h"
#include "tests/support/meshes.h"

namespace tests {
namespace {

using sim::TriangleMesh;
using sim::Vec3;

std::string textOf(const sim::ByteWriter& bytes) {
  return {reinterpret_cast<const char*>(bytes.bytes().data()), bytes.size()};
}

void putPoint(sim::ByteWriter& bytes, const Vec3& point) {
  for (const double coordinate : point) bytes.put(static_cast<float>(coordinate));
}

std::string obj(const TriangleMesh& mesh) {
  std::ostringstream text;
  text << "# a box\no box\nvn 0 0 1\nvt 0 0\nusemtl plain\n";
  for (const Vec3& point : mesh.points()) text << "v " << point.transpose() << "\n";
  for (const auto& [a, b, c] : mesh.triangles())
    text << "f " << a + 1 << "/1/1 " << b + 1 << "/1/1 " << c + 1 << "/1/1\n";
  return text.str();
}

std::string stlWords(const TriangleMesh& mesh) {
  std::ostringstream text;
  text << "solid ball\n";
  for (const TriangleMesh::Triangle& triangle : mesh.triangles()) {
    text << " facet normal 0 0 0\n  outer loop\n";
    for (const std::uint32_t point : triangle)
      text << "   vertex " << mesh.points()[point].transpose() << "\n";
    text << "  endloop\n endfacet\n";
  }
  text << "endsolid ball\n";
  return text.str();
}

std::string stl(const TriangleMesh& mesh) {
  sim::ByteWriter bytes;
  std::string head = "a ball, as bytes";
  head.resize(80, ' ');
  bytes.putBytes(std::as_bytes(std::span(head)));
  bytes.put(static_cast<std::uint32_t>(mesh.triangles().size()));
  for (const TriangleMesh::Triangle& triangle : mesh.triangles()) {
    putPoint(bytes, Vec3::Zero());
    for (const std::uint32_t point : triangle) putPoint(bytes, mesh.points()[point]);
    bytes.put(std::uint16_t{0});
  }
  return textOf(bytes);
}

std::string plyHead(const TriangleMesh& mesh, const std::string& format) {
  std::ostringstream text;
  text << "ply\nformat " << format << " 1.0\ncomment a ball\nelement vertex " << mesh.points().size()
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.triangles().size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  return text.str();
}

std::string plyWords(const TriangleMesh& mesh) {
  std::ostringstream text;
  text << plyHead(mesh, "ascii");
  for (const Vec3& point : mesh.points()) text << point.transpose() << "\n";
  for (const auto& [a, b, c] : mesh.triangles()) text << "3 " << a << " " << b << " " << c << "\n";
  return text.str();
}

std::string ply(const TriangleMesh& mesh) {
  sim::ByteWriter bytes;
  for (const Vec3& point : mesh.points()) putPoint(bytes, point);
  for (const TriangleMesh::Triangle& triangle : mesh.triangles()) {
    bytes.put(std::uint8_t{3});
    for (const std::uint32_t point : triangle) bytes.put(point);
  }
  return plyHead(mesh, "binary_little_endian") + textOf(bytes);
}

/// In metres.
std::string glb(const TriangleMesh& mesh) {
  sim::ByteWriter data;
  for (const Vec3& point : mesh.points()) putPoint(data, point);
  const std::size_t indices = data.size();
  for (const TriangleMesh::Triangle& triangle : mesh.triangles()) {
    for (const std::uint32_t point : triangle) data.put(point);
  }
  const Vec3 low = mesh.box().min(), high = mesh.box().max();
  std::ostringstream json;
  json
      << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[1,2,1]}],)"
      << R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":)"
      << data.size() << R"(}],"bufferViews":[{"buffer":0,"byteLength":)" << indices
      << R"(},{"buffer":0,"byteOffset":)" << indices << R"(,"byteLength":)" << data.size() - indices
      << R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)"
      << mesh.points().size() << R"(,"min":[)" << low.x() << "," << low.y() << "," << low.z()
      << R"(],"max":[)" << high.x() << "," << high.y() << "," << high.z()
      << R"(]},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" << 3 * mesh.triangles().size()
      << "}]}";
  std::string text = json.str();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  sim::ByteWriter bytes;
  for (const std::uint64_t word :
       {std::uint64_t{0x46546c67}, std::uint64_t{2}, 28 + text.size() + data.size(), text.size()})
    bytes.put(static_cast<std::uint32_t>(word));
  bytes.put(std::uint32_t{0x4e4f534a});
  bytes.putBytes(std::as_bytes(std::span(text)));
  bytes.put(static_cast<std::uint32_t>(data.size()));
  bytes.put(std::uint32_t{0x004e4942});
  bytes.putBytes(data.bytes());
  return textOf(bytes);
}

}  // namespace

std::map<std::string, std::string> sampleMeshes() {
  const TriangleMesh box = boxMesh({2, 1, 1});
  const TriangleMesh ball = ballMesh(2.0, 6);
  return {{"box.obj", obj(box)},
          {"ball.stl", stl(ball)},
          {"ball-words.stl", stlWords(ball)},
          {"ball-words.ply", plyWords(ball)},
          {"ball.ply", ply(ball)},
          {"ball.glb", glb(ballMesh(0.02, 6))}};
}

}  // namespace tests
