#include "modeling/exchange/gltf_file.h"

#include <algorithm>
#include <charconv>
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
constexpr int kUnsignedByte = 5121;
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
      return "VEC4";
  }
}

std::size_t padded(std::size_t size) {
  return (size + kAlignment - 1) / kAlignment * kAlignment;
}

std::string_view asText(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

Json shortest(std::span<const float> numbers) {
  Json list = Json::array();
  for (const float number : numbers) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    double read = 0.0;
    std::from_chars(text.data(), end, read);
    list.push_back(read);
  }
  return list;
}

GltfFile::GltfFile() {
  json_["asset"] = {{"version", "2.0"}, {"generator", "Smithereens"}};
}

std::size_t GltfFile::append(const char* list, Json thing) {
  Json& things = json_[list];
  things.push_back(std::move(thing));
  return things.size() - 1;
}

std::size_t GltfFile::addAccessor(std::span<const std::byte> bytes, const Accessed& accessed, Json bounds) {
  std::vector<std::byte>& view = views_[accessed.kind];
  Json accessor = {{"bufferView", accessed.kind},
                   {"byteOffset", view.size()},
                   {"componentType", accessed.componentType},
                   {"count", accessed.count},
                   {"type", typeName(accessed.components)}};
  accessor.update(bounds);
  view.insert(view.end(), bytes.begin(), bytes.end());
  view.resize(padded(view.size()));
  return append("accessors", std::move(accessor));
}

std::size_t GltfFile::addFloats(std::span<const float> numbers, std::size_t components, Kind kind,
                                bool bounds) {
  Json stated = Json::object();
  if (bounds) {
    std::vector<float> lowest(components, std::numeric_limits<float>::max());
    std::vector<float> highest(components, std::numeric_limits<float>::lowest());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      lowest[i % components] = std::min(lowest[i % components], numbers[i]);
      highest[i % components] = std::max(highest[i % components], numbers[i]);
    }
    stated = {{"min", shortest(lowest)}, {"max", shortest(highest)}};
  }
  return addAccessor(std::as_bytes(numbers), {kind, kFloat, components, numbers.size() / components},
                     std::move(stated));
}

std::size_t GltfFile::addPositions(std::span<const float> numbers) {
  return addFloats(numbers, 3, vectors, true);
}

std::size_t GltfFile::addVertices(std::span<const float> numbers, std::size_t components) {
  return addFloats(numbers, components, components == 3 ? vectors : components == 2 ? pairs : scalars, false);
}

std::size_t GltfFile::addTriangles(std::span<const std::uint32_t> corners) {
  // The highest number that 16 bits have restarts a primitive.
  constexpr std::uint32_t kMostShort = std::numeric_limits<std::uint16_t>::max() - 1;
  if (std::any_of(corners.begin(), corners.end(), [](std::uint32_t corner) { return corner > kMostShort; }))
    return addAccessor(std::as_bytes(corners), {indices, kUnsignedInt, 1, corners.size()}, Json::object());
  std::vector<std::uint16_t> numbers;
  numbers.reserve(corners.size());
  for (const std::uint32_t corner : corners) numbers.push_back(static_cast<std::uint16_t>(corner));
  return addAccessor(std::as_bytes(std::span(numbers)), {shortIndices, kUnsignedShort, 1, corners.size()},
                     Json::object());
}

std::size_t GltfFile::addTimes(const std::vector<float>& seconds) {
  const auto found = times_.find(seconds);
  if (found != times_.end()) return found->second;
  return times_[seconds] = addFloats(seconds, 1, values, true);
}

std::size_t GltfFile::addValues(const std::vector<float>& numbers, std::size_t components) {
  const auto [found, isNew] = values_.try_emplace({components, numbers}, 0);
  if (isNew) found->second = addFloats(numbers, components, values, false);
  return found->second;
}

std::size_t GltfFile::addFlags(const std::vector<bool>& flags) {
  const auto [found, isNew] = flags_.try_emplace(flags, 0);
  if (isNew) {
    const std::vector<std::uint8_t> bytes(flags.begin(), flags.end());
    found->second = addAccessor(std::as_bytes(std::span(bytes)), {values, kUnsignedByte, 1, flags.size()},
                                Json::object());
  }
  return found->second;
}

sim::Status GltfFile::write(const std::filesystem::path& path) const {
  // Numbers of the views in the order of Kind; those that are empty are left out.
  Json json = json_;
  std::array<std::size_t, kKinds> numbers{};
  std::size_t binarySize = 0;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    if (views_[kind].empty()) continue;
    Json view = {{"buffer", 0}, {"byteOffset", binarySize}, {"byteLength", views_[kind].size()}};
    if (kind <= scalars) view["byteStride"] = sizeof(float) * (scalars + 1 - kind);
    if (kind <= shortIndices) view["target"] = kind <= scalars ? kArrayBuffer : kElementArrayBuffer;
    numbers[kind] = json["bufferViews"].size();
    json["bufferViews"].push_back(std::move(view));
    binarySize += views_[kind].size();
  }
  for (Json& accessor : json["accessors"])
    accessor["bufferView"] = numbers[accessor["bufferView"].get<std::size_t>()];
  if (json["accessors"].empty()) json.erase("accessors");
  if (binarySize > 0) json["buffers"] = Json::array({{{"byteLength", binarySize}}});
  // Names from a scene may be anything; what is no UTF-8 is replaced rather than refused.
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize(padded(text.size()), ' ');
  const std::size_t size = 12 + 8 + text.size() + (binarySize == 0 ? 0 : 8 + binarySize);
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
  if (binarySize > 0) {
    sim::ByteWriter chunk;
    chunk.put(static_cast<std::uint32_t>(binarySize));
    chunk.put(kBinaryChunk);
    out << asText(chunk.bytes());
    for (const std::vector<std::byte>& view : views_) out << asText(view);
  }
  return out.finish();
}

}  // namespace modeling
