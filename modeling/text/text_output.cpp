#include "modeling/text/text_output.h"

#include <array>
#include <cctype>
#include <charconv>
#include <system_error>
#include <utility>

namespace modeling {

TextOutput::TextOutput(std::filesystem::path path, int significantDigits)
    : path_(std::move(path)),
      draft_(path_.string() + ".part"),
      file_(std::fopen(draft_.c_str(), "wb")),
      significantDigits_(significantDigits) {
  good_ = file_ != nullptr;
}

TextOutput::~TextOutput() {
  if (!file_) return;
  file_.reset();
  std::error_code ignored;
  std::filesystem::remove(draft_, ignored);
}

TextOutput& TextOutput::operator<<(std::string_view text) {
  good_ = good_ && std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size();
  return *this;
}

TextOutput& TextOutput::operator<<(std::uint64_t number) {
  std::array<char, 24> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return *this << std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

TextOutput& TextOutput::operator<<(double number) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                 std::chars_format::general, significantDigits_)
                       .ptr;
  return *this << std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

TextOutput& TextOutput::operator<<(const sim::Vec3& vector) {
  return *this << vector.x() << " " << vector.y() << " " << vector.z();
}

sim::Status TextOutput::finish() {
  bool written = good_ && std::fflush(file_.get()) == 0;
  std::error_code error;
  if (written) {
    file_.reset();
    std::filesystem::rename(draft_, path_, error);
    if (!error) return sim::Done{};
  }
  return sim::Problem{path_.string(), "cannot write this file",
                      "choose a folder that exists, is yours and has room"};
}

std::string oneWord(std::string name, const char* unnamed) {
  if (name.empty()) return unnamed;
  for (char& letter : name) {
    if (std::isspace(static_cast<unsigned char>(letter)) != 0) letter = '_';
  }
  return name;
}

std::string oneLine(std::string name) {
  for (char& letter : name) {
    if (std::iscntrl(static_cast<unsigned char>(letter)) != 0) letter = ' ';
  }
  return name;
}

}  // namespace modeling
