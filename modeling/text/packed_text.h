#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "sim/base/result.h"

struct gzFile_s;

namespace modeling {

/// A text file, packed by gzip or not, which is told by its first bytes, read line by line from its start.
class PackedText {
 public:
  enum class Line : std::uint8_t { read, end, tooLong, damaged };

  explicit PackedText(const std::filesystem::path& file);

  bool isOpen() const { return file_ != nullptr; }
  /// The next line without its end. `tooLong`: it has more than `longest` letters, and is not read to its
  /// end; `damaged`: what is packed cannot be unpacked any further.
  Line next(std::string& line, std::size_t longest);

 private:
  struct Close {
    void operator()(gzFile_s* file) const;
  };
  bool fill();

  std::unique_ptr<gzFile_s, Close> file_;
  std::string buffer_;
  std::size_t at_ = 0;
  bool damaged_ = false;
};

/// The whole text of such a file of at most `largest` bytes, packed and unpacked. Places are FILE:1:1.
sim::Result<std::string> readPackedTextFile(const std::filesystem::path& file, std::uintmax_t largest);

/// The program that packed a file which begins with these bytes, where that is none we unpack; else "".
std::string_view unknownPacker(std::string_view beginning);

}  // namespace modeling
