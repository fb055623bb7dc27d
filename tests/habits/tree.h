#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace habits {

/// A file of the source tree.
struct File {
  std::string path;  ///< relative to the root, with '/'
  std::vector<std::string>
      lines;  ///< none for data: whatever stands under resources/, docs/pictures/ or tests/data/
  bool executable = false;
};

/// What people write, sorted by path. Hidden folders but .ci are not looked into, nor build/ and out/, which
/// git ignores too.
std::vector<File> readTree(const std::filesystem::path& root);

}  // namespace habits
