#include "tests/habits/tree.h"

#include <algorithm>
#include <fstream>

namespace habits {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> linesOf(const fs::path& path) {
  std::vector<std::string> lines;
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool isLookedInto(const std::string& topFolder) {
  if (topFolder == "build" || topFolder == "out") return false;
  return !topFolder.starts_with('.') || topFolder == ".ci";
}

bool isData(const std::string& path) {
  return path.starts_with("resources/") || path.starts_with("docs/pictures/") ||
         path.starts_with("tests/data/");
}

}  // namespace

std::vector<File> readTree(const fs::path& root) {
  std::vector<File> tree;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator();
       ++entry) {
    const std::string path = entry->path().lexically_relative(root).generic_string();
    if (entry->is_directory()) {
      if (entry.depth() == 0 && !isLookedInto(path)) entry.disable_recursion_pending();
      continue;
    }
    File& file = tree.emplace_back();
    file.path = path;
    if (!isData(path)) file.lines = linesOf(entry->path());
    file.executable = (entry->status().permissions() & fs::perms::owner_exec) != fs::perms::none;
  }
  std::sort(tree.begin(), tree.end(), [](const File& a, const File& b) { return a.path < b.path; });
  return tree;
}

}  // namespace habits
