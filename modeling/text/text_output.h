#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "modeling/files/output_file.h"
#include "sim/base/result.h"
#include "sim/base/types.h"

namespace modeling {

/// A text file that appears whole or not at all (modeling/files/output_file.h).
class TextOutput {
 public:
  /// Numbers are written with so many significant digits: 17 read back to the same number.
  explicit TextOutput(const std::filesystem::path& path, int significantDigits = 17);

  TextOutput& operator<<(std::string_view text);
  TextOutput& operator<<(std::uint64_t number);
  TextOutput& operator<<(double number);
  /// Three numbers, separated by spaces.
  TextOutput& operator<<(const sim::Vec3& vector);

  bool good() const { return good_; }
  /// A Problem that names the file when anything could not be written.
  sim::Status finish();

 private:
  sim::Result<OutputFile> file_;
  int significantDigits_;
  bool good_;
};

/// The name with white space turned to '_', as formats of blank-separated words need it; `unnamed` for an
/// empty one.
std::string oneWord(std::string name, const char* unnamed);

/// The name with what would end a line turned to blanks, for comments.
std::string oneLine(std::string name);

}  // namespace modeling
