#include "modeling/scene/scene_codec.h"

namespace modeling {

bool Codec<ValueChain>::read(JsonReader& reader, const JsonValue& value, ValueChain& out, const Rule& rule) {
  if (value.array() == nullptr) {
    double number = 0.0;
    if (!reader.readNumber(value, number, rule)) return false;
    out = constantValue(number);
    return true;
  }
  out.clear();
  for (const JsonValue& segment : *value.array()) {
    if (!Codec<CubicSegment<double>>::read(reader, segment, out.emplace_back(), rule)) return false;
  }
  return true;
}

Json Codec<ValueChain>::write(const ValueChain& value, const ValueChain&, const Rule& rule) {
  if (value.size() == 1 && value == constantValue(value[0][0])) return value[0][0];
  Json segments = Json::array();
  for (const auto& segment : value)
    append(segments, Codec<CubicSegment<double>>::write(segment, segment, rule));
  return segments;
}

Json Codec<ValueChain>::schema(const Rule& rule) {
  return anyOfSchema(numberSchema("number", rule), listSchema(Codec<CubicSegment<double>>::schema(rule)));
}

template <class Point>
bool ChainCodec<Point>::read(JsonReader& reader, const JsonValue& value, Chain& out, const Rule& rule) {
  if (!reader.checkList(value, rule, 0, kMostValues)) return false;
  out.clear();
  for (const JsonValue& segment : *value.array()) {
    if (segment.array() == nullptr || segment.array()->size() != 2) {
      if (!Codec<CubicSegment<Point>>::read(reader, segment, out.emplace_back(), rule)) return false;
      continue;
    }
    std::array<Point, 2> ends{Point::Zero(), Point::Zero()};
    if (!Codec<std::array<Point, 2>>::read(reader, segment, ends, rule)) return false;
    out.push_back(straightSegment<Point>(ends[0], ends[1]));
  }
  return true;
}

template <class Point>
Json ChainCodec<Point>::write(const Chain& value, const Chain&, const Rule& rule) {
  Json segments = Json::array();
  for (const auto& segment : value) {
    if (segment == straightSegment<Point>(segment[0], segment[3])) {
      append(segments, Codec<std::array<Point, 2>>::write({segment[0], segment[3]}, {}, rule));
    } else {
      append(segments, Codec<CubicSegment<Point>>::write(segment, segment, rule));
    }
  }
  return segments;
}

template <class Point>
Json ChainCodec<Point>::schema(const Rule& rule) {
  const Json curved = Codec<CubicSegment<Point>>::schema(rule);
  const Json straight = Codec<std::array<Point, 2>>::schema(rule);
  return listSchema(anyOfSchema(curved, straight));
}

template struct ChainCodec<Vec2>;
template struct ChainCodec<Vec3>;

}  // namespace modeling
