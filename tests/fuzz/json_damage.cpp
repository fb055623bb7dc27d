#include "tests/fuzz/json_damage.h"

#include <limits>
#include <vector>

#include <nlohmann/json.hpp>

namespace tests {
namespace {

using Json = nlohmann::ordered_json;

void collect(Json& value, std::vector<Json*>& all) {
  all.push_back(&value);
  if (!value.is_structured()) return;
  for (Json& inner : value) collect(inner, all);
}

Json someValue(Chance& chance) {
  constexpr double kHuge = 1e300;
  switch (chance.below(16)) {
    case 0:
      return nullptr;
    case 1:
      return chance.below(2) == 0;
    case 2:
      return "";
    case 3:
      return std::string(100 + chance.below(100'000), 'n');
    case 4:
      return "a\nb\x1b[2J \"c\" \xf0\x9f\x98\x80";
    case 5:
      return Json::array();
    case 6:
      return Json::object();
    case 7:
      return -1;
    case 8:
      return 0;
    case 9:
      return std::numeric_limits<std::uint64_t>::max();
    case 10:
      return chance.below(2) == 0 ? kHuge : -kHuge;
    case 11:
      return chance.below(2) == 0 ? 5e-324 : 1e-30;
    case 12:
      return 4'000'000'000.0;
    case 13:
      return static_cast<double>(chance.any()) / 1e15;
    case 14:
      return std::vector<double>(chance.below(5000), 1.0);
    default:
      return static_cast<double>(chance.below(2000)) / 100.0 - 10.0;
  }
}

/// A number near or far from the one there was.
void scaleNumber(Json& value, Chance& chance) {
  constexpr double kFactors[] = {-1.0, 0.0, 0.5, 0.999, 2.0, 10.0, 1e3, 1e6, 1e-6, 1e12};
  value = value.get<double>() * kFactors[chance.below(std::size(kFactors))];
}

void changeMembers(Json& object, Chance& chance) {
  const auto chosen = std::next(object.begin(), static_cast<std::ptrdiff_t>(chance.below(object.size())));
  const Json value = chosen.value();
  const std::string key = chosen.key();
  if (chance.below(3) > 0) object.erase(key);
  if (chance.below(2) == 0) object[key + (chance.below(2) == 0 ? "s" : "")] = value;
}

void changeItems(Json& array, Chance& chance) {
  const std::size_t chosen = chance.below(array.size());
  const Json item = array[chosen];
  if (chance.below(3) == 0) {
    array.erase(chosen);
  } else {
    for (std::size_t times = chance.below(2) == 0 ? 1 : chance.below(200); times > 0; --times)
      array.push_back(item);
  }
}

}  // namespace

void damageJson(std::string& text, Chance& chance) {
  Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded()) return;
  std::vector<Json*> all;
  collect(document, all);
  std::vector<Json*> numbers = all;
  std::erase_if(numbers, [](const Json* value) { return !value->is_number(); });
  // Numbers are what a scene can have otherwise and still be one.
  if (chance.below(2) == 0 && !numbers.empty()) {
    scaleNumber(*numbers[chance.below(numbers.size())], chance);
    text = document.dump(1);
    return;
  }
  Json& value = *all[chance.below(all.size())];
  const Json another = *all[chance.below(all.size())];
  const std::size_t way = chance.below(6);
  if (way < 2 && value.is_number()) {
    scaleNumber(value, chance);
  } else if (way < 2 && value.is_object() && !value.empty()) {
    changeMembers(value, chance);
  } else if (way < 2 && value.is_array() && !value.empty()) {
    changeItems(value, chance);
  } else if (way == 2) {
    value = another;
  } else if (way == 3) {
    Json nested = value;
    for (std::size_t depth = 1 + chance.below(300); depth > 0; --depth)
      nested = Json::array({std::move(nested)});
    value = std::move(nested);
  } else {
    value = someValue(chance);
  }
  text = document.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tests
