#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace modeling {

/// JSON as a person likes to read it: two spaces a level; what fits on a line stays on one. Numbers are the
/// shortest that read back as the same double.
std::string jsonText(const nlohmann::ordered_json& value);

/// The shortest decimal that reads back as `number`, which is finite.
std::string shortestNumber(double number);

}  // namespace modeling
