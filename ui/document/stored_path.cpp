#include "ui/document/stored_path.h"

namespace ui {

std::string storedPath(const std::filesystem::path& file, const std::filesystem::path& folder) {
  if (folder.empty()) return file.generic_string();
  const std::filesystem::path relative = file.lexically_relative(folder);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return (below ? relative : file).generic_string();
}

}  // namespace ui
