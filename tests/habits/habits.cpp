#include "tests/habits/habits.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

namespace habits {
namespace {

/// In the order of the arrows. Tests stand behind all rooms.
constexpr std::array<std::string_view, 5> kRooms = {"sim", "modeling", "ui", "app", "tests"};
constexpr std::array<std::string_view, 4> kOtherFolders = {".ci", "docs", "findings", "resources"};
constexpr std::array<std::string_view, 3> kScripts = {".ci/run", "app/run", "tests/run"};
/// The folders of a room form a ladder: each may include those that stand before it here.
struct Ladder {
  std::string_view room;
  std::string_view folders;
};
constexpr std::array<Ladder, 3> kLadders = {
    {{"sim",
      "base collider network state surface kernel fracture fragments contact control world skipping passes "
      "methods "
      "dynamics take"},
     {"modeling", "text shapes material glue assembly import scene preflight calibration run exchange"},
     {"ui", "theme plot picture document kinds session viewport timeline panels editors files window"}}};
// In two halves, so that this file does not hold the words it looks for.
constexpr std::array<std::string_view, 4> kNotes = {
    "TO"
    "DO",
    "FIX"
    "ME",
    "XX"
    "X",
    "HA"
    "CK"};

/// A library's headers begin with the prefix and are included from firstRoom on.
struct Library {
  std::string_view prefix;
  std::string_view name;
  std::string_view firstRoom;
};
constexpr std::array<Library, 10> kLibraries = {{{"Qt", "Qt", "ui"},
                                                 {"GL/", "OpenGL", "ui"},
                                                 {"embree", "Embree", "ui"},
                                                 {"png.h", "libpng", "ui"},
                                                 {"Imf", "OpenEXR", "ui"},
                                                 {"nlohmann/", "nlohmann-json", "modeling"},
                                                 {"assimp/", "assimp", "modeling"},
                                                 {"CLI/", "CLI11", "app"},
                                                 {"benchmark/", "Google Benchmark", "tests"},
                                                 {"catch2/", "Catch2", "tests"}}};

using Offences = std::vector<Offence>;

template <class Range>
bool contains(const Range& range, std::string_view wanted) {
  return std::find(range.begin(), range.end(), wanted) != range.end();
}

std::string topFolder(const std::string& path) {
  const auto slash = path.find('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

std::optional<std::ptrdiff_t> rank(std::string_view room) {
  const auto* const found = std::find(kRooms.begin(), kRooms.end(), room);
  if (found == kRooms.end()) return std::nullopt;
  return found - kRooms.begin();
}

bool isSource(const File& file) {
  return file.path.ends_with(".cpp");
}
bool isHeader(const File& file) {
  return file.path.ends_with(".h");
}
bool isMakefile(const File& file) {
  return file.path.ends_with("CMakeLists.txt") || file.path.ends_with(".cmake");
}
bool isLetter(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0;
}

bool holdsWord(std::string_view line, std::string_view word) {
  for (auto at = line.find(word); at != std::string_view::npos; at = line.find(word, at + 1)) {
    const auto behind = at + word.size();
    if ((at == 0 || !isLetter(line[at - 1])) && (behind == line.size() || !isLetter(line[behind])))
      return true;
  }
  return false;
}

/// The folder below the top one: "contact" of "sim/contact/contacts.h"; "" where there is none.
std::string_view secondFolder(std::string_view path) {
  const auto first = path.find('/');
  const auto second = first == std::string_view::npos ? first : path.find('/', first + 1);
  return second == std::string_view::npos ? "" : path.substr(first + 1, second - first - 1);
}

/// Place of a word in a list of words; nothing where it is not there.
std::optional<std::size_t> placeIn(std::string_view words, std::string_view wanted) {
  std::size_t place = 0;
  while (!words.empty()) {
    const auto end = std::min(words.find(' '), words.size());
    if (words.substr(0, end) == wanted) return place;
    words.remove_prefix(std::min(end + 1, words.size()));
    ++place;
  }
  return std::nullopt;
}

/// A capital P or B and a number of one or two digits, as a word.
bool holdsCode(std::string_view line) {
  const auto isDigit = [&](std::size_t at) {
    return at < line.size() && std::isdigit(static_cast<unsigned char>(line[at])) != 0;
  };
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] != 'P' && line[at] != 'B') continue;
    if (at > 0 && (isLetter(line[at - 1]) || line[at - 1] == '_')) continue;
    if (!isDigit(at + 1)) continue;
    const std::size_t end = isDigit(at + 2) ? at + 3 : at + 2;
    if (end == line.size() || (!isLetter(line[end]) && line[end] != '_')) return true;
  }
  return false;
}

/// What stands between the quotes or brackets of an #include, or nothing.
std::optional<std::string> includedPath(const std::string& line) {
  const auto hash = line.find_first_not_of(" \t");
  if (hash == std::string::npos || line[hash] != '#') return std::nullopt;
  const auto word = line.find_first_not_of(" \t", hash + 1);
  if (word == std::string::npos || line.compare(word, 7, "include") != 0) return std::nullopt;
  const auto open = line.find_first_of("\"<", word);
  const auto close = line.find_first_of("\">", open == std::string::npos ? open : open + 1);
  if (close == std::string::npos) return std::nullopt;
  return line.substr(open + 1, close - open - 1);
}

/// Calls visit(file, line, room of the file, included path) for every #include in a room.
template <class Visit>
void forEachInclude(const std::vector<File>& tree, Visit visit) {
  for (const File& file : tree) {
    const auto room = rank(topFolder(file.path));
    if (!room || (!isSource(file) && !isHeader(file))) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      if (const auto included = includedPath(file.lines[i])) visit(file, i + 1, *room, *included);
    }
  }
}

/// Qt's headers are also named after its classes: Q and a capital.
bool isOf(const Library& library, std::string_view header) {
  const bool namedAsClass =
      header.size() > 1 && header[0] == 'Q' && std::isupper(static_cast<unsigned char>(header[1])) != 0;
  return header.starts_with(library.prefix) || (library.name == "Qt" && namedAsClass);
}

/// The source's path as the CMakeLists.txt of its top-level folder names it.
bool isListed(const File& source, const std::vector<File>& tree) {
  const std::string folder = topFolder(source.path);
  const std::string listedAs = source.path.substr(folder.size() + 1);
  return std::any_of(tree.begin(), tree.end(), [&](const File& file) {
    return isMakefile(file) && topFolder(file.path) == folder &&
           std::any_of(file.lines.begin(), file.lines.end(),
                       [&](const std::string& line) { return holdsWord(line, listedAs); });
  });
}

}  // namespace

std::string Offence::text() const {
  std::string place = file;
  if (line > 0) place.append(":").append(std::to_string(line));
  return place.append(": ").append(what);
}

Offences strayFolders(const std::vector<File>& tree) {
  Offences offences;
  for (const File& file : tree) {
    const std::string folder = topFolder(file.path);
    if (folder.empty() || rank(folder) || contains(kOtherFolders, folder)) continue;
    offences.push_back({file.path, 0, folder + "/ is no folder of the architecture"});
  }
  return offences;
}

Offences includesAgainstTheArrows(const std::vector<File>& tree) {
  Offences offences;
  forEachInclude(
      tree, [&](const File& file, std::size_t line, std::ptrdiff_t room, const std::string& included) {
        const auto other = rank(topFolder(included));
        if (other && *other > room) {
          offences.push_back({file.path, line, "includes " + included + " against the arrows"});
        } else if (included.starts_with(".")) {
          offences.push_back({file.path, line, "includes " + included + ", not by its path from the root"});
        }
      });
  return offences;
}

Offences includesAgainstTheLadder(const std::vector<File>& tree) {
  Offences offences;
  forEachInclude(tree, [&](const File& file, std::size_t line, std::ptrdiff_t, const std::string& included) {
    for (const Ladder& ladder : kLadders) {
      if (topFolder(file.path) != ladder.room || topFolder(included) != ladder.room) continue;
      const auto from = placeIn(ladder.folders, secondFolder(file.path));
      const auto to = placeIn(ladder.folders, secondFolder(included));
      if (from && to && *to > *from)
        offences.push_back({file.path, line, "includes " + included + " up the ladder"});
    }
  });
  for (const File& file : tree) {
    if (!isSource(file) && !isHeader(file)) continue;
    for (const Ladder& ladder : kLadders) {
      if (topFolder(file.path) == ladder.room && !placeIn(ladder.folders, secondFolder(file.path)))
        offences.push_back({file.path, 0, "stands in a folder that is on no ladder"});
    }
  }
  return offences;
}

Offences codesForRules(const std::vector<File>& tree) {
  Offences offences;
  for (const File& file : tree) {
    if (!isSource(file) && !isHeader(file) && !file.path.ends_with(".md")) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      if (holdsCode(file.lines[i]))
        offences.push_back({file.path, i + 1, "cites a rule by a code, not by its name"});
    }
  }
  return offences;
}

Offences librariesInTheWrongRoom(const std::vector<File>& tree) {
  Offences offences;
  forEachInclude(
      tree, [&](const File& file, std::size_t line, std::ptrdiff_t room, const std::string& included) {
        for (const Library& library : kLibraries) {
          if (!isOf(library, included) || room >= *rank(library.firstRoom)) continue;
          offences.push_back(
              {file.path, line,
               "uses " + std::string(library.name) + " before " + std::string(library.firstRoom) + "/"});
        }
      });
  return offences;
}

Offences parallelLoopsOfTheirOwn(const std::vector<File>& tree) {
  Offences offences;
  forEachInclude(tree, [&](const File& file, std::size_t line, std::ptrdiff_t, const std::string& included) {
    if (included.starts_with("tbb/parallel_") && file.path != "sim/base/parallel.h")
      offences.push_back({file.path, line, "runs loops by " + included + ", not by sim/base/parallel.h"});
  });
  return offences;
}

Offences notesToSelf(const std::vector<File>& tree) {
  Offences offences;
  for (const File& file : tree) {
    // In a compressed picture any three letters turn up.
    if (file.path.ends_with(".png")) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      for (const std::string_view note : kNotes) {
        if (holdsWord(file.lines[i], note)) {
          offences.push_back({file.path, i + 1, "says " + std::string(note)});
        }
      }
    }
  }
  return offences;
}

Offences longFiles(const std::vector<File>& tree, std::size_t mostLines) {
  Offences offences;
  for (const File& file : tree) {
    const bool counts = rank(topFolder(file.path)) || isMakefile(file);
    if (!counts || file.lines.size() <= mostLines) continue;
    offences.push_back(
        {file.path, 0,
         "has " + std::to_string(file.lines.size()) + " lines, more than " + std::to_string(mostLines)});
  }
  return offences;
}

Offences scriptsThatDoNotRun(const std::vector<File>& tree) {
  Offences offences;
  for (const std::string_view script : kScripts) {
    const bool found =
        std::any_of(tree.begin(), tree.end(), [&](const File& file) { return file.path == script; });
    if (!found) offences.push_back({std::string(script), 0, "is missing"});
  }
  for (const File& file : tree) {
    const bool isFinding = topFolder(file.path) == "findings" && file.path.ends_with(".sh");
    const bool isScript = isFinding || contains(kScripts, file.path) ||
                          (!file.lines.empty() && file.lines.front().starts_with("#!"));
    if (isScript && !file.executable)
      offences.push_back({file.path, 0, "is a script that may not be executed"});
  }
  return offences;
}

Offences headersWithoutGuard(const std::vector<File>& tree) {
  Offences offences;
  for (const File& file : tree) {
    if (isHeader(file) && (file.lines.empty() || file.lines.front() != "#pragma once")) {
      offences.push_back({file.path, 0, "does not begin with #pragma once"});
    }
  }
  return offences;
}

Offences sourcesNobodyBuilds(const std::vector<File>& tree) {
  Offences offences;
  for (const File& file : tree) {
    if (isSource(file) && !isListed(file, tree)) {
      offences.push_back({file.path, 0, "stands in no CMakeLists.txt of its folder"});
    }
  }
  return offences;
}

}  // namespace habits
