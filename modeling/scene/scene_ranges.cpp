#include "modeling/scene/scene_ranges.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "modeling/scene/json_codec.h"
#include "modeling/scene/scene_fields.h"
#include "modeling/scene/scene_names.h"
#include "modeling/scene/tracks.h"
#include "modeling/text/json_reader.h"
#include "modeling/text/json_text.h"

namespace modeling {
namespace {

/// Where a number is: a key or a place in a list, within what is outside of it. Made into text only where
/// needed.
struct Place {
  const Place* outer = nullptr;
  std::string_view key;
  std::size_t index = 0;  ///< where there is no key

  std::string text() const {
    const std::string before = outer == nullptr ? "" : outer->text();
    if (key.empty()) return before + "[" + std::to_string(index) + "]";
    return before + (before.empty() ? "" : ".") + std::string(key);
  }
};

template <class T>
concept HasFields = requires {
  Fields<T>::list();
};
template <class T>
concept Vector = std::is_base_of_v<Eigen::MatrixBase<T>, T>;
template <class T>
concept List = !std::same_as<T, std::string> && requires(T & list) {
  list.begin();
  list.size();
};

/// Shows all numbers of a value to visit(number, rule, place), whose number may be changed where the value
/// may.
template <class Visit>
struct NumberWalk {
  Visit visit;

  template <class T>
  void operator()(T& value, const Rule& rule, const Place& place) {
    using Value = std::remove_const_t<T>;
    if constexpr (std::is_arithmetic_v<Value> && !std::same_as<Value, bool>) {
      visit(value, rule, place);
    } else if constexpr (Vector<Value>) {
      for (Eigen::Index i = 0; i < value.size(); ++i)
        visit(value[i], rule, Place{&place, {}, static_cast<std::size_t>(i)});
    } else if constexpr (List<Value>) {
      std::size_t i = 0;
      for (auto& item : value) (*this)(item, rule, Place{&place, {}, i++});
    } else {
      whole(value, rule, place);
    }
  }

  /// The keys of a struct, side by side with those of what it holds besides.
  template <class T>
  void fieldsOf(T& owner, const Place* outer) {
    forEachField<std::remove_const_t<T>>([&](const auto& entry) {
      (*this)(owner.*entry.member, entry.rule, Place{outer, entry.rule.key, 0});
    });
  }

 private:
  template <class Value>
  void whole(std::optional<Value>& value, const Rule& rule, const Place& place) {
    if (value) (*this)(*value, rule, place);
  }
  template <class Value>
  void whole(const std::optional<Value>& value, const Rule& rule, const Place& place) {
    if (value) (*this)(*value, rule, place);
  }
  template <class T>
  void whole(T& value, const Rule& rule, const Place& place) {
    using Value = std::remove_const_t<T>;
    if constexpr (std::same_as<Value, Part>) {
      fieldsOf(value, &place);
      std::visit([&](auto& shape) { fieldsOf(shape, &place); }, value.shape);
    } else if constexpr (std::same_as<Value, SceneCollider>) {
      fieldsOf(value, &place);
      std::visit([&](auto& form) { fieldsOf(form, &place); }, value.form);
    } else if constexpr (std::same_as<Value, SceneMaterial>) {
      fieldsOf(value.values, &place);
    } else if constexpr (std::same_as<Value, NamedBondType>) {
      fieldsOf(value.constants, &place);
    } else if constexpr (std::same_as<Value, SceneTrack>) {
      for (std::size_t i = 0; i < value.keys.size(); ++i) key(value, i, place);
    } else if constexpr (std::same_as<Value, Rotation>) {
      std::visit([&](auto& numbers) { (*this)(numbers, rule, place); }, value.value);
    } else if constexpr (std::same_as<Value, Scale>) {
      (*this)(value.factors, rule, place);
    } else if constexpr (std::same_as<Value, Step>) {
      (*this)(value.seconds, rule, place);
      (*this)(value.tolerance, kToleranceRule, Place{&place, "tolerance", 0});
    } else if constexpr (HasFields<Value>) {
      fieldsOf(value, &place);
    }
  }

  template <class T>
  void key(T& track, std::size_t i, const Place& place) {
    const Place keys{&place, "keys", 0};
    const Place at{&keys, {}, i};
    const Place time{&at, {}, 0};
    const Place value{&at, {}, 1};
    visit(track.keys[i].time, Rule{"keys", {}, true, keyTimeRange(), false}, time);
    const Rule rule{"keys", {}, true, keyRange(track.target), false};
    std::visit([&](auto& driven) { (*this)(driven, rule, value); }, track.keys[i].value);
  }
};

template <class T, class Visit>
void forEachNumber(T& scene, Visit visit) {
  NumberWalk<Visit>{visit}.fieldsOf(scene, nullptr);
}

}  // namespace

NumberRange keyRange(const TargetName& target) {
  return {leastOf(target), mostOf(target)};
}

NumberRange keyTimeRange() {
  return {-reachOf(Dimension::time), reachOf(Dimension::time)};
}

std::optional<sim::Problem> numberOutOfRange(const Scene& scene) {
  std::optional<sim::Problem> first;
  forEachNumber(scene, [&](const auto& number, const Rule& rule, const Place& place) {
    const auto value = static_cast<double>(number);
    if (first || rule.range.holds(value)) return;
    const std::string told = std::isfinite(value) ? shortestNumber(value) : "what is no number";
    first =
        sim::Problem{place.text(), std::string(rule.key) + " holds " + told, "give " + rangeText(rule.range)};
  });
  return first;
}

void keepNumbersInRange(Scene& scene) {
  forEachNumber(scene, [](auto& number, const Rule& rule, const Place&) {
    auto value = static_cast<double>(number);
    if (rule.range.holds(value)) return;
    if (std::isnan(value)) value = 0.0;
    number = static_cast<std::remove_reference_t<decltype(number)>>(
        std::clamp(value, rule.range.least, rule.range.most));
  });
}

}  // namespace modeling
