#include "modeling/text/json_build.h"

#include <utility>

namespace modeling {

void setMember(Json& object, std::string_view key, Json value) {
  object[std::string(key)] = std::move(value);
}

void append(Json& list, Json value) {
  list.push_back(std::move(value));
}

Json typeSchema(std::string_view type) {
  return {{"type", type}};
}

Json choiceSchema(const std::vector<std::string>& choices) {
  return {{"enum", choices}};
}

Json anyOfSchema(Json one, Json other) {
  return {{"anyOf", {std::move(one), std::move(other)}}};
}

Json nullableSchema(Json schema) {
  return anyOfSchema(std::move(schema), typeSchema("null"));
}

Json listSchema(Json items) {
  return {{"type", "array"}, {"items", std::move(items)}};
}

Json listSchema(Json items, std::size_t count) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", count}, {"maxItems", count}};
}

Json mapSchema(Json member) {
  return {{"type", "object"}, {"additionalProperties", std::move(member)}};
}

void addProperty(Json& schema, std::string_view key, Json property, std::string_view description,
                 bool required) {
  property["description"] = description;
  schema["properties"][std::string(key)] = std::move(property);
  if (required) schema["required"].push_back(key);
}

void addConstant(Json& schema, std::string_view key, std::string_view value) {
  schema["properties"][std::string(key)] = {{"const", value}};
  schema["required"].push_back(key);
}

}  // namespace modeling
