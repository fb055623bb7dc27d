#include "modeling/import/gltf_accessor.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "modeling/import/raw_mesh.h"

namespace modeling {
namespace {

using sim::Problem;
using sim::Status;

const Problem& damaged() {
  static const Problem kDamaged{"", "this file is damaged: it names numbers that are not there",
                                "copy or export it anew"};
  return kDamaged;
}

enum Component : std::uint64_t { kInt8 = 5120, kUint8, kInt16, kUint16, kUint32 = 5125, kFloat = 5126 };

std::size_t sizeOf(std::uint64_t component) {
  if (component == kInt8 || component == kUint8) return 1;
  if (component == kInt16 || component == kUint16) return 2;
  return component == kUint32 || component == kFloat ? 4 : 0;
}

template <class Number>
double as(const char* bytes, bool isShare) {
  Number number{};
  std::memcpy(&number, bytes, sizeof number);
  const auto value = static_cast<double>(number);
  if constexpr (std::numeric_limits<Number>::is_integer)
    return isShare ? std::max(value / static_cast<double>(std::numeric_limits<Number>::max()), -1.0) : value;
  return value;
}

double numberAt(const char* bytes, std::uint64_t component, bool isShare) {
  switch (component) {
    case kInt8:
      return as<std::int8_t>(bytes, isShare);
    case kUint8:
      return as<std::uint8_t>(bytes, isShare);
    case kInt16:
      return as<std::int16_t>(bytes, isShare);
    case kUint16:
      return as<std::uint16_t>(bytes, isShare);
    case kUint32:
      return as<std::uint32_t>(bytes, isShare);
    default:
      return as<float>(bytes, false);
  }
}

struct Width {
  std::string_view type;
  std::size_t numbers, columns;
};
constexpr std::array<Width, 7> kWidths{{{"SCALAR", 1, 1},
                                        {"VEC2", 2, 1},
                                        {"VEC3", 3, 1},
                                        {"VEC4", 4, 1},
                                        {"MAT2", 4, 2},
                                        {"MAT3", 9, 3},
                                        {"MAT4", 16, 4}}};

/// Where rows stand in a buffer view.
struct Rows {
  std::uint64_t component = kFloat;
  bool isShare = false;
  std::size_t width = 1, columns = 1;
  std::uint64_t count = 0, offset = 0;
};

/// Each column of a matrix begins at a multiple of four bytes.
std::size_t bytesOfColumn(const Rows& rows) {
  const std::size_t bytes = rows.width / rows.columns * sizeOf(rows.component);
  return rows.columns > 1 ? (bytes + 3) / 4 * 4 : bytes;
}

sim::Result<std::vector<double>> rowsOf(GltfDocument& document, const GltfJson& viewIndex, const Rows& rows) {
  const auto bytes = document.view(viewIndex);
  if (!bytes) return bytes.problem();
  const std::size_t column = bytesOfColumn(rows);
  const std::size_t row = column * rows.columns;
  const std::uint64_t stride = countOf(member(document.entry("bufferViews", viewIndex), "byteStride"), row);
  if (rows.count == 0) return std::vector<double>();
  if (rows.offset > bytes->size() || bytes->size() - rows.offset < row || stride < row ||
      (bytes->size() - rows.offset - row) / stride < rows.count - 1)
    return damaged();
  std::vector<double> values;
  values.reserve(rows.count * rows.width);
  for (std::uint64_t i = 0; i < rows.count; ++i) {
    const char* at = bytes->data() + rows.offset + i * stride;
    for (std::size_t n = 0; n < rows.width; ++n) {
      const std::size_t perColumn = rows.width / rows.columns;
      const char* number = at + n / perColumn * column + n % perColumn * sizeOf(rows.component);
      values.push_back(numberAt(number, rows.component, rows.isShare));
    }
  }
  return values;
}

Status layOver(GltfDocument& document, const GltfJson& sparse, const Rows& rows,
               std::vector<double>& values) {
  const GltfJson& where = member(sparse, "indices");
  Rows places{countOf(member(where, "componentType")), false, 1, 1, countOf(member(sparse, "count")),
              countOf(member(where, "byteOffset"))};
  if (sizeOf(places.component) == 0) return damaged();
  const auto indices = rowsOf(document, member(where, "bufferView"), places);
  if (!indices) return indices.problem();
  Rows others = rows;
  others.count = places.count;
  others.offset = countOf(member(member(sparse, "values"), "byteOffset"));
  const auto numbers = rowsOf(document, member(member(sparse, "values"), "bufferView"), others);
  if (!numbers) return numbers.problem();
  for (std::size_t i = 0; i < indices->size(); ++i) {
    const auto row = static_cast<std::uint64_t>((*indices)[i]);
    if (row >= rows.count) return damaged();
    std::copy_n(numbers->begin() + static_cast<std::ptrdiff_t>(i * rows.width), rows.width,
                values.begin() + static_cast<std::ptrdiff_t>(row * rows.width));
  }
  return sim::Done{};
}

}  // namespace

sim::Result<GltfNumbers> readAccessor(GltfDocument& document, const GltfJson& index) {
  const GltfJson& accessor = document.entry("accessors", index);
  const GltfJson& type = member(accessor, "type");
  const auto* width = std::find_if(kWidths.begin(), kWidths.end(), [&](const Width& one) {
    return type.is_string() && type.get_ref<const std::string&>() == one.type;
  });
  const GltfJson& isShare = member(accessor, "normalized");
  Rows rows{countOf(member(accessor, "componentType")), isShare.is_boolean() && isShare.get<bool>(), 1, 1,
            countOf(member(accessor, "count")),         countOf(member(accessor, "byteOffset"))};
  if (width == kWidths.end() || sizeOf(rows.component) == 0 || rows.count > 3 * kMostTriangles)
    return damaged();
  rows.width = width->numbers;
  rows.columns = width->columns;
  GltfNumbers numbers{rows.width, {}};
  const GltfJson& view = member(accessor, "bufferView");
  if (view.is_null()) {
    numbers.values.assign(rows.count * rows.width, 0.0);
  } else {
    auto values = rowsOf(document, view, rows);
    if (!values) return values.problem();
    numbers.values = std::move(values).value();
  }
  const GltfJson& sparse = member(accessor, "sparse");
  if (sparse.is_null()) return numbers;
  if (const Status status = layOver(document, sparse, rows, numbers.values); !status) return status.problem();
  return numbers;
}

}  // namespace modeling
