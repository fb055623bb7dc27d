#include "modeling/scene/field_info.h"

#include <algorithm>

#include "modeling/scene/scene_fields.h"
#include "modeling/scene/scene_labels.h"
#include "modeling/scene/scene_names.h"

namespace modeling {
namespace {

template <class T>
concept HasFields = requires {
  Fields<T>::list();
};

template <class Value>
concept HasAccess = std::is_constructible_v<FieldAccess, ValueAccess<Value>>;

template <class T>
struct OptionalOf : std::false_type {};
template <class T>
struct OptionalOf<std::optional<T>> : std::true_type {
  using Value = T;
};

/// Made of numbers alone, all of them within one range.
template <class T>
inline constexpr bool kNumeric = std::is_arithmetic_v<T> && !std::same_as<T, bool>;
template <>
inline constexpr bool kNumeric<Rotation> = true;
template <>
inline constexpr bool kNumeric<Scale> = true;
template <>
inline constexpr bool kNumeric<Step> = true;
template <>
inline constexpr bool kNumeric<SceneTrackKey> = true;
template <>
inline constexpr bool kNumeric<Box> = true;
template <int kCount>
inline constexpr bool kNumeric<Eigen::Matrix<double, kCount, 1>> = true;
template <class T>
inline constexpr bool kNumeric<std::optional<T>> = kNumeric<T> && !HasFields<T>;
template <class T>
inline constexpr bool kNumeric<std::vector<T>> = kNumeric<T>;
template <class T, std::size_t kCount>
inline constexpr bool kNumeric<std::array<T, kCount>> = kNumeric<T>;

template <class Choice>
const std::vector<ChoiceInfo>& choicesOf() {
  static const std::vector<ChoiceInfo> choices = [] {
    std::vector<ChoiceInfo> all;
    for (const auto& [value, label] : ChoiceLabels<Choice>::kList)
      all.push_back({static_cast<int>(value), std::string(EnumNames<Choice>::nameOf(value)), label});
    return all;
  }();
  return choices;
}

/// The field number kField of Owner, whose member pointer is known to the compiler, so that plain functions
/// can reach the value.
template <class Owner, std::size_t kField>
struct Accessor {
  static constexpr auto field() { return std::get<kField>(Fields<Owner>::list()); }
  using Value = std::remove_cvref_t<decltype(std::declval<Owner&>().*(field().member))>;

  static Value& of(void* owner) {
    constexpr auto kMember = field().member;
    return static_cast<Owner*>(owner)->*kMember;
  }
  static bool counts(const void* owner) {
    constexpr auto kCounts = field().counts;
    return kCounts == nullptr || kCounts(*static_cast<const Owner*>(owner));
  }
  static int choice(const void* owner) {
    constexpr auto kMember = field().member;
    return static_cast<int>(static_cast<const Owner*>(owner)->*kMember);
  }
  static void choose(void* owner, int value) { of(owner) = static_cast<Value>(value); }
  static void* group(void* owner) {
    if constexpr (OptionalOf<Value>::value) {
      return of(owner) ? &*of(owner) : nullptr;
    } else {
      return &of(owner);
    }
  }
  static void setPresent(void* owner, bool present) {
    if (!present) return of(owner).reset();
    if (!of(owner)) of(owner).emplace();
  }

  static FieldAccess access() {
    if constexpr (HasAccess<Value>) {
      return ValueAccess<Value>{of};
    } else if constexpr (std::is_enum_v<Value>) {
      return ChoiceAccess{choicesOf<Value>, choice, choose};
    } else if constexpr (HasFields<Value>) {
      return GroupAccess{fieldsOf<Value>, group, nullptr};
    } else if constexpr (OptionalOf<Value>::value) {
      using Inner = typename OptionalOf<Value>::Value;
      if constexpr (HasFields<Inner>) return GroupAccess{fieldsOf<Inner>, group, setPresent};
      return OtherAccess{};
    } else {
      return OtherAccess{};
    }
  }
};

template <class Owner>
std::vector<FieldInfo> infosOf() {
  static const Owner kStandard{};
  std::vector<FieldInfo> infos;
  const auto list = Fields<Owner>::list();
  [&]<std::size_t... kField>(std::index_sequence<kField...>) {
    (infos.push_back({std::get<kField>(list).rule, std::get<kField>(list).display,
                      Accessor<Owner, kField>::access(), kNumeric<typename Accessor<Owner, kField>::Value>,
                      Accessor<Owner, kField>::counts, &kStandard}),
     ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(list)>>());
  return infos;
}

}  // namespace

template <class Owner>
std::span<const FieldInfo> fieldsOf() {
  static const std::vector<FieldInfo> infos = infosOf<Owner>();
  return infos;
}

// Of each kind of part and of collider.
namespace {

template <class... Kinds>
constexpr auto fieldsOfEach(const std::variant<Kinds...>*) {
  return std::array{&fieldsOf<Kinds>...};
}
[[gnu::used]] constexpr auto kOfParts = fieldsOfEach(static_cast<const PartShape*>(nullptr));
[[gnu::used]] constexpr auto kOfColliders = fieldsOfEach(static_cast<const ColliderForm*>(nullptr));

}  // namespace

template std::span<const FieldInfo> fieldsOf<Backdrop>();
template std::span<const FieldInfo> fieldsOf<BondType>();
template std::span<const FieldInfo> fieldsOf<Box>();
template std::span<const FieldInfo> fieldsOf<Camera>();
template std::span<const FieldInfo> fieldsOf<Contact>();
template std::span<const FieldInfo> fieldsOf<EnvironmentLight>();
template std::span<const FieldInfo> fieldsOf<Gluing>();
template std::span<const FieldInfo> fieldsOf<Ground>();
template std::span<const FieldInfo> fieldsOf<Look>();
template std::span<const FieldInfo> fieldsOf<Material>();
template std::span<const FieldInfo> fieldsOf<Output>();
template std::span<const FieldInfo> fieldsOf<Part>();
template std::span<const FieldInfo> fieldsOf<PictureStyle>();
template std::span<const FieldInfo> fieldsOf<Placement>();
template std::span<const FieldInfo> fieldsOf<Plastic>();
template std::span<const FieldInfo> fieldsOf<Resolution>();
template std::span<const FieldInfo> fieldsOf<Scene>();
template std::span<const FieldInfo> fieldsOf<SceneCollider>();
template std::span<const FieldInfo> fieldsOf<SceneEnvironment>();
template std::span<const FieldInfo> fieldsOf<SceneTrack>();
template std::span<const FieldInfo> fieldsOf<Solver>();
template std::span<const FieldInfo> fieldsOf<ThresholdSpec>();
template std::span<const FieldInfo> fieldsOf<View>();
template std::span<const FieldInfo> fieldsOf<sim::SkipSettings>();

const FieldInfo* findField(std::span<const FieldInfo> fields, std::string_view key) {
  const auto found =
      std::ranges::find_if(fields, [key](const FieldInfo& info) { return info.rule.key == key; });
  return found == fields.end() ? nullptr : &*found;
}

}  // namespace modeling
