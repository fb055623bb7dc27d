#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/result.h"

namespace modeling {

using GltfJson = nlohmann::json;

/// A glTF 2.0 file, text or binary (.glb), with its buffers. What is not there, or of another type than it
/// should be, reads as empty or zero.
class GltfDocument {
 public:
  /// A Problem where it is none, needs an extension that changes shapes and is not known here (by its name),
  /// or lacks a buffer.
  static sim::Result<GltfDocument> read(std::string_view bytes, const std::filesystem::path& folder);

  const GltfJson& root() const { return root_; }
  /// Entry `index` of a list of the root: "nodes". Null where there is none.
  const GltfJson& entry(const char* list, const GltfJson& index) const;
  /// The bytes of a buffer view, decompressed. They are kept, so that the next call finds them.
  sim::Result<std::string_view> view(const GltfJson& index);

 private:
  sim::Status checkExtensions() const;
  sim::Status readBuffers(std::string_view binary, const std::filesystem::path& folder);
  sim::Result<std::string_view> slice(const GltfJson& view) const;

  GltfJson root_;
  std::vector<std::string> buffers_;
  std::vector<std::optional<std::string>> unpacked_;  ///< one a buffer view
};

/// A member of an object, or null.
const GltfJson& member(const GltfJson& object, const char* key);
/// A whole number of at least 0 and below 2^53, or `otherwise`.
std::uint64_t countOf(const GltfJson& value, std::uint64_t otherwise = 0);
/// Null where there is none.
const GltfJson& extensionOf(const GltfJson& object, const char* name);
/// The key under which an object may be compressed by meshoptimizer, or null.
const GltfJson& meshoptOf(const GltfJson& object);

}  // namespace modeling
