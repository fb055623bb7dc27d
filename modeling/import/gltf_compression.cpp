#include "modeling/import/gltf_compression.h"

#include <draco/compression/decode.h>
#include <meshoptimizer.h>

#include "modeling/import/file_bytes.h"
#include "modeling/import/gltf_document.h"

namespace modeling {
namespace {

using sim::Problem;

const char* const kWithout = "export it without compression";
/// Compressed views may become so large, bytes.
constexpr std::uint64_t kLargestView = 4 * kLargestMeshFile;

void undoFilter(const std::string& filter, void* bytes, std::size_t count, std::size_t stride) {
  if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) meshopt_decodeFilterOct(bytes, count, stride);
  if (filter == "QUATERNION" && stride == 8) meshopt_decodeFilterQuat(bytes, count, stride);
  if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes, count, stride);
}

std::string textOf(const GltfJson& value) {
  return value.is_string() ? value.get<std::string>() : std::string();
}

}  // namespace

sim::Result<std::string> unpackMeshopt(const GltfJson& extension, std::string_view bytes) {
  const std::uint64_t count = countOf(member(extension, "count"));
  const std::uint64_t stride = countOf(member(extension, "byteStride"));
  const std::string mode = textOf(member(extension, "mode"));
  const bool ofCorners = mode == "ATTRIBUTES";
  const bool fits = ofCorners ? stride > 0 && stride <= 256 && stride % 4 == 0
                              : (stride == 2 || stride == 4) && (mode == "INDICES" || count % 3 == 0);
  if (!fits || count > kLargestView / std::max<std::uint64_t>(stride, 1))
    return Problem{"", "its compressed numbers (EXT_meshopt_compression) are damaged", kWithout};
  std::string unpacked(count * stride, '\0');
  const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
  int failed = 0;
  if (ofCorners) {
    failed = meshopt_decodeVertexBuffer(unpacked.data(), count, stride, from, bytes.size());
  } else if (mode == "TRIANGLES") {
    failed = meshopt_decodeIndexBuffer(unpacked.data(), count, stride, from, bytes.size());
  } else {
    failed = meshopt_decodeIndexSequence(unpacked.data(), count, stride, from, bytes.size());
  }
  if (failed != 0)
    return Problem{
        "", "its compressed numbers (EXT_meshopt_compression) are damaged, or newer than is known here",
        kWithout};
  if (ofCorners) undoFilter(textOf(member(extension, "filter")), unpacked.data(), count, stride);
  return unpacked;
}

sim::Result<DracoMesh> unpackDraco(std::string_view bytes, const std::vector<std::uint32_t>& wanted) {
  const Problem damaged{"", "its compressed numbers (KHR_draco_mesh_compression) are damaged", kWithout};
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) return damaged;
  const draco::Mesh& mesh = *decoded.value();
  DracoMesh made;
  for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
    for (const draco::PointIndex& corner : mesh.face(face)) made.corners.push_back(corner.value());
  for (const std::uint32_t id : wanted) {
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(id);
    if (attribute == nullptr || attribute->num_components() == 0) return damaged;
    GltfNumbers& numbers = made.attributes.emplace_back();
    numbers.width = static_cast<std::size_t>(attribute->num_components());
    std::vector<float> row(numbers.width);
    for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
      if (!attribute->ConvertValue<float>(attribute->mapped_index(point), attribute->num_components(),
                                          row.data()))
        return damaged;
      numbers.values.insert(numbers.values.end(), row.begin(), row.end());
    }
  }
  return made;
}

}  // namespace modeling
