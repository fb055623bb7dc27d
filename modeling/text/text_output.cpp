#include "modeling/text/text_output.h"

#include <array>
#include <cctype>
#include <charconv>

namespace modeling {

TextOutput::TextOutput(const std::filesystem::path& path, int significantDigits)
    : file_(OutputFile::create(path)), significantDigits_(significantDigits), good_(file_.ok()) {}

TextOutput& TextOutput::operator<<(std::string_view text) {
  good_ = good_ && std::fwrite(text.data(), 1, text.size(), file_->stream()) == text.size();
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
  if (!file_) return file_.problem();
  return file_->finish();
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
