#include <cstdio>
#include <cstring>
#include <filesystem>

#include <catch2/catch.hpp>
#include <png.h>

#include "sim/base/random.h"
#include "ui/picture/image.h"

namespace {

using ui::Image;

Image noisyImage() {
  Image image{.width = 37, .height = 23, .samples = {}};
  for (std::size_t i = 0; i < 3U * 37U * 23U; ++i) {
    image.samples.push_back(static_cast<std::uint16_t>(sim::uniformAt(7, i) * 65536.0));
  }
  return image;
}

std::filesystem::path temporaryPng(const char* name) {
  return std::filesystem::temp_directory_path() / name;
}

std::vector<std::uint8_t> readEightBit(const std::filesystem::path& path) {
  png_image reader;
  std::memset(&reader, 0, sizeof reader);
  reader.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&reader, path.c_str()) != 0);
  CHECK(reader.width == 37);
  CHECK(reader.height == 23);
  reader.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(reader));
  REQUIRE(png_image_finish_read(&reader, nullptr, bytes.data(), 0, nullptr) != 0);
  return bytes;
}

std::vector<std::uint16_t> readSixteenBit(const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  REQUIRE(file != nullptr);
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  CHECK(png_get_bit_depth(png, info) == 16);
  std::vector<std::uint16_t> samples;
  png_bytepp rows = png_get_rows(png, info);
  for (png_uint_32 y = 0; y < png_get_image_height(png, info); ++y) {
    for (std::size_t i = 0; i < 3U * png_get_image_width(png, info); ++i) {
      samples.push_back(static_cast<std::uint16_t>(rows[y][2 * i] << 8U | rows[y][2 * i + 1]));
    }
  }
  png_destroy_read_struct(&png, &info, nullptr);
  std::fclose(file);
  return samples;
}

TEST_CASE("a 16-bit PNG reads back to the same samples") {
  const auto path = temporaryPng("smithereens-test-16.png");
  REQUIRE(ui::writePng(path, noisyImage(), ui::PngDepth::sixteenBit).ok());
  CHECK(readSixteenBit(path) == noisyImage().samples);
  std::filesystem::remove(path);
}

TEST_CASE("an 8-bit PNG reads back to the bytes it was made of") {
  const auto path = temporaryPng("smithereens-test-8.png");
  REQUIRE(ui::writePng(path, noisyImage()).ok());
  CHECK(readEightBit(path) == ui::toEightBit(noisyImage()));
  std::filesystem::remove(path);
}

TEST_CASE("eight bits are the nearest levels, whose mean is right") {
  Image grey{.width = 100, .height = 100, .samples = std::vector<std::uint16_t>(30000, 25700 + 64)};
  double sum = 0.0;
  for (const std::uint8_t byte : ui::toEightBit(grey)) {
    CHECK((byte == 100 || byte == 101));
    sum += byte;
  }
  // The level is 100.249; the mean of 30000 draws of one bit has a deviation of 0.0025.
  CHECK(sum / 30000.0 == Approx(100.249).margin(0.0125));
}

TEST_CASE("a folder that does not exist is a problem that names the file, and leaves nothing") {
  const auto path = std::filesystem::temp_directory_path() / "smithereens-no-such-folder" / "a.png";
  const auto status = ui::writePng(path, noisyImage());
  REQUIRE_FALSE(status.ok());
  CHECK(status.problem().place == path.string());
}

}  // namespace
