#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "modeling/text/json_build.h"
#include "modeling/text/json_document.h"
#include "modeling/text/json_fields.h"
#include "modeling/text/json_reader.h"

/// Values to and from JSON. For each type T that stands in a file, Codec<T> has three functions:
///
/// - `read(reader, value, out, rule)` fills `out`, and leaves alone what belongs to keys that are not given.
///   It answers false after it told the reader the problem.
/// - `write(value, base, rule)` gives what differs from `base`, the value that a reader starts from.
/// - `schema(rule)` gives the JSON Schema of what `read` takes.
namespace modeling {

template <class T>
struct Codec;

template <std::floating_point T>
struct Codec<T> {
  static bool read(JsonReader& reader, const JsonValue& value, T& out, const Rule& rule) {
    double number = 0.0;
    if (!(rule.angle ? reader.readAngle(value, number, rule) : reader.readNumber(value, number, rule)))
      return false;
    out = static_cast<T>(number);
    return true;
  }
  static Json write(const T& value, const T&, const Rule& rule) {
    return rule.angle ? writeAngle(value) : Json(value);
  }
  static Json schema(const Rule& rule) {
    return rule.angle ? angleSchema(rule) : numberSchema("number", rule);
  }
};

template <class T>
concept Integer = std::integral<T> && !std::same_as<T, bool>;

template <Integer T>
struct Codec<T> {
  static bool read(JsonReader& reader, const JsonValue& value, T& out, const Rule& rule) {
    double number = 0.0;
    if (!reader.readNumber(value, number, rule)) return false;
    const auto* natural = std::get_if<std::uint64_t>(&value.content);
    const auto* integer = std::get_if<std::int64_t>(&value.content);
    const bool fits =
        natural != nullptr ? std::in_range<T>(*natural) : integer != nullptr && std::in_range<T>(*integer);
    if (!fits) return reader.failNumber(value, rule, "a whole number within reach of the program");
    out = natural != nullptr ? static_cast<T>(*natural) : static_cast<T>(*integer);
    return true;
  }
  static Json write(const T& value, const T&, const Rule&) { return value; }
  static Json schema(const Rule& rule) { return numberSchema("integer", rule); }
};

template <>
struct Codec<bool> {
  static bool read(JsonReader& reader, const JsonValue& value, bool& out, const Rule& rule) {
    const bool* truth = std::get_if<bool>(&value.content);
    if (truth == nullptr) return reader.failKind(value, rule, "true or false");
    out = *truth;
    return true;
  }
  static Json write(const bool& value, const bool&, const Rule&) { return value; }
  static Json schema(const Rule&) { return typeSchema("boolean"); }
};

template <>
struct Codec<std::string> {
  static bool read(JsonReader& reader, const JsonValue& value, std::string& out, const Rule& rule) {
    if (value.text() == nullptr) return reader.failKind(value, rule, "a text");
    out = *value.text();
    return true;
  }
  static Json write(const std::string& value, const std::string&, const Rule&) { return value; }
  static Json schema(const Rule&) { return typeSchema("string"); }
};

template <class T>
requires std::is_enum_v<T>
struct Codec<T> {
  static bool read(JsonReader& reader, const JsonValue& value, T& out, const Rule& rule) {
    if (value.text() == nullptr) return reader.failKind(value, rule, "a text");
    const std::optional<T> choice = EnumNames<T>::find(*value.text());
    if (!choice) return reader.failChoice(value, rule, EnumNames<T>::names());
    out = *choice;
    return true;
  }
  static Json write(const T& value, const T&, const Rule&) { return EnumNames<T>::nameOf(value); }
  static Json schema(const Rule&) { return choiceSchema(EnumNames<T>::names()); }
};

/// Fixed numbers of anything; for Eigen vectors, of numbers.
template <class T, class Item, std::size_t kCount>
struct TupleCodec {
  static bool read(JsonReader& reader, const JsonValue& value, T& out, const Rule& rule) {
    if (!reader.checkList(value, rule, kCount, kCount)) return false;
    T whole = out;
    for (std::size_t i = 0; i < kCount; ++i) {
      if (!Codec<Item>::read(reader, (*value.array())[i], whole[static_cast<Index>(i)], rule)) return false;
    }
    out = whole;
    return true;
  }
  static Json write(const T& value, const T&, const Rule& rule) {
    Json list = Json::array();
    for (std::size_t i = 0; i < kCount; ++i) {
      append(list, Codec<Item>::write(value[static_cast<Index>(i)], Item{}, rule));
    }
    return list;
  }
  static Json schema(const Rule& rule) { return listSchema(Codec<Item>::schema(rule), kCount); }

 private:
  using Index = std::conditional_t<std::is_base_of_v<Eigen::EigenBase<T>, T>, Eigen::Index, std::size_t>;
};

template <int kCount>
struct Codec<Eigen::Matrix<double, kCount, 1>>
    : TupleCodec<Eigen::Matrix<double, kCount, 1>, double, kCount> {};
template <class Item, std::size_t kCount>
struct Codec<std::array<Item, kCount>> : TupleCodec<std::array<Item, kCount>, Item, kCount> {};

template <class Item>
struct Codec<std::vector<Item>> {
  static bool read(JsonReader& reader, const JsonValue& value, std::vector<Item>& out, const Rule& rule) {
    if (!reader.checkList(value, rule, 0, kMostValues)) return false;
    out.clear();
    for (const JsonValue& item : *value.array()) {
      if (!Codec<Item>::read(reader, item, out.emplace_back(), rule)) return false;
    }
    return true;
  }
  static Json write(const std::vector<Item>& value, const std::vector<Item>&, const Rule& rule) {
    Json list = Json::array();
    for (const Item& item : value) append(list, Codec<Item>::write(item, Item{}, rule));
    return list;
  }
  static Json schema(const Rule& rule) { return listSchema(Codec<Item>::schema(rule)); }
};

/// `null` takes a value away that the reader started from (a preset's).
template <class Value>
struct Codec<std::optional<Value>> {
  static bool read(JsonReader& reader, const JsonValue& value, std::optional<Value>& out, const Rule& rule) {
    if (std::holds_alternative<JsonValue::Null>(value.content)) {
      out.reset();
      return true;
    }
    if (!out) out.emplace();
    return Codec<Value>::read(reader, value, *out, rule);
  }
  static Json write(const std::optional<Value>& value, const std::optional<Value>& base, const Rule& rule) {
    return value ? Codec<Value>::write(*value, base.value_or(Value{}), rule) : Json(nullptr);
  }
  static Json schema(const Rule& rule) { return nullableSchema(Codec<Value>::schema(rule)); }
};

/// Calls visit(field) for each key of T.
template <class T, class Visit>
void forEachField(Visit&& visit) {
  std::apply([&](const auto&... fields) { (visit(fields), ...); }, Fields<T>::list());
}

template <class T>
std::vector<std::string> keysOf() {
  std::vector<std::string> keys;
  forEachField<T>([&](const auto& entry) { keys.emplace_back(entry.rule.key); });
  return keys;
}

/// Keys of T that older files may hold.
template <class T>
std::vector<RetiredKey> retiredKeysOf() {
  if constexpr (requires { Fields<T>::kRetired; }) {
    return {Fields<T>::kRetired.begin(), Fields<T>::kRetired.end()};
  } else {
    return {};
  }
}

/// The keys of T that the object has, into `out`; keys of others are left alone.
template <class T>
bool readFields(JsonReader& reader, const JsonValue& object, T& out) {
  bool good = true;
  forEachField<T>([&](const auto& entry) {
    if (!good) return;
    using Value = std::remove_cvref_t<decltype(out.*entry.member)>;
    const JsonValue* value = object.find(entry.rule.key);
    if (value != nullptr) {
      good = Codec<Value>::read(reader, *value, out.*entry.member, entry.rule);
    } else if (entry.rule.required) {
      good = reader.failMissing(object, entry.rule.key);
    }
  });
  return good;
}

template <class T>
void writeFields(const T& value, const T& base, Json& object) {
  forEachField<T>([&](const auto& entry) {
    using Value = std::remove_cvref_t<decltype(value.*entry.member)>;
    const Value& mine = value.*entry.member;
    const Value& given = base.*entry.member;
    if (entry.rule.required || !(mine == given))
      setMember(object, entry.rule.key, Codec<Value>::write(mine, given, entry.rule));
  });
}

template <class T>
void addFieldSchemas(Json& schema) {
  forEachField<T>([&](const auto& entry) {
    using Value = std::remove_cvref_t<decltype(std::declval<T&>().*entry.member)>;
    addProperty(schema, entry.rule.key, Codec<Value>::schema(entry.rule), describe(entry.rule, entry.display),
                entry.rule.required);
  });
}

/// An object with the keys of Fields<T>, and no others.
template <class T>
struct FieldsCodec {
  static bool read(JsonReader& reader, const JsonValue& value, T& out, const Rule& rule) {
    return reader.checkObject(value, rule, keysOf<T>(), retiredKeysOf<T>()) && readFields(reader, value, out);
  }
  static Json write(const T& value, const T& base, const Rule&) {
    Json object = Json::object();
    writeFields(value, base, object);
    return object;
  }
  static Json schema(const Rule&) {
    Json schema = objectSchema();
    addFieldSchemas<T>(schema);
    return schema;
  }
};

template <class T>
requires requires {
  Fields<T>::list();
}
struct Codec<T> : FieldsCodec<T> {};

/// An object with the keys of Owner, a key that names an alternative of Owner's `variant`, and that
/// alternative's keys, all side by side: {"name": .., "kind": "slab", "size": ..}.
template <class Owner, class Variant, Variant Owner::*variant>
struct TaggedCodec {
  using Names = VariantNames<Variant>;

  static bool read(JsonReader& reader, const JsonValue& value, Owner& out, const Rule& rule) {
    if (value.object() == nullptr) return reader.failKind(value, rule, "an object");
    const JsonValue* tag = value.find(Names::kTag);
    if (tag == nullptr) return reader.failMissing(value, Names::kTag);
    const Rule tagRule{Names::kTag, {}, true, {}, false};
    if (tag->text() == nullptr) return reader.failKind(*tag, tagRule, "a text");
    bool good = false;
    bool known = false;
    forEachAlternative([&]<std::size_t kIndex>() {
      if (*tag->text() != Names::kNames[kIndex]) return;
      known = true;
      good = readAs<std::variant_alternative_t<kIndex, Variant>>(reader, value, out, rule);
    });
    return known ? good : reader.failChoice(*tag, tagRule, {Names::kNames.begin(), Names::kNames.end()});
  }

  static Json write(const Owner& value, const Owner& base, const Rule&) {
    Json object = Json::object();
    std::visit(
        [&](const auto& shape) {
          using Shape = std::remove_cvref_t<decltype(shape)>;
          setMember(object, "name", value.name);  // the two keys a person looks for come first
          setMember(object, Names::kTag, Names::kNames[(value.*variant).index()]);
          writeFields(value, base, object);
          writeFields(shape, Shape{}, object);
        },
        value.*variant);
    return object;
  }

  static Json schema(const Rule&) {
    Json choices = Json::array();
    forEachAlternative([&]<std::size_t kIndex>() {
      Json choice = objectSchema();
      addConstant(choice, Names::kTag, Names::kNames[kIndex]);
      addFieldSchemas<Owner>(choice);
      addFieldSchemas<std::variant_alternative_t<kIndex, Variant>>(choice);
      append(choices, std::move(choice));
    });
    return {{"oneOf", choices}};
  }

 private:
  template <class Visit>
  static void forEachAlternative(Visit&& visit) {
    [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
      (visit.template operator()<kIndex>(), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Variant>>());
  }

  template <class Shape>
  static bool readAs(JsonReader& reader, const JsonValue& value, Owner& out, const Rule& rule) {
    std::vector<std::string> keys = keysOf<Owner>();
    keys.emplace_back(Names::kTag);
    for (std::string& key : keysOf<Shape>()) keys.push_back(std::move(key));
    std::vector<RetiredKey> retired = retiredKeysOf<Owner>();
    for (const RetiredKey& key : retiredKeysOf<Shape>()) retired.push_back(key);
    Shape shape;
    if (!reader.checkObject(value, rule, keys, retired) || !readFields(reader, value, out) ||
        !readFields(reader, value, shape)) {
      return false;
    }
    out.*variant = std::move(shape);
    return true;
  }
};

}  // namespace modeling
