#include "app/results/json.h"

#include <limits>

#include <catch2/catch.hpp>

namespace {

using app::Json;

TEST_CASE("members of an object are written in the order in which they were added") {
  Json object{{"zebra", 1}, {"ape", "two"}};
  object["moose"] = true;
  CHECK(app::dumped(object) == R"({"zebra":1,"ape":"two","moose":true})");
  object["ape"] = 2.5;
  CHECK(app::dumped(object) == R"({"zebra":1,"ape":2.5,"moose":true})");
}

TEST_CASE("what is written reads back the same, numbers to the last bit") {
  const Json value{{"third", 1.0 / 3.0},
                   {"large", std::numeric_limits<std::uint64_t>::max()},
                   {"negative", -7},
                   {"none", std::optional<double>()},
                   {"some", std::optional(0.1)},
                   {"list", std::vector<unsigned>{3, 1, 2}},
                   {"inside", Json{{"quote", "\"\n"}, {"flag", false}}}};
  for (const int indent : {-1, 0, 2}) {
    const auto again = app::parseJson(app::dumped(value, indent));
    REQUIRE(again);
    CHECK(app::dumped(*again) == app::dumped(value));
    CHECK(*again->find("third")->get<double>() == 1.0 / 3.0);
    CHECK(*again->find("large")->get<std::uint64_t>() == std::numeric_limits<std::uint64_t>::max());
    CHECK(again->numberAt("negative") == -7.0);
    CHECK(again->find("none")->get<Json::Null>() != nullptr);
    CHECK(again->numberAt("some") == 0.1);
    CHECK(again->find("list")->get<Json::Array>()->size() == 3);
    CHECK(again->find("inside")->textAt("quote") == "\"\n");
  }
}

TEST_CASE("a member that is not there, or of another type, is no number, text or flag") {
  const Json object{{"number", 1}, {"text", "words"}};
  CHECK(object.find("other") == nullptr);
  CHECK_FALSE(object.numberAt("text"));
  CHECK(object.textAt("number").empty());
  CHECK_FALSE(object.flagAt("number"));
  CHECK(Json(3).find("number") == nullptr);
  CHECK_FALSE(app::parseJson("{\"cut\": "));
  CHECK_FALSE(app::parseJson(""));
}

}  // namespace
