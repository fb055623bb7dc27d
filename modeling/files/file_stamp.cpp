#include "modeling/files/file_stamp.h"

#include <fstream>
#include <iterator>
#include <utility>

#include "sim/base/text_hash.h"

namespace modeling {

FileStamp FileStamp::ofText(std::string_view text) {
  return fromText(sim::textHash(text));
}

FileStamp FileStamp::fromText(std::string text) {
  FileStamp stamp;
  stamp.hash_ = std::move(text);
  return stamp;
}

FileStamp FileStamp::of(const std::filesystem::path& file) {
  std::error_code error;
  // A pipe of that name would be waited for.
  if (!std::filesystem::is_regular_file(file, error)) return {};
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {};
  return ofText(std::string(std::istreambuf_iterator<char>(stream), {}));
}

FileChange FileStamp::changeOf(const std::filesystem::path& file) const {
  const FileStamp now = of(file);
  if (now == *this) return FileChange::none;
  return now.hash_.empty() ? FileChange::gone : FileChange::changed;
}

}  // namespace modeling
