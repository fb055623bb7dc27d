#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/result.h"

namespace modeling {

/// Numbers in the shortest text that reads back to them in single precision, as a list.
nlohmann::ordered_json shortest(std::span<const float> numbers);

/// A glTF 2.0 file in the making, as one binary file (.glb): the JSON that describes it, and the numbers that
/// stand behind it. Numbers of a kind stand together in one view, however many accessors read of it, and
/// equal arrays of times and values are stored once.
class GltfFile {
 public:
  GltfFile();

  nlohmann::ordered_json& json() { return json_; }

  /// Index of the thing appended to a list of the file, such as "nodes".
  std::size_t append(const char* list, nlohmann::ordered_json thing);

  /// Accessors of vertices: `components` (1 to 3) numbers a vertex. Bounds are stated with the first of the
  /// two.
  std::size_t addPositions(std::span<const float> numbers);
  std::size_t addVertices(std::span<const float> numbers, std::size_t components);
  /// In 16 bits where they do.
  std::size_t addTriangles(std::span<const std::uint32_t> corners);
  /// Accessors of animations: times with their bounds, and what is at them.
  std::size_t addTimes(const std::vector<float>& seconds);
  std::size_t addValues(const std::vector<float>& numbers, std::size_t components);
  std::size_t addFlags(const std::vector<bool>& flags);

  /// A Problem where the file cannot be written, or would exceed the format's 4 GB.
  sim::Status write(const std::filesystem::path& path) const;

 private:
  /// What may stand in one view: vertices by their stride, indices by their size.
  enum Kind { vectors, pairs, scalars, indices, shortIndices, values, kKinds };
  struct Accessed {
    Kind kind;
    int componentType;
    std::size_t components;
    std::size_t count;
  };
  std::size_t addAccessor(std::span<const std::byte> bytes, const Accessed& accessed,
                          nlohmann::ordered_json bounds = {});
  std::size_t addFloats(std::span<const float> numbers, std::size_t components, Kind kind, bool bounds);

  nlohmann::ordered_json json_;
  std::array<std::vector<std::byte>, kKinds> views_;
  std::map<std::vector<float>, std::size_t> times_;
  std::map<std::pair<std::size_t, std::vector<float>>, std::size_t> values_;  ///< by components and numbers
  std::map<std::vector<bool>, std::size_t> flags_;
};

}  // namespace modeling
