#include "modeling/import/file_bytes.h"

#include <fstream>

namespace modeling {

sim::Result<std::string> fileBytes(const std::filesystem::path& file) {
  const sim::Problem unreadable{"", "cannot read this file", "look at its name and place"};
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return unreadable;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return unreadable;
  if (size > kLargestMeshFile)
    return sim::Problem{"", "this file is larger than " + std::to_string(kLargestMeshFile >> 20U) + " MB",
                        "use a mesh of fewer faces"};
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!stream || static_cast<std::uintmax_t>(stream.gcount()) != size) return unreadable;
  return bytes;
}

}  // namespace modeling
