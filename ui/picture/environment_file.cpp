#include "ui/picture/environment_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>

#include <png.h>

// Of the many formats it knows, only Radiance's is let in.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_HDR
#define STBI_MAX_DIMENSIONS 8192
#include <stb/stb_image.h>

#include "ui/picture/exr_file.h"

namespace ui {

namespace {

/// Brighter than the sun's disc in any image of the sky, and far from what floats overflow at.
constexpr float kBrightest = 1e6F;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

float cleaned(float value) {
  return value > 0.0F ? std::min(value, kBrightest) : 0.0F;  // what is no number is not above zero
}

sim::Problem damaged(const std::string& kind) {
  return {"", "this " + kind + " is damaged or cut off", "open it in an image editor and save it again"};
}

std::optional<sim::Problem> wrongSize(std::int64_t width, std::int64_t height) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  if (width < 2 || height < 1 || width != 2 * height) {
    return sim::Problem{"", "an image of " + size + " is no picture of all around",
                        "give one by longitude and latitude, twice as wide as high"};
  }
  if (width > kLargestEnvironmentSide || width * height > kMostEnvironmentPixels) {
    return sim::Problem{"", "an image of " + size + " is too large", "scale it to 4096 x 2048 or less"};
  }
  return std::nullopt;
}

EnvironmentImage blank(std::int64_t width, std::int64_t height) {
  EnvironmentImage image{static_cast<int>(width), static_cast<int>(height), {}};
  image.pixels.resize(static_cast<std::size_t>(width * height));
  return image;
}

sim::Result<EnvironmentImage> readExr(const std::filesystem::path& path) {
  EnvironmentImage image;
  auto pixel = image.pixels.begin();
  const auto start = [&](std::int64_t width, std::int64_t height) {
    auto problem = wrongSize(width, height);
    if (!problem) image = blank(width, height);
    pixel = image.pixels.begin();
    return problem;
  };
  const auto row = [&](const std::vector<Light>& lights) {
    for (const Light& light : lights) *pixel++ = {cleaned(light[0]), cleaned(light[1]), cleaned(light[2])};
  };
  if (auto status = readExrColours(path, {start, row}); !status) return status.problem();
  return image;
}

/// What stb_image reads from; it takes zeros where there is nothing more.
struct HdrSource {
  std::FILE* file;
  bool ranOut = false;

  static int read(void* user, char* data, int size) {
    auto& source = *static_cast<HdrSource*>(user);
    const auto got = std::fread(data, 1, static_cast<std::size_t>(size), source.file);
    if (got == 0) source.ranOut = true;
    return static_cast<int>(got);
  }
  static void skip(void* user, int count) {
    std::fseek(static_cast<HdrSource*>(user)->file, count, SEEK_CUR);
  }
  static int atEnd(void* user) { return std::feof(static_cast<HdrSource*>(user)->file); }
};

sim::Result<EnvironmentImage> readHdr(std::FILE* file) {
  const stbi_io_callbacks calls{HdrSource::read, HdrSource::skip, HdrSource::atEnd};
  HdrSource source{file};
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_callbacks(&calls, &source, &width, &height, &channels) == 0)
    return damaged("Radiance image");
  if (auto problem = wrongSize(width, height)) return *problem;
  std::rewind(file);
  source.ranOut = false;
  const std::unique_ptr<float, void (*)(void*)> numbers(
      stbi_loadf_from_callbacks(&calls, &source, &width, &height, &channels, 3), stbi_image_free);
  if (!numbers || source.ranOut) return damaged("Radiance image");
  EnvironmentImage image = blank(width, height);
  const float* number = numbers.get();
  for (Light& pixel : image.pixels) {
    for (int channel = 0; channel < 3; ++channel) pixel[channel] = cleaned(*number++);
  }
  return image;
}

sim::Result<EnvironmentImage> readPng(std::FILE* file) {
  struct Reader {
    png_image image{};
    ~Reader() { png_image_free(&image); }
  } png;
  png.image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_stdio(&png.image, file) == 0) return damaged("PNG");
  if (auto problem = wrongSize(png.image.width, png.image.height)) return *problem;
  // As sRGB, whose curve is undone below: libpng takes a power of 2.2 for it. Files of 16 bits that do not
  // say what they are would be taken for linear.
  png.image.format = PNG_FORMAT_RGB;
  png.image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  std::vector<png_byte> numbers(PNG_IMAGE_SIZE(png.image));
  EnvironmentImage image = blank(png.image.width, png.image.height);
  if (png_image_finish_read(&png.image, nullptr, numbers.data(), 0, nullptr) == 0) return damaged("PNG");
  auto number = numbers.begin();
  for (Light& pixel : image.pixels) {
    for (int channel = 0; channel < 3; ++channel) pixel[channel] = linearFromSrgb(*number++ / 255.0);
  }
  return image;
}

sim::Result<EnvironmentImage> readByFirstBytes(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    return sim::Problem{"", "there is no such file", "give the path of an image"};
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) return sim::Problem{"", "this file cannot be read", "see that you may read it"};
  std::array<unsigned char, 4> first{};
  const std::size_t got = std::fread(first.data(), 1, first.size(), file.get());
  std::rewind(file.get());
  const auto begins = [&](std::initializer_list<unsigned char> bytes) {
    return got >= bytes.size() && std::equal(bytes.begin(), bytes.end(), first.begin());
  };
  if (begins({0x76, 0x2f, 0x31, 0x01})) return readExr(path);
  if (begins({'#', '?'})) return readHdr(file.get());
  if (begins({0x89, 'P', 'N', 'G'})) return readPng(file.get());
  return sim::Problem{"", "this is no image that can light a scene",
                      "give an OpenEXR, Radiance .hdr or PNG file"};
}

}  // namespace

sim::Result<EnvironmentImage> readEnvironment(const std::filesystem::path& path) {
  auto image = readByFirstBytes(path);
  if (image) return image;
  sim::Problem problem = image.problem();
  problem.place = path.string();
  return problem;
}

}  // namespace ui
