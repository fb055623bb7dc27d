// The tables of docs/formats.md are made from the lists of fields.
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>

#include <catch2/catch.hpp>

#include "modeling/scene/field_info.h"
#include "modeling/text/json_text.h"

namespace {

using modeling::FieldInfo;
using modeling::shortestNumber;
using Fields = std::span<const FieldInfo>;

std::string inCode(const std::string& text) {
  return "`" + text + "`";
}

std::string listOf(const double* numbers, std::size_t count) {
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + shortestNumber(numbers[i]);
  return text + "]";
}

/// A value as a file would have it; "" where nothing can be said in a word.
struct Words {
  bool angle;

  std::string operator()(double number) const {
    if (!angle) return shortestNumber(number);
    return shortestNumber(std::round(number * 180.0 / std::numbers::pi * 1e9) / 1e9);
  }
  std::string operator()(std::uint64_t number) const { return std::to_string(number); }
  std::string operator()(bool truth) const { return truth ? "true" : "false"; }
  std::string operator()(const std::string& text) const { return text.empty() ? "" : inCode(text); }
  std::string operator()(const modeling::Vec3& vector) const {
    return vector.isZero() ? "0" : listOf(vector.data(), 3);
  }
  std::string operator()(const modeling::Colour& colour) const { return listOf(colour.data(), 3); }
  std::string operator()(const modeling::Rotation&) const { return "none"; }
  std::string operator()(const modeling::Scale& scale) const { return shortestNumber(scale.factors.x()); }
  std::string operator()(const modeling::ValueChain& chain) const { return shortestNumber(chain[0][0]); }
  template <class Value>
  std::string operator()(const std::optional<Value>& value) const {
    return value ? (*this)(*value) : "";
  }
  std::string operator()(const std::array<double, 2>& interval) const { return listOf(interval.data(), 2); }
};

/// What a value is where the key is left out.
struct Standard {
  const FieldInfo& info;

  template <class Value>
  std::string operator()(const modeling::ValueAccess<Value>& access) const {
    return Words{info.rule.angle}(modeling::standardOf(info, access));
  }
  std::string operator()(const modeling::ChoiceAccess& access) const {
    for (const modeling::ChoiceInfo& choice : access.choices()) {
      if (choice.value == access.get(info.standard)) return inCode(choice.name);
    }
    return "";
  }
  std::string operator()(const modeling::GroupAccess&) const { return ""; }
  std::string operator()(const modeling::OtherAccess&) const { return ""; }
};

std::string leftOut(const FieldInfo& info) {
  if (info.rule.required) return "required";
  if (!info.display.absent.empty()) return std::string(info.display.absent);
  return std::visit(Standard{info}, info.access);
}

std::string range(const FieldInfo& info) {
  if (!info.numeric) return "";
  const modeling::NumberRange& range = info.rule.range;
  if (range.least == -range.most) return "±" + shortestNumber(range.most);
  return shortestNumber(range.least) + ", " + shortestNumber(range.most);
}

std::string meaning(const FieldInfo& info) {
  std::string text(info.rule.help);
  const auto* choice = std::get_if<modeling::ChoiceAccess>(&info.access);
  if (choice == nullptr) return text;
  std::string names;
  for (const modeling::ChoiceInfo& each : choice->choices())
    names += (names.empty() ? "" : ", ") + inCode(each.name);
  return text + " One of " + names + ".";
}

/// Fields of groups follow the group, with its key before theirs, where `nested`.
void addRows(Fields fields, const std::string& before, bool nested, std::string& table) {
  for (const FieldInfo& info : fields) {
    const std::string key = before + std::string(info.rule.key);
    table += "| " + inCode(key) + " | " + meaning(info) + " | " +
             std::string(modeling::unitInFile(info.display.dimension)) + " | " + range(info) + " | " +
             leftOut(info) + " |\n";
    const auto* group = std::get_if<modeling::GroupAccess>(&info.access);
    if (nested && group != nullptr) addRows(group->fields(), key + ".", nested, table);
  }
}

std::string tableOf(Fields fields, bool nested = true) {
  std::string table = "| key | meaning | unit | from, to | left out |\n| --- | --- | --- | --- | --- |\n";
  addRows(fields, "", nested, table);
  return table;
}

struct Table {
  const char* name;
  std::string text;
};

std::vector<Table> tables() {
  using namespace modeling;
  return {{"scene", tableOf(fieldsOf<Scene>(), false)},
          {"material", tableOf(fieldsOf<Material>())},
          {"part", tableOf(fieldsOf<Part>())},
          {"resolution", tableOf(fieldsOf<Resolution>())},
          {"slab", tableOf(fieldsOf<SlabShape>(), false)},
          {"patch", tableOf(fieldsOf<BezierPatchShape>(), false)},
          {"revolution", tableOf(fieldsOf<RevolutionShape>(), false)},
          {"curvedCylinder", tableOf(fieldsOf<CurvedCylinderShape>(), false)},
          {"mesh", tableOf(fieldsOf<MeshShape>())},
          {"network", tableOf(fieldsOf<NetworkShape>())},
          {"bond type", tableOf(fieldsOf<BondType>())},
          {"gluing", tableOf(fieldsOf<Gluing>())},
          {"environment", tableOf(fieldsOf<SceneEnvironment>())},
          {"collider", tableOf(fieldsOf<SceneCollider>())},
          {"box collider", tableOf(fieldsOf<BoxShape>())},
          {"sphere collider", tableOf(fieldsOf<SphereShape>())},
          {"cylinder collider", tableOf(fieldsOf<CylinderShape>())},
          {"mesh collider", tableOf(fieldsOf<MeshObstacle>())},
          {"track", tableOf(fieldsOf<SceneTrack>())},
          {"solver", tableOf(fieldsOf<Solver>())},
          {"output", tableOf(fieldsOf<Output>())},
          {"view", tableOf(fieldsOf<View>())}};
}

const std::string kFile = SMITHEREENS_SOURCE_DIR "/docs/formats.md";

std::string textOf(const std::string& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Where the table of that name stands between its two marks; empty where it has no place.
std::pair<std::size_t, std::size_t> placeOf(const Table& table, const std::string& text) {
  const std::string mark = std::string("<!-- fields: ") + table.name + " -->\n";
  const std::size_t start = text.find(mark);
  const std::size_t end = text.find("<!-- end of fields -->", start);
  if (start == std::string::npos || end == std::string::npos) return {0, 0};
  return {start + mark.size(), end};
}

TEST_CASE("the tables of fields in the description of the format are those of the reader") {
  // SMITHEREENS_RENEW_TABLES=1 in the environment writes them anew.
  std::string text = textOf(kFile);
  const bool renew = std::getenv("SMITHEREENS_RENEW_TABLES") != nullptr;
  for (const Table& table : tables()) {
    const auto [start, end] = placeOf(table, text);
    INFO(table.name);
    REQUIRE(end > start);
    if (renew) {
      text.replace(start, end - start, table.text);
    } else {
      CHECK(text.substr(start, end - start) == table.text);
    }
  }
  if (renew) std::ofstream(kFile) << text;
}

}  // namespace
