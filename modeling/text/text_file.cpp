#include "modeling/text/text_file.h"

#include <fstream>
#include <system_error>

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

namespace {

std::filesystem::path draftOf(std::filesystem::path file) {
  return file += ".new";
}

sim::Status discard(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::remove(draftOf(file), ignored);
  return Problem{file.string(), "this file cannot be written",
                 "check the folder, its permissions and free space"};
}

}  // namespace

sim::Status replaceTextFile(const std::filesystem::path& file, std::string_view text) {
  std::ofstream stream(draftOf(file), std::ios::binary);
  stream << text;
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(draftOf(file), file, error);
  return stream && !error ? sim::Status(sim::Done{}) : discard(file);
}

sim::Status checkReplaceable(const std::filesystem::path& file) {
  std::error_code error;
  const bool good = !std::filesystem::is_directory(file, error) && std::ofstream(draftOf(file)).good();
  const sim::Status discarded = discard(file);
  return good ? sim::Status(sim::Done{}) : discarded;
}

}  // namespace modeling
