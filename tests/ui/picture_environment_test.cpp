#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <span>
#include <stdexcept>
#include <thread>

#include <ImfRgbaFile.h>
#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "tests/support/grid_network.h"
#include "ui/picture/environment_map.h"
#include "ui/picture/ground_pattern.h"
#include "ui/picture/image.h"
#include "ui/picture/picture.h"
#include "ui/picture/radiance_file.h"

namespace {

using sim::Vec3;
using ui::EnvironmentImage;
using ui::EnvironmentMap;
using ui::Light;
using ui::Vec3f;

constexpr int kWidth = 32;
constexpr int kHeight = 16;

std::filesystem::path temporary(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("smithereens-environment-" + name);
}

/// Halves and RGBE numbers hold them exactly.
Light lightAt(int x, int y) {
  return {static_cast<float>(x) / 8.0F, static_cast<float>(y) / 4.0F, 4.0F};
}

void writeFile(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string bytesOf(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string hdrBytes(int width, int height) {
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                      std::to_string(width) + "\n";
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      // Blue is 4 = 128 / 256 * 2^3.
      for (const float channel : lightAt(x, y)) bytes += static_cast<char>(std::lround(channel * 32.0F));
      bytes += static_cast<char>(128 + 3);
    }
  }
  return bytes;
}

void writeExr(const std::filesystem::path& path) {
  std::vector<Imf::Rgba> pixels;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Light light = lightAt(x, y);
      pixels.emplace_back(light[0], light[1], light[2], 1.0F);
    }
  }
  Imf::RgbaOutputFile file(path.c_str(), kWidth, kHeight, Imf::WRITE_RGBA);
  file.setFrameBuffer(pixels.data(), 1, kWidth);
  file.writePixels(kHeight);
}

TEST_CASE("OpenEXR and Radiance images of the environment are read to the number") {
  const auto exr = temporary("whole.exr");
  const auto hdr = temporary("whole.hdr");
  writeExr(exr);
  writeFile(hdr, hdrBytes(kWidth, kHeight));
  for (const auto& path : {exr, hdr}) {
    INFO(path);
    const auto image = ui::readEnvironment(path);
    REQUIRE(image.ok());
    REQUIRE(image->width == kWidth);
    REQUIRE(image->height == kHeight);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x)
        CHECK((image->pixels[static_cast<std::size_t>(y * kWidth + x)] == lightAt(x, y)).all());
    }
    std::filesystem::remove(path);
  }
}

TEST_CASE("a PNG lights by what its sRGB stands for") {
  const auto path = temporary("grey.png");
  ui::Image grey{.width = kWidth, .height = kHeight, .samples = {}};
  grey.samples.assign(3U * kWidth * kHeight, 0x8080);
  REQUIRE(ui::writePng(path, grey, ui::PngDepth::sixteenBit));
  const auto image = ui::readEnvironment(path);
  REQUIRE(image.ok());
  // 128 of 255, by the curve of IEC 61966-2-1, in single precision.
  CHECK(image->pixels[5][1] == Approx(0.2158605).epsilon(1e-6));
  std::filesystem::remove(path);
}

TEST_CASE("what is no image of the environment is told by file and reason, and whatever is cut or spoiled") {
  const auto path = temporary("bad");
  const auto fails = [&](const std::string& bytes) {
    writeFile(path, bytes);
    const auto image = ui::readEnvironment(path);
    if (image) return false;
    CHECK(image.problem().place == path.string());
    CHECK_FALSE(image.problem().what.empty());
    CHECK_FALSE(image.problem().remedy.empty());
    return true;
  };
  CHECK(fails(""));
  CHECK(fails("GIF89a, and more of it"));
  CHECK(fails(hdrBytes(kWidth, kHeight + 1)));
  CHECK(fails(hdrBytes(1'000'000, 500'000)));
  CHECK(fails(hdrBytes(8192, 4096)));
  CHECK_FALSE(ui::readEnvironment(temporary("missing")).ok());
  CHECK_FALSE(ui::readEnvironment(std::filesystem::temp_directory_path()).ok());
  const auto exr = temporary("spoiled.exr");
  const auto png = temporary("spoiled.png");
  writeExr(exr);
  ui::Image grey{.width = kWidth, .height = kHeight, .samples = {}};
  for (std::size_t i = 0; i < 3U * kWidth * kHeight; ++i)
    grey.samples.push_back(static_cast<std::uint16_t>(sim::uniformAt(3, i) * 65536.0));
  REQUIRE(ui::writePng(png, grey));
  for (const std::string& whole : {hdrBytes(kWidth, kHeight), bytesOf(exr), bytesOf(png)}) {
    REQUIRE_FALSE(fails(whole));
    // A PNG's last chunk only says that it ends.
    for (std::size_t length = 0; length < whole.size() - 16; length += 1 + whole.size() / 40)
      CHECK(fails(whole.substr(0, length)));
    for (std::uint64_t trial = 0; trial < 200; ++trial) {
      std::string spoiled = whole;
      for (std::uint64_t n = 0; n < 3; ++n) {
        const double at = sim::uniformAt(trial, 2 * n);
        spoiled[static_cast<std::size_t>(at * at * static_cast<double>(whole.size()))] =
            static_cast<char>(256.0 * sim::uniformAt(trial, 2 * n + 1));
      }
      fails(spoiled);  // it may be an image still; it must end, and not take all memory
    }
  }
  for (const auto& file : {path, exr, png}) std::filesystem::remove(file);
}

/// A row of Radiance's new kind: each share by itself, in runs.
std::string runsOf(int width, const std::string& row) {
  std::string bytes = "\x02\x02";
  bytes += static_cast<char>(width / 256);
  bytes += static_cast<char>(width % 256);
  for (std::size_t share = 0; share < 4; ++share) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(width);) {
      std::size_t same = 1;
      while (x + same < static_cast<std::size_t>(width) && same < 127 &&
             row[4 * (x + same) + share] == row[4 * x + share])
        ++same;
      bytes += same > 2 ? static_cast<char>(128 + same) : '\x01';
      bytes += row[4 * x + share];
      x += same > 2 ? same : 1;
    }
  }
  return bytes;
}

TEST_CASE("Radiance images in runs of each share are read to the same numbers as plain ones") {
  const std::string plain = hdrBytes(kWidth, kHeight);
  const std::size_t head = plain.size() - 4U * kWidth * kHeight;
  std::string runs = plain.substr(0, head);
  for (int y = 0; y < kHeight; ++y)
    runs += runsOf(kWidth, plain.substr(head + 4U * kWidth * static_cast<std::size_t>(y), 4U * kWidth));
  const auto bytesOfText = [](const std::string& text) { return std::as_bytes(std::span(text)); };
  const auto one = ui::readRadiance(bytesOfText(plain));
  const auto other = ui::readRadiance(bytesOfText(runs));
  REQUIRE(one);
  REQUIRE(other);
  REQUIRE(one->pixels.size() == other->pixels.size());
  for (std::size_t i = 0; i < one->pixels.size(); ++i) CHECK((one->pixels[i] == other->pixels[i]).all());
  for (std::size_t length = 0; length < runs.size(); ++length)
    CHECK_FALSE(ui::readRadiance(bytesOfText(runs.substr(0, length))));
  // The oldest kind repeats whole pixels.
  std::string repeated = "#?RADIANCE\n\n-Y 1 +X 8\n";
  for (const char* pixel : {"\x10\x20\x30\x80", "\x01\x01\x01\x07"}) repeated += pixel;
  const auto old = ui::readRadiance(bytesOfText(repeated));
  REQUIRE(old);
  CHECK((old->pixels.back() == old->pixels.front()).all());
}

TEST_CASE("a reader that is slow, fails or is no longer wanted does nothing to the program, and is told of") {
  const modeling::ReadingLimits limits{.seconds = 1};
  const std::filesystem::path path = "slow.hdr";
  const auto sleeps = []() -> sim::Result<EnvironmentImage> {
    std::this_thread::sleep_for(std::chrono::hours(1));
    return sim::Problem{};
  };
  const auto computes = []() -> sim::Result<EnvironmentImage> {
    for (std::atomic<std::uint64_t> n = 0;; ++n) {
    }
  };
  const auto fails = []() -> sim::Result<EnvironmentImage> { std::abort(); };
  const auto throws = []() -> sim::Result<EnvironmentImage> { throw std::runtime_error("no"); };
  const auto start = std::chrono::steady_clock::now();
  const auto told = [&](const ui::EnvironmentReader& reader, const std::function<bool()>& keepGoing = {}) {
    const auto image = ui::readEnvironmentBy(reader, path, keepGoing, limits);
    return image.ok() ? "" : image.problem().line();
  };
  CHECK_THAT(told(sleeps), Catch::Contains("slow.hdr: reading this image took more than 1 seconds"));
  CHECK_THAT(told(computes), Catch::Contains("took more than 1 seconds"));
  CHECK_THAT(told(fails), Catch::Contains("the reader of this kind of image itself failed"));
  CHECK_THAT(told(throws), Catch::Contains("itself failed"));
  int looks = 0;
  CHECK_THAT(told(sleeps, [&] { return ++looks < 3; }), Catch::Contains("given up"));
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(30));
}

/// Dark, with a small lamp.
EnvironmentImage lampImage(int lampX, int lampY) {
  EnvironmentImage image{64, 32, {}};
  image.pixels.assign(64U * 32U, Light::Constant(0.2F));
  image.pixels[static_cast<std::size_t>(lampY * 64 + lampX)] = Light(300.0F, 200.0F, 100.0F);
  return image;
}

TEST_CASE("samples of an environment find its lamp, and add up to its light") {
  const auto map = EnvironmentMap::create(lampImage(40, 9), 2.0, 25.0).value();
  Light sum = Light::Zero();
  constexpr int kSamples = 40000;
  int bright = 0;
  for (std::uint64_t s = 0; s < kSamples; ++s) {
    const auto sample = map->sample(
        {static_cast<float>(sim::uniformAt(1, 2 * s)), static_cast<float>(sim::uniformAt(1, 2 * s + 1))});
    REQUIRE(sample.direction.norm() == Approx(1.0).margin(1e-4));
    CHECK(map->density(sample.direction) == Approx(sample.density).epsilon(1e-3));
    const Light light = map->radiance(sample.direction);
    sum += light / sample.density / kSamples;
    bright += light[0] > 10.0F ? 1 : 0;
  }
  const Light mean = sum / (4.0F * std::numbers::pi_v<float>);
  for (int channel = 0; channel < 3; ++channel)
    CHECK(mean[channel] == Approx(map->mean()[channel]).epsilon(0.02));
  // The lamp is a 1800th of the sphere and has a third of its light.
  CHECK(bright > kSamples / 10);
}

TEST_CASE("an image is turned about the vertical, its middle towards +y") {
  const auto brightest = [](double turn) {
    // The middle of a pixel just right of the middle of the image, at the horizon.
    const auto map = EnvironmentMap::create(lampImage(32, 16), 1.0, turn).value();
    Vec3f best = Vec3f::Zero();
    for (int step = 0; step < 720; ++step) {
      const float angle = static_cast<float>(step) * std::numbers::pi_v<float> / 360.0F;
      const Vec3f direction(std::cos(angle), std::sin(angle), -0.05F);
      if (best.isZero() || map->radiance(direction.normalized())[0] > map->radiance(best.normalized())[0])
        best = direction;
    }
    return best;
  };
  CHECK(brightest(0.0).y() > 0.99F);
  CHECK(brightest(90.0).x() < -0.99F);
}

/// A convex block in one matt colour, and nothing else.
ui::PictureScene blockScene() {
  const sim::Network network = tests::gridNetwork(3, 3, 3);
  ui::PictureScene scene;
  scene.surface = sim::SurfaceBuilder(network).build(sim::momentAtRest(network));
  scene.looks = {modeling::Look{.outside = {0.6, 0.6, 0.6}, .glaze = 0.0}};
  scene.subject = ui::Box(Vec3(0, 0, 0), Vec3(3, 3, 3));
  scene.camera = ui::frameBox(scene.subject, 4.0 / 3.0, {.azimuth = -std::numbers::pi / 2.0});
  return scene;
}

ui::PictureSettings small(int samples) {
  ui::PictureSettings settings;
  settings.width = 80;
  settings.height = 60;
  settings.samples = samples;
  return settings;
}

/// Linear, of red.
double shownAt(const ui::Image& image, int x, int y) {
  return static_cast<double>(
      ui::linearFromSrgb(image.samples[3U * static_cast<std::size_t>(y * image.width + x)] / 65535.0));
}

TEST_CASE("in even light from all around, a convex body shines with its own colour") {
  ui::PictureScene scene = blockScene();
  EnvironmentImage even{8, 4, {}};
  even.pixels.assign(32, Light::Ones());
  scene.environment = EnvironmentMap::create(even, 1.0, 0.0).value();
  const ui::Image image = ui::renderPicture(scene, small(64)).value();
  // A fragment's tint is a few per cent.
  CHECK(shownAt(image, 40, 32) == Approx(static_cast<double>(ui::linearFromSrgb(0.6))).epsilon(0.08));
  scene.environment = EnvironmentMap::create(even, 0.5, 0.0).value();
  const ui::Image dim = ui::renderPicture(scene, small(64)).value();
  CHECK(shownAt(dim, 40, 32) == Approx(0.5 * shownAt(image, 40, 32)).epsilon(0.03));
}

TEST_CASE("light comes from where the image has it") {
  ui::PictureScene scene = blockScene();
  // The camera stands at -y and sees the front, which a lamp behind it lights, and one behind the block does
  // not.
  scene.environment = EnvironmentMap::create(lampImage(0, 12), 1.0, 0.0).value();
  const double lit = shownAt(ui::renderPicture(scene, small(16)).value(), 40, 36);
  scene.environment = EnvironmentMap::create(lampImage(32, 12), 1.0, 0.0).value();
  const double averted = shownAt(ui::renderPicture(scene, small(16)).value(), 40, 36);
  CHECK(lit > 2.0 * averted);
}

TEST_CASE("a ground of shadows alone is the backdrop, but for where things stand in the light") {
  const bool around = GENERATE(false, true);
  ui::PictureScene scene = blockScene();
  scene.style.ground.kind = modeling::GroundKind::shadow;
  scene.style.backdrop.kind = modeling::BackdropKind::colour;
  scene.style.backdrop.colour = {0.6, 0.6, 0.6};
  if (around) scene.environment = EnvironmentMap::create(lampImage(4, 4), 1.0, 0.0).value();
  const ui::Image image = ui::renderPicture(scene, small(64)).value();
  const double backdrop = static_cast<double>(ui::linearFromSrgb(0.6));
  CHECK(shownAt(image, 40, 1) == Approx(backdrop).epsilon(0.01));
  CHECK(shownAt(image, 1, 58) == Approx(backdrop).epsilon(0.15));
  scene.surface = {};
  const ui::Image empty = ui::renderPicture(scene, small(64)).value();
  CHECK(shownAt(empty, 40, 50) == Approx(backdrop).epsilon(0.05));
  double shade = 1.0;
  for (int y = 30; y < 60; ++y) {
    for (int x = 0; x < 80; ++x) shade = std::min(shade, shownAt(image, x, y) / shownAt(empty, x, y));
  }
  CHECK(shade < 0.8);
}

TEST_CASE("a ground is there for those who ask for one, and gone for those who do not want it") {
  ui::PictureScene scene = blockScene();
  const ui::Image floating = ui::renderPicture(scene, small(4)).value();
  scene.style.ground.kind = modeling::GroundKind::plain;
  scene.style.ground.colour = modeling::Colour{0.9, 0.1, 0.1};
  const ui::Image standing = ui::renderPicture(scene, small(4)).value();
  const auto redAt = [](const ui::Image& image, int x, int y) {
    const std::size_t first = 3U * static_cast<std::size_t>(y * image.width + x);
    return image.samples[first] > 2 * image.samples[first + 1];
  };
  CHECK(redAt(standing, 10, 58));
  CHECK_FALSE(redAt(floating, 10, 58));
  scene.colliders = {sim::Collider{}};
  scene.style.ground.kind = modeling::GroundKind::none;
  CHECK(ui::renderPicture(scene, small(4)).value() == floating);
}

TEST_CASE("a checker alternates by its size, and no two planks are alike") {
  modeling::Ground ground;
  ground.kind = modeling::GroundKind::checker;
  ground.size = 2.0;
  const auto red = [&](float across, float along) { return ui::groundLook(ground, across, along).colour[0]; };
  CHECK(red(1.0F, 1.0F) == red(3.0F, 3.0F));
  CHECK(red(1.0F, 1.0F) == red(-1.0F, -1.0F));
  CHECK(red(1.0F, 1.0F) != red(3.0F, 1.0F));
  CHECK(red(1.0F, 1.0F) != red(-1.0F, 1.0F));
  ground.kind = modeling::GroundKind::wood;
  double rows[2] = {0.0, 0.0};
  for (int i = 0; i < 400; ++i) {
    const auto place = 0.05F * static_cast<float>(i);
    rows[0] += static_cast<double>(red(1.0F, place));
    rows[1] += static_cast<double>(red(3.0F, place));
  }
  CHECK(std::abs(rows[0] - rows[1]) > 0.01 * rows[0]);
}

}  // namespace
