#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "sim/collider/triangle_mesh.h"

/// Mesh files as other programs write them, of our own making.
namespace tests {

/// The bytes of numbers, one after the other, the lowest byte first.
template <class Number>
std::string bytesOf(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

sim::TriangleMesh moved(const sim::TriangleMesh& mesh, const sim::Vec3& by);
sim::TriangleMesh insideOut(const sim::TriangleMesh& mesh);
/// Both, as one mesh.
sim::TriangleMesh together(const sim::TriangleMesh& a, const sim::TriangleMesh& b);

std::string objText(const sim::TriangleMesh& mesh);
std::string stlText(const sim::TriangleMesh& mesh, const std::string& name = "part");
/// `head` is filled up to its 80 bytes.
std::string stlBytes(const sim::TriangleMesh& mesh, const std::string& head = "");

/// A glTF being put together.
class GltfMaker {
 public:
  /// Adds bytes as a buffer view; gives its number.
  std::size_t view(const std::string& bytes);
  /// Adds numbers as an accessor; gives its number. `type`: "VEC3".
  std::size_t floats(const std::vector<float>& numbers, const std::string& type);
  std::size_t accessor(nlohmann::json accessor);
  /// A mesh of one primitive of the corners and triangles; gives the mesh's number.
  std::size_t mesh(const sim::TriangleMesh& mesh);
  std::size_t node(nlohmann::json node);

  /// One that reads text; with its bytes as a data address.
  std::string gltf() const;
  std::string glb() const;

  nlohmann::json root = {{"asset", {{"version", "2.0"}}}};
  std::string bytes;
};

std::string base64(const std::string& bytes);

}  // namespace tests
