#include "modeling/scene/scene_codec.h"

#include <charconv>

#include "modeling/scene/scene_ranges.h"
#include "modeling/text/spelling.h"

namespace modeling {
bool Codec<Rotation>::read(JsonReader& reader, const JsonValue& value, Rotation& out, const Rule& rule) {
  if (value.array() != nullptr && value.array()->size() == 4) {
    Eigen::Vector4d quaternion = Eigen::Vector4d::Zero();
    if (!Codec<Eigen::Vector4d>::read(reader, value, quaternion, rule)) return false;
    out.value = quaternion;
    const double length = quaternion.stableNorm();
    return (length > 0.0 && std::isfinite(length)) ||
           reader.fail(value.position, "this quaternion has no direction",
                       "give [1, 0, 0, 0] for no rotation");
  }
  Vec3 degrees = Vec3::Zero();
  if (!Codec<Vec3>::read(reader, value, degrees, rule)) return false;
  out.value = degrees;
  return true;
}

Json Codec<Rotation>::write(const Rotation& value, const Rotation&, const Rule& rule) {
  return std::visit(
      [&](const auto& numbers) {
        return Codec<std::remove_cvref_t<decltype(numbers)>>::write(numbers, numbers, rule);
      },
      value.value);
}

Json Codec<Rotation>::schema(const Rule& rule) {
  return anyOfSchema(Codec<Vec3>::schema(rule), Codec<Eigen::Vector4d>::schema(rule));
}

bool Codec<Scale>::read(JsonReader& reader, const JsonValue& value, Scale& out, const Rule& rule) {
  if (value.array() != nullptr) return Codec<Vec3>::read(reader, value, out.factors, rule);
  double factor = 1.0;
  if (!reader.readNumber(value, factor, rule)) return false;
  out.factors = Vec3::Constant(factor);
  return true;
}

Json Codec<Scale>::write(const Scale& value, const Scale&, const Rule& rule) {
  const Vec3& factors = value.factors;
  if (factors == Vec3::Constant(factors.x())) return factors.x();
  return Codec<Vec3>::write(factors, factors, rule);
}

Json Codec<Scale>::schema(const Rule& rule) {
  return anyOfSchema(numberSchema("number", rule), Codec<Vec3>::schema(rule));
}

bool Codec<Gluing>::read(JsonReader& reader, const JsonValue& value, Gluing& out, const Rule& rule) {
  return FieldsCodec<Gluing>::read(reader, value, out, rule);
}

Json Codec<Gluing>::write(const Gluing& value, const Gluing& base, const Rule& rule) {
  return FieldsCodec<Gluing>::write(value, base, rule);
}

Json Codec<Gluing>::schema(const Rule& rule) {
  return FieldsCodec<Gluing>::schema(rule);
}

bool Codec<Step>::read(JsonReader& reader, const JsonValue& value, Step& out, const Rule& rule) {
  out = {};
  if (value.object() != nullptr) {
    if (!reader.checkObject(value, rule, {"tolerance"})) return false;
    const JsonValue* tolerance = value.find("tolerance");
    return tolerance != nullptr ? reader.readNumber(*tolerance, out.tolerance.emplace(), kToleranceRule)
                                : reader.failMissing(value, "tolerance");
  }
  if (value.text() == nullptr) return reader.readNumber(value, out.seconds.emplace(), rule);
  return *value.text() == "auto" || reader.failChoice(value, rule, {"auto"});
}

Json Codec<Step>::write(const Step& value, const Step&, const Rule&) {
  if (value.tolerance) return {{"tolerance", *value.tolerance}};
  return value.seconds ? Json(*value.seconds) : Json("auto");
}

Json Codec<Step>::schema(const Rule& rule) {
  Json tolerant = objectSchema();
  tolerant["properties"]["tolerance"] = numberSchema("number", kToleranceRule);
  tolerant["required"] = {"tolerance"};
  return {{"anyOf", {{{"const", "auto"}}, numberSchema("number", rule), tolerant}}};
}

bool Codec<TargetName>::read(JsonReader& reader, const JsonValue& value, TargetName& out, const Rule& rule) {
  if (value.text() == nullptr) return reader.failKind(value, rule, "a text");
  const std::optional<TargetName> target = TargetName::parse(*value.text());
  if (!target) {
    return reader.failChoice(
        value, rule,
        {"gravity", "gravity.scale", "stiffness.scale", "stiffness.scale.MATERIAL", "damping.scale",
         "damping.scale.MATERIAL", "collider.NAME.position", "collider.NAME.rotation"});
  }
  out = *target;
  return true;
}

Json Codec<TargetName>::write(const TargetName& value, const TargetName&, const Rule&) {
  return value.text();
}

Json Codec<TargetName>::schema(const Rule&) {
  return typeSchema("string");
}

// What the value may be depends on what it drives, which the track knows (keyRange).
bool Codec<SceneTrackKey>::read(JsonReader& reader, const JsonValue& value, SceneTrackKey& out,
                                const Rule& rule) {
  const Rule ofTime{rule.key, {}, true, keyTimeRange(), false};
  if (!reader.checkList(value, rule, 2, 2) || !reader.readNumber((*value.array())[0], out.time, ofTime))
    return false;
  const JsonValue& driven = (*value.array())[1];
  if (driven.array() == nullptr) {
    double number = 0.0;
    const bool good = reader.readNumber(driven, number, rule);
    out.value = number;
    return good;
  }
  Vec3 vector = Vec3::Zero();
  const bool good = Codec<Vec3>::read(reader, driven, vector, rule);
  out.value = vector;
  return good;
}

Json Codec<SceneTrackKey>::write(const SceneTrackKey& value, const SceneTrackKey&, const Rule& rule) {
  Json key = Json::array({value.time});
  std::visit(
      [&](const auto& driven) {
        append(key, Codec<std::remove_cvref_t<decltype(driven)>>::write(driven, driven, rule));
      },
      value.value);
  return key;
}

Json Codec<SceneTrackKey>::schema(const Rule& rule) {
  const Json time = numberSchema("number", {rule.key, {}, true, keyTimeRange(), false});
  const Json number = numberSchema("number", rule);
  const Json items = Json::array({time, anyOfSchema(number, Codec<Vec3>::schema(rule))});
  return {{"type", "array"}, {"items", items}, {"minItems", 2}, {"maxItems", 2}};
}

bool Codec<std::vector<NamedBondType>>::read(JsonReader& reader, const JsonValue& value, Types& out,
                                             const Rule& rule) {
  if (value.object() == nullptr) return reader.failKind(value, rule, "an object");
  out.clear();
  for (const JsonMember& member : *value.object()) {
    int number = 0;
    const char* end = member.key.data() + member.key.size();
    const auto parsed = std::from_chars(member.key.data(), end, number);
    if (parsed.ec != std::errc{} || parsed.ptr != end || number < 1 || std::to_string(number) != member.key) {
      return reader.fail(member.position, inQuotes(member.key) + " is no bond type",
                         "give a whole number from 1 on");
    }
    NamedBondType& type = out.emplace_back(NamedBondType{member.key, {}});
    if (!Codec<BondType>::read(reader, member.value, type.constants, {member.key, {}, true, {}, false}))
      return false;
  }
  return true;
}

Json Codec<std::vector<NamedBondType>>::write(const Types& value, const Types&, const Rule& rule) {
  Json object = Json::object();
  for (const NamedBondType& type : value)
    setMember(object, type.type, Codec<BondType>::write(type.constants, {}, rule));
  return object;
}

Json Codec<std::vector<NamedBondType>>::schema(const Rule& rule) {
  return mapSchema(Codec<BondType>::schema(rule));
}

}  // namespace modeling
