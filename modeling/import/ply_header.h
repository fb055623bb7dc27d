#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "modeling/import/raw_mesh.h"

namespace modeling {

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyFormat : std::uint8_t { text, littleEndian, bigEndian };

std::size_t sizeOf(PlyType type);

/// One number, or a list with its length before it.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> listOf;  ///< the type of the length; nothing: it is one number
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Where the property is among them; nothing: there is none.
  std::optional<std::size_t> find(std::string_view property) const;
};

/// What stands before the numbers of a PLY file.
struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;
  std::string_view numbers;  ///< all that comes behind
};

/// Reads the head. What comments state goes into the mesh. A Problem names the line.
sim::Result<PlyHeader> readPlyHeader(std::string_view bytes, RawMesh& raw);

}  // namespace modeling
