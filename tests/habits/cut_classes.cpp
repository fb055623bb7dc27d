#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "tests/habits/habits.h"

namespace habits {
namespace {

bool isOfName(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

bool beginsWithCapital(std::string_view name) {
  return !name.empty() && std::isupper(static_cast<unsigned char>(name.front())) != 0;
}

std::string roomOf(const std::string& path) {
  return path.substr(0, path.find('/'));
}

/// The name that begins at `at`, with its parts joined by ::, as in Outer::Inner::function.
std::string_view qualifiedName(std::string_view line, std::size_t at) {
  std::size_t end = at;
  while (end < line.size() && (isOfName(line[end]) || line[end] == '~' || line[end] == ':')) ++end;
  return line.substr(at, end - at);
}

/// The class of which the line begins to define a member function; nothing of any other line. Sources are
/// formatted, so that such a definition begins at the left edge, and what ends with a semicolon is none.
std::optional<std::string> classDefinedIn(std::string_view line) {
  if (line.empty() || !(isOfName(line.front()) || line.front() == ':')) return std::nullopt;
  if (line.ends_with(";")) return std::nullopt;
  const auto open = line.find('(');
  if (open == std::string_view::npos || line.substr(0, open).find('=') != std::string_view::npos)
    return std::nullopt;
  std::size_t start = open;
  while (start > 0 && (isOfName(line[start - 1]) || line[start - 1] == ':' || line[start - 1] == '~'))
    --start;
  const std::string_view name = qualifiedName(line, start);
  const auto colons = name.rfind("::");
  if (colons == std::string_view::npos || colons == 0) return std::nullopt;
  std::string_view owner = name.substr(0, colons);
  // The namespace, where it is written out, is in small letters.
  while (!beginsWithCapital(owner)) {
    const auto next = owner.find("::");
    if (next == std::string_view::npos) return std::nullopt;
    owner.remove_prefix(next + 2);
  }
  return std::string(owner);
}

/// The class or struct that the line of a header declares, whether or not it goes on there.
std::optional<std::string> classDeclaredIn(std::string_view line) {
  const auto first = line.find_first_not_of(' ');
  if (first == std::string_view::npos) return std::nullopt;
  line.remove_prefix(first);
  for (const std::string_view keyword : {"class ", "struct "}) {
    if (line.starts_with(keyword)) return std::string(qualifiedName(line, keyword.size()));
  }
  return std::nullopt;
}

}  // namespace

std::vector<Offence> cutClasses(const std::vector<File>& tree) {
  // Both by room, since a name may mean another class in another one.
  std::set<std::string> declared;
  std::map<std::string, std::set<std::string>> sources;
  for (const File& file : tree) {
    if (!file.path.ends_with(".h")) continue;
    for (const std::string& line : file.lines) {
      if (const auto name = classDeclaredIn(line)) declared.insert(roomOf(file.path) + " " + *name);
    }
  }
  for (const File& file : tree) {
    if (!file.path.ends_with(".cpp")) continue;
    for (const std::string& line : file.lines) {
      const auto name = classDefinedIn(line);
      if (!name) continue;
      const std::string innermost =
          name->substr(name->rfind(':') == std::string::npos ? 0 : name->rfind(':') + 1);
      if (declared.contains(roomOf(file.path) + " " + innermost))
        sources[roomOf(file.path) + " " + *name].insert(file.path);
    }
  }
  std::vector<Offence> offences;
  for (const auto& [name, files] : sources) {
    if (files.size() < 2) continue;
    std::string list;
    for (const std::string& file : files) list += (list.empty() ? "" : ", ") + file;
    offences.push_back({*files.begin(), 0, "shares class " + name.substr(name.find(' ') + 1) + ": " + list});
  }
  return offences;
}

}  // namespace habits
