#include "modeling/text/text_file.h"

#include <fstream>
#include <system_error>

#include "modeling/files/output_file.h"

namespace modeling {

using sim::Problem;

sim::Result<std::string> readTextFile(const std::filesystem::path& file, std::uintmax_t largest) {
  const std::string place = file.string() + ":1:1";
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) return Problem{place, "there is no such file", "check the path"};
  if (!std::filesystem::is_regular_file(status)) return Problem{place, "this is not a file", "name a file"};
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return Problem{place, "its size cannot be read: " + error.message(), "check its permissions"};
  if (size > largest) {
    return Problem{place, "the file is larger than " + std::to_string(largest >> 20U) + " MB",
                   "make it smaller"};
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text(size, '\0');
  if (!stream.read(text.data(), static_cast<std::streamsize>(size))) {
    return Problem{place, "the file cannot be read", "check its permissions"};
  }
  return text;
}

sim::Status replaceTextFile(const std::filesystem::path& file, std::string_view text) {
  return replaceFile(file, text);
}

}  // namespace modeling
