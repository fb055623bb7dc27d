#include "modeling/exchange/gltf_file.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include "modeling/text/text_output.h"
#include "sim/base/bytes.h"

namespace modeling {

namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kUnsignedShort = 5123;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr std::uint32_t kMagic = 0x46546c67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;  // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004e4942;
constexpr std::size_t kAlignment = 4;

const char* typeName(std::size_t components) {
  switch (components) {
    case 1:
      return "SCALAR";
    case 2:
      return "VEC2";
    case 3:
      return "VEC3";
    default:
      return components == 4 ? "VEC4" : "MAT4";
  }
}

std::size_t padded(std::size_t size) {
  return (size + kAlignment - 1) / kAlignment * kAlignment;
}

std::string_view asText(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

GltfFile::GltfFile() {
  json_["asset"] = {{"version", "2.0"}, {"generator", "Smithereens"}};
}

std::size_t GltfFile::append(const char* list, Json thing) {
  Json& things = json_[list];
  things.push_back(std::move(thing));
  return things.size() - 1;
}

std::size_t GltfFile::addView(std::span<const std::byte> bytes, Use use) {
  Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
  if (use != Use::other) view["target"] = use == Use::indices ? kElementArrayBuffer : kArrayBuffer;
  binary_.insert(binary_.end(), bytes.begin(), bytes.end());
  binary_.resize(padded(binary_.size()));
  return append("bufferViews", std::move(view));
}

std::size_t GltfFile::addFloats(std::span<const float> numbers, std::size_t components, Use use,
                                bool bounds) {
  Json accessor = {{"bufferView", addView(std::as_bytes(numbers), use)},
                   {"componentType", kFloat},
                   {"count", numbers.size() / components},
                   {"type", typeName(components)}};
  if (bounds) {
    std::vector<float> lowest(components, std::numeric_limits<float>::max());
    std::vector<float> highest(components, std::numeric_limits<float>::lowest());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      lowest[i % components] = std::min(lowest[i % components], numbers[i]);
      highest[i % components] = std::max(highest[i % components], numbers[i]);
    }
    accessor["min"] = lowest;
    accessor["max"] = highest;
  }
  return append("accessors", std::move(accessor));
}

std::size_t GltfFile::addPositions(std::span<const float> numbers) {
  return addFloats(numbers, 3, Use::vertices, true);
}

std::size_t GltfFile::addVertices(std::span<const float> numbers, std::size_t components) {
  return addFloats(numbers, components, Use::vertices, false);
}

std::size_t GltfFile::addJoints(std::span<const std::uint16_t> fourEach) {
  return append("accessors", {{"bufferView", addView(std::as_bytes(fourEach), Use::vertices)},
                              {"componentType", kUnsignedShort},
                              {"count", fourEach.size() / 4},
                              {"type", "VEC4"}});
}

std::size_t GltfFile::addTriangles(std::span<const std::uint32_t> corners) {
  return append("accessors", {{"bufferView", addView(std::as_bytes(corners), Use::indices)},
                              {"componentType", kUnsignedInt},
                              {"count", corners.size()},
                              {"type", "SCALAR"}});
}

std::size_t GltfFile::addTimes(const std::vector<float>& seconds) {
  const auto found = times_.find(seconds);
  if (found != times_.end()) return found->second;
  return times_[seconds] = addFloats(seconds, 1, Use::other, true);
}

std::size_t GltfFile::addValues(std::span<const float> numbers, std::size_t components) {
  return addFloats(numbers, components, Use::other, false);
}

sim::Status GltfFile::write(const std::filesystem::path& path) const {
  Json json = json_;
  if (!binary_.empty()) json["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
  // Names from a scene may be anything; what is no UTF-8 is replaced rather than refused.
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize(padded(text.size()), ' ');
  const std::size_t size = 12 + 8 + text.size() + (binary_.empty() ? 0 : 8 + binary_.size());
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    return sim::Problem{path.string(), "this would take more than the 4 GB that a glb file can have",
                        "export fewer frames"};
  }
  sim::ByteWriter head;
  for (const std::size_t number :
       {std::size_t{kMagic}, std::size_t{2}, size, text.size(), std::size_t{kJsonChunk}}) {
    head.put(static_cast<std::uint32_t>(number));
  }
  TextOutput out(path);
  if (!out.good()) return out.finish();
  out << asText(head.bytes()) << text;
  if (!binary_.empty()) {
    sim::ByteWriter chunk;
    chunk.put(static_cast<std::uint32_t>(binary_.size()));
    chunk.put(kBinaryChunk);
    out << asText(chunk.bytes()) << asText(binary_);
  }
  return out.finish();
}

}  // namespace modeling
