#include "modeling/scene/salvage.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "modeling/scene/scene_file.h"
#include "modeling/text/text_file.h"

namespace modeling {
namespace {

/// A scene with more faults than this is not a scene that was damaged.
constexpr std::size_t kMostFaults = 1000;

/// The end of "FILE:LINE:COLUMN".
std::optional<TextPosition> positionIn(const std::string& place) {
  TextPosition position;
  const auto columnColon = place.rfind(':');
  if (columnColon == std::string::npos || columnColon == 0) return std::nullopt;
  const auto lineColon = place.rfind(':', columnColon - 1);
  if (lineColon == std::string::npos) return std::nullopt;
  const char* const end = place.data() + place.size();
  const bool line = std::from_chars(place.data() + lineColon + 1, end, position.line).ec == std::errc{};
  const bool column = std::from_chars(place.data() + columnColon + 1, end, position.column).ec == std::errc{};
  return line && column ? std::optional(position) : std::nullopt;
}

bool isAfter(const TextPosition& left, const TextPosition& right) {
  return left.line != right.line ? left.line > right.line : left.column > right.column;
}

/// The last of them that begins at or before the position.
template <class Entries>
auto entryAt(Entries& entries, const TextPosition& position) {
  const auto after = std::find_if(entries.begin(), entries.end(),
                                  [&](const auto& entry) { return isAfter(entry.position, position); });
  return after == entries.begin() ? entries.end() : after - 1;
}

/// Takes the smallest whole thing out of a section of the scene that holds the position: an entry of a list
/// or table. False where there is none.
bool removeEntry(JsonValue& section, const TextPosition& position) {
  if (JsonValue::Array* list = section.array()) {
    const auto entry = entryAt(*list, position);
    if (entry == list->end()) return false;
    list->erase(entry);
    return true;
  }
  JsonValue::Object* table = section.object();
  if (table == nullptr) return false;
  const auto entry = entryAt(*table, position);
  if (entry == table->end()) return false;
  // environment.colliders is a list within a section.
  if (entry->value.array() != nullptr && removeEntry(entry->value, position)) return true;
  table->erase(entry);
  return true;
}

bool removeAt(JsonValue& root, const TextPosition& position) {
  JsonValue::Object* sections = root.object();
  if (sections == nullptr) return false;
  const auto section = entryAt(*sections, position);
  if (section == sections->end() || section->key == "smithereens") return false;
  if (removeEntry(section->value, position)) return true;
  if (section->key == "parts") return false;
  sections->erase(section);
  return true;
}

/// Where a text that goes wrong can be ended so that it is JSON: behind the last whole value.
class Ending {
 public:
  explicit Ending(std::string_view text) {
    for (std::size_t i = 0; i < text.size() && !broken_; ++i) read(text[i], i);
  }

  std::string of(std::string_view text) const {
    std::string ended(text.substr(0, cut_));
    ended.append(closers_.rbegin(), closers_.rend());
    return ended;
  }

 private:
  void read(char letter, std::size_t at) {
    if (inText_) {
      if (escaped_) {
        escaped_ = false;
      } else if (letter == '\\') {
        escaped_ = true;
      } else if (letter == '"') {
        inText_ = false;
      }
      return;
    }
    if (letter == '"') inText_ = true;
    if (letter == '{' || letter == '[') open_.push_back(letter == '{' ? '}' : ']');
    if (letter == ',') cutAt(at);
    if (letter != '}' && letter != ']') return;
    broken_ = open_.empty() || open_.back() != letter;
    if (broken_) return;
    open_.pop_back();
    cutAt(at + 1);
  }
  void cutAt(std::size_t at) {
    cut_ = at;
    closers_ = open_;
  }

  std::string open_;     ///< what would close the brackets that are open
  std::string closers_;  ///< of those open at the cut
  std::size_t cut_ = 0;
  bool inText_ = false;
  bool escaped_ = false;
  bool broken_ = false;
};

std::string_view upTo(std::string_view text, const TextPosition& position) {
  std::size_t start = 0;
  for (std::uint32_t line = 1; line < position.line; ++line) {
    const auto end = text.find('\n', start);
    if (end == std::string_view::npos) return text;
    start = end + 1;
  }
  return text.substr(0, std::min(text.size(), start + position.column - 1));
}

/// The document, or as much of it as is JSON.
sim::Result<JsonDocument> readDocument(std::string_view text, const std::string& source,
                                       std::vector<sim::Problem>& faults) {
  sim::Result<JsonDocument> whole = parseJson(text, source);
  if (whole) return whole;
  const std::optional<TextPosition> position = positionIn(whole.problem().place);
  if (!position) return whole;
  const std::string ended = Ending(upTo(text, *position)).of(text);
  sim::Result<JsonDocument> part = parseJson(ended, source);
  if (!part) return whole;
  faults.push_back(whole.problem());
  return part;
}

}  // namespace

sim::Result<SalvagedScene> salvageScene(std::string_view text, const std::string& source) {
  SalvagedScene salvaged;
  sim::Result<JsonDocument> document = readDocument(text, source, salvaged.faults);
  if (!document) return document.problem();
  while (true) {
    sim::Result<SceneFile> file = readScene(*document);
    if (file) {
      salvaged.scene = std::move(file->scene);
      salvaged.notes = std::move(file->notes);
      return salvaged;
    }
    const sim::Problem& fault = file.problem();
    const std::optional<TextPosition> position = positionIn(fault.place);
    if (salvaged.faults.size() == kMostFaults || !position || !removeAt(document->root, *position))
      return salvaged.faults.empty() ? fault : salvaged.faults.front();
    salvaged.faults.push_back(fault);
  }
}

sim::Result<SalvagedScene> salvageScene(const std::filesystem::path& file) {
  const sim::Result<std::string> text = readTextFile(file, kLargestText);
  if (!text) return text.problem();
  return salvageScene(*text, file.string());
}

}  // namespace modeling
