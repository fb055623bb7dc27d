#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "modeling/scene/scene.h"
#include "modeling/text/json_fields.h"

/// The fields of a scene as data: what forms and tables of documentation are made from without knowing a
/// struct. Everything here comes from the lists of fields (scene_fields.h).
namespace modeling {

/// One value of an enumeration.
struct ChoiceInfo {
  int value = 0;
  std::string name;        ///< in files
  std::string_view label;  ///< for people, in English
};

struct FieldInfo;

/// How a value of one type is reached in its struct. `owner` points to the struct the field belongs to.
template <class Value>
struct ValueAccess {
  Value& (*of)(void* owner);
};

struct ChoiceAccess {
  const std::vector<ChoiceInfo>& (*choices)();  ///< in the order of menus
  int (*get)(const void* owner);
  void (*set)(void* owner, int value);
};

/// A struct within the struct, with fields of its own.
struct GroupAccess {
  std::span<const FieldInfo> (*fields)();
  void* (*of)(void* owner);                       ///< null where there is none at present
  void (*setPresent)(void* owner, bool present);  ///< null where there always is one
};

/// A value that only a form of its own can show: a list, a curve, a name of something else.
struct OtherAccess {};

using FieldAccess =
    std::variant<ValueAccess<double>, ValueAccess<std::optional<double>>, ValueAccess<bool>,
                 ValueAccess<std::uint64_t>, ValueAccess<std::string>, ValueAccess<Vec3>, ValueAccess<Colour>,
                 ValueAccess<std::optional<Colour>>, ValueAccess<std::optional<std::array<double, 2>>>,
                 ValueAccess<Rotation>, ValueAccess<Scale>, ValueAccess<ValueChain>, ChoiceAccess,
                 GroupAccess, OtherAccess>;

struct FieldInfo {
  Rule rule;
  Display display;
  FieldAccess access;
  bool numeric;                       ///< it is a number or made of numbers, each within rule.range
  bool (*counts)(const void* owner);  ///< whether the value is looked at, given the owner's other values
  const void* standard;               ///< an owner with the values that are not given
};

/// The fields of one struct, in the order of its file. Instantiated for every struct of a scene that has
/// fields (field_info.cpp).
template <class Owner>
std::span<const FieldInfo> fieldsOf();

/// The value that is not given.
template <class Value>
Value standardOf(const FieldInfo& info, const ValueAccess<Value>& access) {
  return access.of(const_cast<void*>(info.standard));  // NOLINT(*-const-cast): of() changes nothing
}

/// The field with that key, or null.
const FieldInfo* findField(std::span<const FieldInfo> fields, std::string_view key);

}  // namespace modeling
