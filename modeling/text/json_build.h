#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

/// Pieces of JSON, put together in one source: each use of the JSON library costs the compiler dear, and
/// codecs would use it for every field of every struct.
namespace modeling {

using Json = nlohmann::ordered_json;

/// Takes the place of a member of that key, or is added behind the last.
void setMember(Json& object, std::string_view key, Json value);
void append(Json& list, Json value);

/// {"type": type}
Json typeSchema(std::string_view type);
/// One of these texts.
Json choiceSchema(const std::vector<std::string>& choices);
/// Any of these.
Json anyOfSchema(Json one, Json other);
Json nullableSchema(Json schema);
Json listSchema(Json items);
/// A list of so many.
Json listSchema(Json items, std::size_t count);
/// An object with any keys.
Json mapSchema(Json member);
/// Adds a key to the schema of an object.
void addProperty(Json& schema, std::string_view key, Json property, std::string_view description,
                 bool required);
/// Adds a key that must be there and have this value.
void addConstant(Json& schema, std::string_view key, std::string_view value);

}  // namespace modeling
