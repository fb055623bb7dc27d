#include "modeling/import/ply_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "modeling/import/mesh_text.h"
#include "modeling/import/ply_header.h"

namespace modeling {
namespace {

using sim::Problem;
using sim::Status;

/// Numbers one after the other, as the format has them.
class PlyNumbers {
 public:
  PlyNumbers(std::string_view bytes, PlyFormat format) : rest_(bytes), format_(format) {}

  /// Nothing at the end of the file, or where there is no number.
  std::optional<double> next(PlyType type) {
    if (format_ == PlyFormat::text) return numberOf(nextWord(rest_));
    const std::size_t size = sizeOf(type);
    if (rest_.size() < size) return std::nullopt;
    std::array<char, 8> bytes{};
    std::copy_n(rest_.begin(), size, bytes.begin());
    if (format_ == PlyFormat::bigEndian)
      std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    rest_.remove_prefix(size);
    return valueOf(bytes, type);
  }

  /// As many values as there may still be.
  std::uint64_t room() const { return rest_.size(); }

 private:
  template <class Number>
  static double as(const std::array<char, 8>& bytes) {
    Number number{};
    std::memcpy(&number, bytes.data(), sizeof number);
    return static_cast<double>(number);
  }

  static double valueOf(const std::array<char, 8>& bytes, PlyType type) {
    switch (type) {
      case PlyType::int8:
        return as<std::int8_t>(bytes);
      case PlyType::uint8:
        return as<std::uint8_t>(bytes);
      case PlyType::int16:
        return as<std::int16_t>(bytes);
      case PlyType::uint16:
        return as<std::uint16_t>(bytes);
      case PlyType::int32:
        return as<std::int32_t>(bytes);
      case PlyType::uint32:
        return as<std::uint32_t>(bytes);
      case PlyType::float32:
        return as<float>(bytes);
      case PlyType::float64:
        return as<double>(bytes);
    }
    return 0.0;
  }

  std::string_view rest_;
  PlyFormat format_;
};

/// The lists of an element that name corners.
std::optional<std::size_t> cornersIn(const PlyElement& element) {
  for (const char* name : {"vertex_indices", "vertex_index", "vertices", "indices"}) {
    const auto found = element.find(name);
    if (found && element.properties[*found].listOf) return found;
  }
  return std::nullopt;
}

class PlyBody {
 public:
  PlyBody(const PlyHeader& header, RawMesh& raw) : numbers_(header.numbers, header.format), raw_(raw) {}

  Status take(const PlyElement& element) {
    // An element that has no properties takes no room, however many of it there are said to be.
    if (element.properties.empty()) return sim::Done{};
    if (element.count > numbers_.room()) return cut(element, 0);
    const bool isVertex = element.name == "vertex";
    if (isVertex) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        axes_[axis] = element.find(std::array{"x", "y", "z"}[axis]).value_or(element.properties.size());
        if (axes_[axis] == element.properties.size() || element.properties[axes_[axis]].listOf)
          return Problem{"", "its corners have no x, y and z", "export it anew"};
      }
    }
    corners_ = cornersIn(element);
    if (element.name == "edge") raw_.wires += element.count;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (const Status status = takeOne(element, i); !status) return status;
      if (isVertex) raw_.points.emplace_back(values_[axes_[0]], values_[axes_[1]], values_[axes_[2]]);
    }
    return sim::Done{};
  }

  /// Faces may stand before the corners they name.
  Status finish() {
    for (const auto& [strip, which, ring] : rings_) {
      const Status status = strip ? addStrips(ring, which) : addPolygon(ring, which, raw_);
      if (!status) return status;
    }
    return sim::Done{};
  }

 private:
  struct Ring {
    bool isStrip = false;
    std::string which;
    std::vector<std::int64_t> corners;
  };

  static Problem cut(const PlyElement& element, std::uint64_t found) {
    return {"",
            "this file is cut short or damaged: it says that it has " + std::to_string(element.count) +
                " of \"" + element.name + "\", and no more than " + std::to_string(found) + " can be read",
            "copy or export it anew"};
  }

  Status takeOne(const PlyElement& element, std::uint64_t index) {
    values_.assign(element.properties.size(), 0.0);
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const auto first = numbers_.next(property.listOf.value_or(property.type));
      if (!first) return cut(element, index);
      values_[p] = *first;
      if (!property.listOf) continue;
      std::vector<std::int64_t> items;
      if (!takeList(property, *first, items)) return cut(element, index);
      if (corners_ == p) keep(element, index, std::move(items));
    }
    return sim::Done{};
  }

  bool takeList(const PlyProperty& property, double length, std::vector<std::int64_t>& items) {
    if (!(length >= 0.0) || length > static_cast<double>(numbers_.room())) return false;
    for (double i = 0.0; i < length; i += 1.0) {
      const auto item = numbers_.next(property.type);
      if (!item) return false;
      // What is no whole number names no corner, and is told when its face is made.
      const bool isWhole = *item == std::floor(*item) && std::abs(*item) < 1e15;
      items.push_back(isWhole ? static_cast<std::int64_t>(*item)
                              : std::numeric_limits<std::int64_t>::max() - 1);
    }
    return true;
  }

  void keep(const PlyElement& element, std::uint64_t index, std::vector<std::int64_t> items) {
    const bool isStrip = element.name == "tristrips";
    const std::string which = element.name + " " + std::to_string(index + 1);
    if (element.name == "face" || isStrip) rings_.push_back({isStrip, which, std::move(items)});
  }

  /// Strips one after the other, each ended by a number below zero.
  Status addStrips(const std::vector<std::int64_t>& corners, const std::string& which) {
    for (auto first = corners.begin(); first != corners.end();) {
      const auto last = std::find_if(first, corners.end(), [](std::int64_t corner) { return corner < 0; });
      if (const Status status = addStrip({first, last}, which, raw_); !status) return status;
      first = last == corners.end() ? last : last + 1;
    }
    return sim::Done{};
  }

  PlyNumbers numbers_;
  RawMesh& raw_;
  std::array<std::size_t, 3> axes_{};
  std::optional<std::size_t> corners_;
  std::vector<double> values_;
  std::vector<Ring> rings_;
};

}  // namespace

Reading readPly(std::string_view bytes) {
  RawMesh raw;
  const auto header = readPlyHeader(bytes, raw);
  if (!header) return header.problem();
  PlyBody body(*header, raw);
  for (const PlyElement& element : header->elements)
    if (const Status status = body.take(element); !status) return status.problem();
  if (const Status status = body.finish(); !status) return status.problem();
  return raw;
}

}  // namespace modeling
