#include "tests/support/mesh_writers.h"

#include <cstring>
#include <sstream>

namespace tests {

using nlohmann::json;
using sim::TriangleMesh;
using sim::Vec3;

TriangleMesh moved(const TriangleMesh& mesh, const Vec3& by) {
  std::vector<Vec3> points = mesh.points();
  for (Vec3& point : points) point += by;
  return {points, mesh.triangles()};
}

TriangleMesh insideOut(const TriangleMesh& mesh) {
  auto triangles = mesh.triangles();
  for (auto& triangle : triangles) std::swap(triangle[0], triangle[1]);
  return {mesh.points(), triangles};
}

TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b) {
  std::vector<Vec3> points = a.points();
  points.insert(points.end(), b.points().begin(), b.points().end());
  auto triangles = a.triangles();
  const auto first = static_cast<std::uint32_t>(a.points().size());
  for (const auto& t : b.triangles()) triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return {points, triangles};
}

std::string objText(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  for (const Vec3& point : mesh.points())
    text << "v " << point.x() << ' ' << point.y() << ' ' << point.z() << '\n';
  for (const auto& t : mesh.triangles())
    text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  return text.str();
}

std::string stlText(const TriangleMesh& mesh, const std::string& name) {
  std::ostringstream text;
  text << "solid " << name << '\n';
  for (const auto& triangle : mesh.triangles()) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t point : triangle) {
      const Vec3& at = mesh.points()[point];
      text << "vertex " << at.x() << ' ' << at.y() << ' ' << at.z() << '\n';
    }
    text << "endloop\nendfacet\n";
  }
  text << "endsolid " << name << '\n';
  return text.str();
}

std::string stlBytes(const TriangleMesh& mesh, const std::string& head) {
  std::string bytes = head;
  bytes.resize(80, '\0');
  bytes += bytesOf(std::vector<std::uint32_t>{static_cast<std::uint32_t>(mesh.triangles().size())});
  for (const auto& triangle : mesh.triangles()) {
    std::vector<float> numbers(3, 0.0F);
    for (const std::uint32_t point : triangle)
      for (const double number : mesh.points()[point]) numbers.push_back(static_cast<float>(number));
    bytes += bytesOf(numbers) + std::string(2, '\0');
  }
  return bytes;
}

std::size_t GltfMaker::view(const std::string& added) {
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
  root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", added.size()}});
  bytes += added;
  return root["bufferViews"].size() - 1;
}

std::size_t GltfMaker::accessor(json accessor) {
  root["accessors"].push_back(std::move(accessor));
  return root["accessors"].size() - 1;
}

std::size_t GltfMaker::floats(const std::vector<float>& numbers, const std::string& type) {
  const std::size_t width = type == "SCALAR" ? 1 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
  return accessor({{"bufferView", view(bytesOf(numbers))},
                   {"componentType", 5126},
                   {"count", numbers.size() / width},
                   {"type", type}});
}

std::size_t GltfMaker::mesh(const TriangleMesh& mesh) {
  std::vector<float> corners;
  for (const Vec3& point : mesh.points())
    for (const double number : point) corners.push_back(static_cast<float>(number));
  std::vector<std::uint16_t> indices;
  for (const auto& triangle : mesh.triangles())
    for (const std::uint32_t point : triangle) indices.push_back(static_cast<std::uint16_t>(point));
  const std::size_t positions = floats(corners, "VEC3");
  const std::size_t faces = accessor({{"bufferView", view(bytesOf(indices))},
                                      {"componentType", 5123},
                                      {"count", indices.size()},
                                      {"type", "SCALAR"}});
  const json primitive = {{"attributes", {{"POSITION", positions}}}, {"indices", faces}};
  root["meshes"].push_back({{"primitives", json::array({primitive})}});
  return root["meshes"].size() - 1;
}

std::size_t GltfMaker::node(json node) {
  root["nodes"].push_back(std::move(node));
  return root["nodes"].size() - 1;
}

std::string GltfMaker::gltf() const {
  json whole = root;
  whole["buffers"] = {
      {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
  return whole.dump();
}

std::string GltfMaker::glb() const {
  json whole = root;
  if (whole["buffers"].empty()) whole["buffers"].push_back(json::object());
  whole["buffers"][0]["byteLength"] = bytes.size();
  std::string text = whole.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string binary = bytes;
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  const auto words = [](std::uint32_t a, std::uint32_t b) { return bytesOf(std::vector{a, b}); };
  const auto size = [](const std::string& chunk) { return static_cast<std::uint32_t>(chunk.size()); };
  return "glTF" + words(2, 28 + size(text) + size(binary)) + words(size(text), 0x4E4F534A) + text +
         words(size(binary), 0x004E4942) + binary;
}

std::string base64(const std::string& bytes) {
  static const std::string kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t c = 0; c < 3; ++c)
      three = (three << 8U) | (i + c < bytes.size() ? static_cast<unsigned char>(bytes[i + c]) : 0U);
    for (std::size_t c = 0; c < 4; ++c)
      text += i + c > bytes.size() ? '=' : kDigits[(three >> (18 - 6 * c)) & 63U];
  }
  return text;
}

}  // namespace tests
