#pragma once

#include <filesystem>
#include <string>

namespace ui {

/// The path of a file as a scene keeps it: relative where the file lies beside or below the scene, whose
/// folder is empty while it has none.
std::string storedPath(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace ui
