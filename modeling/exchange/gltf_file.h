#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/result.h"

namespace modeling {

/// A glTF 2.0 file in the making, as one binary file (.glb): the JSON that describes it, and the numbers that
/// stand behind it. Equal arrays of times are stored once.
class GltfFile {
 public:
  GltfFile();

  nlohmann::ordered_json& json() { return json_; }

  /// Index of the thing appended to a list of the file, such as "nodes".
  std::size_t append(const char* list, nlohmann::ordered_json thing);

  /// Accessors of vertices: `components` numbers a vertex. Bounds are stated with the first of the two.
  std::size_t addPositions(std::span<const float> numbers);
  std::size_t addVertices(std::span<const float> numbers, std::size_t components);
  std::size_t addJoints(std::span<const std::uint16_t> fourEach);
  std::size_t addTriangles(std::span<const std::uint32_t> corners);
  /// Accessors of animations: times with their bounds, and what is at them.
  std::size_t addTimes(const std::vector<float>& seconds);
  std::size_t addValues(std::span<const float> numbers, std::size_t components);

  /// A Problem where the file cannot be written, or would exceed the format's 4 GB.
  sim::Status write(const std::filesystem::path& path) const;

 private:
  enum class Use { vertices, indices, other };
  std::size_t addView(std::span<const std::byte> bytes, Use use);
  std::size_t addFloats(std::span<const float> numbers, std::size_t components, Use use, bool bounds);

  nlohmann::ordered_json json_;
  std::vector<std::byte> binary_;
  std::map<std::vector<float>, std::size_t> times_;
};

}  // namespace modeling
