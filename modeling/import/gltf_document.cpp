#include "modeling/import/gltf_document.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "modeling/import/file_bytes.h"
#include "modeling/import/gltf_compression.h"

namespace modeling {
namespace {

using sim::Problem;
using sim::Status;

const GltfJson kNull;
const char* const kWithout = "export it without it";

/// Extensions that a file may need and that are read here.
constexpr std::array<std::string_view, 6> kKnown{"KHR_mesh_quantization",      "EXT_mesh_gpu_instancing",
                                                 "EXT_meshopt_compression",    "KHR_meshopt_compression",
                                                 "KHR_draco_mesh_compression", "KHR_node_visibility"};
/// Of what begins so, no shape depends.
constexpr std::array<std::string_view, 12> kOfLooks{
    "KHR_materials", "KHR_texture", "KHR_lights",    "KHR_xmp",      "KHR_animation", "KHR_audio",
    "EXT_texture",   "EXT_lights",  "EXT_materials", "MSFT_texture", "MSFT_packing",  "ADOBE_materials"};

/// The chunks of a binary file.
constexpr std::size_t kGlbHead = 12;
constexpr std::size_t kChunkHead = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

struct Chunks {
  std::string_view json, binary;
};

sim::Result<Chunks> chunksOf(std::string_view bytes) {
  if (!bytes.starts_with("glTF")) return Chunks{bytes, {}};
  if (bytes.size() < kGlbHead + kChunkHead)
    return Problem{"", "this file is cut short", "copy or export it anew"};
  if (const std::uint32_t version = wordAt(bytes, 4); version != 2)
    return Problem{"", "this is glTF of version " + std::to_string(version), "export it as glTF 2.0"};
  Chunks chunks;
  for (std::size_t at = kGlbHead; bytes.size() - at >= kChunkHead;) {
    const std::uint32_t length = wordAt(bytes, at);
    const std::uint32_t type = wordAt(bytes, at + 4);
    at += kChunkHead;
    if (length > bytes.size() - at) return Problem{"", "this file is cut short", "copy or export it anew"};
    if (type == kJsonChunk && chunks.json.empty()) chunks.json = bytes.substr(at, length);
    if (type == kBinaryChunk && chunks.binary.empty()) chunks.binary = bytes.substr(at, length);
    at += std::min<std::size_t>((length + 3U) & ~3U, bytes.size() - at);
  }
  return chunks;
}

/// Base 64; nothing where a letter is none of it.
std::optional<std::string> decoded64(std::string_view text) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    if (letter == '=' || letter == '\n' || letter == '\r' || letter == ' ') continue;
    const std::size_t digit = kDigits.find(letter);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = (bits << 6U) | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>((bits >> static_cast<unsigned>(count)) & 0xffU);
  }
  return bytes;
}

/// Letters of an address that stand as %20.
std::string unescaped(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isEscape = text[i] == '%' && i + 2 < text.size() &&
                          std::isxdigit(static_cast<unsigned char>(text[i + 1])) &&
                          std::isxdigit(static_cast<unsigned char>(text[i + 2]));
    plain +=
        isEscape ? static_cast<char>(std::stoi(std::string(text.substr(i + 1, 2)), nullptr, 16)) : text[i];
    i += isEscape ? 2 : 0;
  }
  return plain;
}

sim::Result<std::string> bufferAt(const std::string& uri, const std::filesystem::path& folder) {
  if (!uri.starts_with("data:")) {
    const std::string name = unescaped(uri);
    auto bytes = fileBytes(folder / std::filesystem::path(name));
    if (bytes) return bytes;
    return Problem{"", "its numbers are in the file " + name + ", which cannot be read",
                   "keep it beside this one, or export it as .glb, in which all is one file"};
  }
  const std::size_t comma = uri.find(";base64,");
  const auto bytes =
      comma == std::string::npos ? std::nullopt : decoded64(std::string_view(uri).substr(comma + 8));
  if (!bytes) return Problem{"", "the numbers in this file are no base 64", "export it as .glb"};
  return *bytes;
}

}  // namespace

const GltfJson& member(const GltfJson& object, const char* key) {
  if (!object.is_object()) return kNull;
  const auto found = object.find(key);
  return found == object.end() ? kNull : *found;
}

std::uint64_t countOf(const GltfJson& value, std::uint64_t otherwise) {
  static constexpr double kMost = 9007199254740992.0;
  if (!value.is_number()) return otherwise;
  const auto number = value.get<double>();
  return number >= 0.0 && number < kMost ? static_cast<std::uint64_t>(number) : otherwise;
}

const GltfJson& extensionOf(const GltfJson& object, const char* name) {
  return member(member(object, "extensions"), name);
}

const GltfJson& meshoptOf(const GltfJson& object) {
  const GltfJson& first = extensionOf(object, "EXT_meshopt_compression");
  return first.is_null() ? extensionOf(object, "KHR_meshopt_compression") : first;
}

sim::Result<GltfDocument> GltfDocument::read(std::string_view bytes, const std::filesystem::path& folder) {
  const auto chunks = chunksOf(bytes);
  if (!chunks) return chunks.problem();
  GltfDocument document;
  document.root_ = GltfJson::parse(chunks->json.begin(), chunks->json.end(), nullptr, false);
  if (!document.root_.is_object())
    return Problem{"", "this is no glTF: its text is damaged or cut short", "copy or export it anew"};
  const GltfJson& version = member(member(document.root_, "asset"), "version");
  if (!version.is_string() || version.get<std::string>().rfind("2.", 0) != 0)
    return Problem{"", "this is glTF of another version than 2", "export it as glTF 2.0"};
  if (const Status status = document.checkExtensions(); !status) return status.problem();
  if (const Status status = document.readBuffers(chunks->binary, folder); !status) return status.problem();
  document.unpacked_.resize(member(document.root_, "bufferViews").size());
  return document;
}

Status GltfDocument::checkExtensions() const {
  for (const GltfJson& required : member(root_, "extensionsRequired")) {
    if (!required.is_string()) continue;
    const auto name = required.get<std::string>();
    const bool isKnown = std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end();
    const bool isOfLooks = std::any_of(kOfLooks.begin(), kOfLooks.end(),
                                       [&](std::string_view start) { return name.rfind(start, 0) == 0; });
    if (!isKnown && !isOfLooks)
      return Problem{"", "this file needs " + name.substr(0, 80) + ", which is not supported", kWithout};
  }
  return sim::Done{};
}

Status GltfDocument::readBuffers(std::string_view binary, const std::filesystem::path& folder) {
  std::size_t sum = 0;
  bool isFirst = true;
  for (const GltfJson& buffer : member(root_, "buffers")) {
    const GltfJson& uri = member(buffer, "uri");
    std::string& bytes = buffers_.emplace_back();
    if (uri.is_string()) {
      auto found = bufferAt(uri.get<std::string>(), folder);
      if (!found) return found.problem();
      bytes = std::move(found).value();
    } else if (isFirst) {
      bytes = std::string(binary);
    }
    // A buffer that is only what others are decompressed to has no bytes.
    isFirst = false;
    sum += bytes.size();
    if (sum > kLargestMeshFile)
      return Problem{"", "its buffers are too large together", "use a mesh of fewer faces"};
  }
  return sim::Done{};
}

const GltfJson& GltfDocument::entry(const char* list, const GltfJson& index) const {
  const GltfJson& entries = member(root_, list);
  const std::uint64_t at = countOf(index, entries.size());
  return entries.is_array() && at < entries.size() ? entries[at] : kNull;
}

sim::Result<std::string_view> GltfDocument::slice(const GltfJson& view) const {
  const std::uint64_t buffer = countOf(member(view, "buffer"), buffers_.size());
  const std::uint64_t offset = countOf(member(view, "byteOffset"));
  const std::uint64_t length = countOf(member(view, "byteLength"));
  if (buffer >= buffers_.size() || offset > buffers_[buffer].size() ||
      length > buffers_[buffer].size() - offset)
    return Problem{"", "this file is damaged: it has fewer bytes than it says", "copy or export it anew"};
  return std::string_view(buffers_[buffer]).substr(offset, length);
}

sim::Result<std::string_view> GltfDocument::view(const GltfJson& index) {
  const GltfJson& view = entry("bufferViews", index);
  const GltfJson& packed = meshoptOf(view);
  if (packed.is_null()) return slice(view);
  std::optional<std::string>& kept = unpacked_[countOf(index)];
  if (!kept) {
    const auto bytes = slice(packed);
    if (!bytes) return bytes.problem();
    auto unpacked = unpackMeshopt(packed, *bytes);
    if (!unpacked) return unpacked.problem();
    kept = std::move(unpacked).value();
  }
  return std::string_view(*kept);
}

}  // namespace modeling
