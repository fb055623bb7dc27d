#include "ui/picture/image.h"

#include <algorithm>
#include <cassert>
#include <csetjmp>
#include <cstdio>

#include <png.h>

#include "modeling/files/output_file.h"
#include "sim/base/random.h"

namespace ui {

namespace {

constexpr std::uint64_t kDitherSeed = 0xd17e;

struct PngWriter {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  PngWriter() = default;
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

std::vector<std::uint8_t> toBigEndian(const Image& image) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.samples.size() * 2);
  for (const std::uint16_t sample : image.samples) {
    bytes.push_back(static_cast<std::uint8_t>(sample >> 8U));
    bytes.push_back(static_cast<std::uint8_t>(sample & 0xffU));
  }
  return bytes;
}

/// libpng reports errors by longjmp: nothing with a destructor may be made in here.
bool encode(const PngWriter& writer, std::FILE* file, const Image& image, int bits,
            const std::uint8_t* bytes) {
  if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
  png_init_io(writer.png, file);
  const auto width = static_cast<png_uint_32>(image.width);
  const auto height = static_cast<png_uint_32>(image.height);
  png_set_IHDR(writer.png, writer.info, width, height, bits, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(writer.png, writer.info);
  const std::size_t rowBytes = static_cast<std::size_t>(width) * 3 * static_cast<std::size_t>(bits) / 8;
  for (png_uint_32 row = 0; row < height; ++row) png_write_row(writer.png, bytes + row * rowBytes);
  png_write_end(writer.png, writer.info);
  return true;
}

}  // namespace

std::vector<std::uint8_t> toEightBit(const Image& image) {
  std::vector<std::uint8_t> bytes(image.samples.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const double level = image.samples[i] * (255.0 / 65535.0);
    const double dithered = level + sim::uniformAt(kDitherSeed, i);
    bytes[i] = static_cast<std::uint8_t>(std::clamp(dithered, 0.0, 255.0));
  }
  return bytes;
}

sim::Status writePng(const std::filesystem::path& path, const Image& image, PngDepth depth) {
  assert(image.samples.size() ==
         3U * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  auto file = modeling::OutputFile::create(path);
  if (!file) return file.problem();
  const std::vector<std::uint8_t> bytes =
      depth == PngDepth::eightBit ? toEightBit(image) : toBigEndian(image);
  const PngWriter writer;
  const bool written = writer.info != nullptr && encode(writer, file->stream(), image,
                                                        depth == PngDepth::eightBit ? 8 : 16, bytes.data());
  if (written) return file->finish();
  return sim::Problem{path.string(), "cannot write this picture",
                      "choose a folder that exists, is yours and has room"};
}

}  // namespace ui
