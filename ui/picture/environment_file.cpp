#include "ui/picture/environment_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <span>

#include <png.h>

#include "ui/picture/exr_file.h"
#include "ui/picture/radiance_file.h"

namespace ui {

std::optional<sim::Problem> wrongEnvironmentSize(std::int64_t width, std::int64_t height) {
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

EnvironmentImage blank(std::int64_t width, std::int64_t height) {
  EnvironmentImage image{static_cast<int>(width), static_cast<int>(height), {}};
  image.pixels.resize(static_cast<std::size_t>(width * height));
  return image;
}

sim::Result<EnvironmentImage> readExr(const std::filesystem::path& path) {
  EnvironmentImage image;
  auto pixel = image.pixels.begin();
  const auto start = [&](std::int64_t width, std::int64_t height) {
    auto problem = wrongEnvironmentSize(width, height);
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

sim::Result<EnvironmentImage> readHdr(std::FILE* file) {
  // More than the largest image has, flat and with a header.
  constexpr std::size_t kMostBytes = std::size_t{4} * kMostEnvironmentPixels + (std::size_t{1} << 20U);
  std::vector<std::byte> bytes;
  std::array<std::byte, 65536> piece;
  while (bytes.size() < kMostBytes) {
    const std::size_t got = std::fread(piece.data(), 1, piece.size(), file);
    if (got == 0) break;
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(got));
  }
  auto image = readRadiance(bytes);
  if (!image) return image.problem();
  for (Light& pixel : image->pixels) {
    for (float& channel : pixel) channel = cleaned(channel);
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
  if (auto problem = wrongEnvironmentSize(png.image.width, png.image.height)) return *problem;
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

/// What the reading process answers.
sim::ByteWriter answerOf(const sim::Result<EnvironmentImage>& image) {
  sim::ByteWriter answer;
  answer.put<std::uint8_t>(image ? 1 : 0);
  if (!image) {
    answer.putString(image.problem().what);
    answer.putString(image.problem().remedy);
    return answer;
  }
  answer.put<std::int32_t>(image->width);
  answer.put<std::int32_t>(image->height);
  answer.putBytes(std::as_bytes(std::span(image->pixels)));
  return answer;
}

sim::Result<EnvironmentImage> imageOf(std::span<const std::byte> bytes) {
  sim::ByteReader answer(bytes);
  std::uint8_t isImage = 0;
  answer.read(isImage);
  if (isImage == 0) {
    sim::Problem problem;
    answer.readString(problem.what);
    answer.readString(problem.remedy);
    return answer.finished() ? problem : damaged("image");
  }
  std::int32_t width = 0, height = 0;
  answer.read(width);
  answer.read(height);
  if (auto problem = wrongEnvironmentSize(width, height)) return *problem;
  EnvironmentImage image = blank(width, height);
  const std::span<std::byte> room = std::as_writable_bytes(std::span(image.pixels));
  const std::span<const std::byte> pixels = answer.readBytes(room.size());
  if (!answer.finished() || pixels.size() != room.size()) return damaged("image");
  std::memcpy(room.data(), pixels.data(), room.size());
  return image;
}

}  // namespace

sim::Result<EnvironmentImage> readEnvironment(const std::filesystem::path& path,
                                              const modeling::ReadingLimits& limits,
                                              const modeling::Attendance& attendance) {
  const auto located = [&](sim::Problem problem) {
    problem.place = path.string();
    return problem;
  };
  const auto answer = modeling::readApart(
      path.filename().string(), [&path] { return answerOf(readByFirstBytes(path)); }, limits, attendance);
  if (!answer) {
    sim::Problem problem = answer.problem();
    // It was read for an image, and not for a mesh.
    if (!problem.remedy.empty())
      problem.remedy = "scale it down, or save it anew as OpenEXR, Radiance .hdr or PNG";
    return located(problem);
  }
  auto image = imageOf(*answer);
  return image ? std::move(image) : located(image.problem());
}

}  // namespace ui
