#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "modeling/text/json_document.h"

/// Paths such as parts[2].worldFromPart.position[0]. A list's entries can be named by their "name" too:
/// parts.body.hold; an object's by their number: materials[0].
namespace modeling {

/// The steps of a path: keys, names and numbers. Empty when the path is badly formed.
std::vector<std::string> splitPath(std::string_view path);

/// The value the path leads to, or the deepest one on the way.
const JsonValue& deepestValue(const JsonValue& root, std::string_view path);

/// Lays "PATH=VALUE" over the document. VALUE is JSON, or a text without quotation marks. Objects that were
/// left out are added; whether their keys mean something is found when the document is read. A Problem names
/// the nearest entry of a list or table that has no such entry.
sim::Status applySetting(JsonDocument& document, const std::string& setting);

}  // namespace modeling
