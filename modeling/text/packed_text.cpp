#include "modeling/text/packed_text.h"

#include <algorithm>
#include <array>
#include <utility>

#include <zlib.h>

#include "modeling/text/text_file.h"

namespace modeling {

namespace {

constexpr std::size_t kChunk = 1U << 16U;
constexpr std::string_view kGzip = "\x1f\x8b";

}  // namespace

void PackedText::Close::operator()(gzFile_s* file) const {
  gzclose(file);
}

PackedText::PackedText(const std::filesystem::path& file) : file_(gzopen(file.c_str(), "rb")) {}

/// False at the end of the file.
bool PackedText::fill() {
  buffer_.resize(kChunk);
  at_ = 0;
  const int got = gzread(file_.get(), buffer_.data(), static_cast<unsigned>(kChunk));
  int error = Z_OK;
  gzerror(file_.get(), &error);
  damaged_ = got < 0 || (error != Z_OK && error != Z_STREAM_END);
  buffer_.resize(static_cast<std::size_t>(std::max(got, 0)));
  return !buffer_.empty();
}

PackedText::Line PackedText::next(std::string& line, std::size_t longest) {
  line.clear();
  bool any = false;
  while (true) {
    if (at_ == buffer_.size() && (damaged_ || !fill())) {
      if (damaged_) return Line::damaged;
      return any ? Line::read : Line::end;
    }
    any = true;
    const std::size_t end = std::min(buffer_.find('\n', at_), buffer_.size());
    if (line.size() + (end - at_) > longest) return Line::tooLong;
    line.append(buffer_, at_, end - at_);
    at_ = std::min(end + 1, buffer_.size());
    if (end < buffer_.size()) return Line::read;
  }
}

sim::Result<std::string> readPackedTextFile(const std::filesystem::path& file, std::uintmax_t largest) {
  sim::Result<std::string> bytes = readTextFile(file, largest);
  if (!bytes) return bytes;
  const std::string place = file.string() + ":1:1";
  if (const std::string_view packer = unknownPacker(*bytes); !packer.empty())
    return sim::Problem{place, "this file is packed by " + std::string(packer),
                        "unpack it, or pack it by gzip"};
  if (!bytes->starts_with(kGzip)) return bytes;
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> packed(gzopen(file.c_str(), "rb"), gzclose);
  std::string text;
  std::array<char, kChunk> chunk{};
  while (packed) {
    const int got = gzread(packed.get(), chunk.data(), static_cast<unsigned>(chunk.size()));
    int error = Z_OK;
    gzerror(packed.get(), &error);
    if (got < 0 || (error != Z_OK && error != Z_STREAM_END)) break;
    if (got == 0) return text;
    text.append(chunk.data(), static_cast<std::size_t>(got));
    if (text.size() > largest)
      return sim::Problem{place, "there are more than " + std::to_string(largest >> 20U) + " MB in this file",
                          "make it smaller"};
  }
  return sim::Problem{place, "what is packed in this file is damaged or cut off", "pack it anew"};
}

std::string_view unknownPacker(std::string_view beginning) {
  using namespace std::string_view_literals;
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kPackers{
      {{"BZh"sv, "bzip2"sv},
       {"\xfd"
        "7zXZ"sv,
        "xz"sv},
       {"\x28\xb5\x2f\xfd"sv, "zstd"sv},
       {"PK\x03\x04"sv, "zip"sv}}};
  for (const auto& [start, name] : kPackers) {
    if (beginning.starts_with(start)) return name;
  }
  return "";
}

}  // namespace modeling
