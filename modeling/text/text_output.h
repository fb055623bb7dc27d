#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "sim/base/result.h"
#include "sim/base/types.h"

namespace modeling {

/// A text file that appears whole or not at all: written under another name, renamed by finish().
class TextOutput {
 public:
  /// Numbers are written with so many significant digits: 17 read back to the same number.
  explicit TextOutput(std::filesystem::path path, int significantDigits = 17);
  /// Unfinished: leaves nothing.
  ~TextOutput();
  TextOutput(const TextOutput&) = delete;
  TextOutput& operator=(const TextOutput&) = delete;

  TextOutput& operator<<(std::string_view text);
  TextOutput& operator<<(std::uint64_t number);
  TextOutput& operator<<(double number);
  /// Three numbers, separated by spaces.
  TextOutput& operator<<(const sim::Vec3& vector);

  bool good() const { return good_; }
  /// A Problem that names the file when anything could not be written.
  sim::Status finish();

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::filesystem::path draft_;
  std::unique_ptr<std::FILE, CloseFile> file_;
  int significantDigits_;
  bool good_ = false;
};

/// The name with white space turned to '_', as formats of blank-separated words need it; `unnamed` for an
/// empty one.
std::string oneWord(std::string name, const char* unnamed);

/// The name with what would end a line turned to blanks, for comments.
std::string oneLine(std::string name);

}  // namespace modeling
