#include "modeling/import/gltf_primitive.h"

#include <numeric>

namespace modeling {
namespace {

using sim::Problem;
using sim::Status;
using sim::Vec3;

const char* const kDamaged = "this file is damaged: its corners and what belongs to them differ in number";
const char* const kAnew = "copy or export it anew";

/// Attributes by accessors, or out of what Draco has packed.
class Attributes {
 public:
  Attributes(GltfDocument& document, const GltfJson& primitive)
      : document_(document),
        primitive_(primitive),
        packed_(extensionOf(primitive, "KHR_draco_mesh_compression")) {}

  bool has(const std::string& name) const {
    return !member(member(primitive_, "attributes"), name.c_str()).is_null();
  }

  sim::Result<GltfNumbers> read(const std::string& name) {
    const GltfJson& id = member(member(packed_, "attributes"), name.c_str());
    if (id.is_null()) return readAccessor(document_, member(member(primitive_, "attributes"), name.c_str()));
    auto mesh = unpack({static_cast<std::uint32_t>(countOf(id))});
    if (!mesh) return mesh.problem();
    return std::move(mesh->attributes.front());
  }

  sim::Result<std::vector<std::int64_t>> corners(std::size_t points) {
    if (!packed_.is_null()) {
      auto mesh = unpack({});
      if (!mesh) return mesh.problem();
      return std::move(mesh->corners);
    }
    const GltfJson& indices = member(primitive_, "indices");
    std::vector<std::int64_t> corners;
    if (indices.is_null()) {
      corners.resize(points);
      std::iota(corners.begin(), corners.end(), std::int64_t{0});
      return corners;
    }
    const auto numbers = readAccessor(document_, indices);
    if (!numbers) return numbers.problem();
    corners.assign(numbers->values.begin(), numbers->values.end());
    return corners;
  }

 private:
  sim::Result<DracoMesh> unpack(const std::vector<std::uint32_t>& wanted) {
    const auto bytes = document_.view(member(packed_, "bufferView"));
    if (!bytes) return bytes.problem();
    return unpackDraco(*bytes, wanted);
  }

  GltfDocument& document_;
  const GltfJson& primitive_;
  const GltfJson& packed_;
};

Vec3 pointAt(const GltfNumbers& numbers, std::size_t row) {
  return {numbers.at(row, 0), numbers.at(row, 1), numbers.at(row, 2)};
}

Status addShapeKeys(GltfDocument& document, const GltfJson& primitive, const std::vector<double>& weights,
                    std::vector<Vec3>& points) {
  const GltfJson& targets = member(primitive, "targets");
  for (std::size_t t = 0; t < std::min(weights.size(), targets.size()); ++t) {
    const GltfJson& position = member(targets[t], "POSITION");
    if (weights[t] == 0.0 || position.is_null()) continue;
    const auto moves = readAccessor(document, position);
    if (!moves) return moves.problem();
    if (moves->width != 3 || moves->count() != points.size()) return Problem{"", kDamaged, kAnew};
    for (std::size_t i = 0; i < points.size(); ++i) points[i] += weights[t] * pointAt(*moves, i);
  }
  return sim::Done{};
}

Status addRig(Attributes& attributes, GltfPrimitive& made) {
  for (std::size_t set = 0; attributes.has("JOINTS_" + std::to_string(set)); ++set) {
    auto joints = attributes.read("JOINTS_" + std::to_string(set));
    auto weights = attributes.read("WEIGHTS_" + std::to_string(set));
    if (!joints) return joints.problem();
    if (!weights) return weights.problem();
    if (joints->width != 4 || weights->width != 4 || joints->count() != made.points.size() ||
        weights->count() != made.points.size())
      return Problem{"", kDamaged, kAnew};
    made.joints.push_back(std::move(joints).value());
    made.weights.push_back(std::move(weights).value());
  }
  return sim::Done{};
}

}  // namespace

sim::Result<GltfPrimitive> readPrimitive(GltfDocument& document, const GltfJson& primitive,
                                         const std::vector<double>& weights) {
  GltfPrimitive made;
  made.mode = countOf(member(primitive, "mode"), 4);
  Attributes attributes(document, primitive);
  if (!attributes.has("POSITION")) return made;
  const auto positions = attributes.read("POSITION");
  if (!positions) return positions.problem();
  if (positions->width != 3) return Problem{"", kDamaged, kAnew};
  for (std::size_t i = 0; i < positions->count(); ++i) made.points.push_back(pointAt(*positions, i));
  auto corners = attributes.corners(made.points.size());
  if (!corners) return corners.problem();
  made.corners = std::move(corners).value();
  if (const Status status = addShapeKeys(document, primitive, weights, made.points); !status)
    return status.problem();
  if (const Status status = addRig(attributes, made); !status) return status.problem();
  return made;
}

}  // namespace modeling
