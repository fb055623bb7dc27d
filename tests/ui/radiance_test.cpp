#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "tests/fuzz/sample_images.h"
#include "ui/picture/radiance_file.h"

namespace {

using tests::radiancePicture;
using tests::RadianceRuns;
using ui::EnvironmentImage;
using ui::Light;

sim::Result<EnvironmentImage> readText(const std::string& bytes) {
  return ui::readRadiance(std::as_bytes(std::span(bytes)));
}

EnvironmentImage sound(const std::string& bytes) {
  auto image = readText(bytes);
  if (!image) FAIL(image.problem().line());
  return std::move(*image);
}

bool same(const EnvironmentImage& a, const EnvironmentImage& b) {
  if (a.width != b.width || a.height != b.height) return false;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if ((a.pixels[i] != b.pixels[i]).any()) return false;
  }
  return true;
}

/// Four pixels in two rows, none like another: red is 1, 2... eighths from the top left on, row by row.
std::string fourByTwo(const std::string& header, const std::string& resolution,
                      const std::vector<int>& order) {
  std::string bytes = "#?RADIANCE\n" + header + "\n" + resolution + "\n";
  for (const int red : order) {
    for (const int number : {32 * red, 64, 128, 128}) bytes += static_cast<char>(number);
  }
  return bytes;
}
const std::vector<int> kRows{1, 2, 3, 4, 5, 6, 7, 0};
const std::string kFormat = "FORMAT=32-bit_rle_rgbe\n";

TEST_CASE("Radiance pictures are the same flat, with old and with new run lengths") {
  for (const int height : {1, 3, 4, 16, 100}) {
    INFO(height);
    const EnvironmentImage flat = sound(radiancePicture(height, RadianceRuns::none));
    CHECK(flat.width == 2 * height);
    // 40 / 256 * 2, of the first row.
    CHECK(flat.pixels[0][1] == 40.0F / 128.0F);
    CHECK(same(flat, sound(radiancePicture(height, RadianceRuns::old))));
    // Shorter scanlines never have them.
    if (height >= 4) CHECK(same(flat, sound(radiancePicture(height, RadianceRuns::modern))));
  }
}

TEST_CASE("an old run of more than 255 pixels is told by several numbers") {
  constexpr int kHeight = 300;
  std::string bytes = "#?RADIANCE\n" + kFormat + "\n-Y 300 +X 600\n";
  for (int y = 0; y < kHeight; ++y) {
    // One, and 599 = 0x257 more, the lowest digit first.
    bytes += std::string{'\x80', '\x40', '\x20', '\x81'} + std::string{'\1', '\1', '\1', '\x57'} +
             std::string{'\1', '\1', '\1', '\2'};
  }
  const EnvironmentImage image = sound(bytes);
  for (const Light& pixel : image.pixels) REQUIRE((pixel == Light(1.0F, 0.5F, 0.25F)).all());
}

TEST_CASE("all eight orders of a resolution line show the same picture") {
  const EnvironmentImage plain = sound(fourByTwo(kFormat, "-Y 2 +X 4", kRows));
  for (int i = 0; i < 8; ++i)
    CHECK(plain.pixels[static_cast<std::size_t>(i)][0] ==
          static_cast<float>(kRows[static_cast<std::size_t>(i)]) / 8.0F);
  // The first axis is the one that changes slowly; -Y goes down.
  const std::pair<const char*, std::vector<int>> orders[] = {
      {"-Y 2 -X 4", {4, 3, 2, 1, 0, 7, 6, 5}}, {"+Y 2 +X 4", {5, 6, 7, 0, 1, 2, 3, 4}},
      {"+Y 2 -X 4", {0, 7, 6, 5, 4, 3, 2, 1}}, {"+X 4 -Y 2", {1, 5, 2, 6, 3, 7, 4, 0}},
      {"-X 4 -Y 2", {4, 0, 3, 7, 2, 6, 1, 5}}, {"+X 4 +Y 2", {5, 1, 6, 2, 7, 3, 0, 4}},
      {"-X 4 +Y 2", {0, 4, 7, 3, 6, 2, 5, 1}},
  };
  for (const auto& [resolution, order] : orders) {
    INFO(resolution);
    CHECK(same(plain, sound(fourByTwo(kFormat, resolution, order))));
  }
}

TEST_CASE(
    "exposures and corrections of colour divide, gammas are undone, all else in a header is passed over") {
  const auto first = [](const std::string& header) {
    return sound(fourByTwo(header, "-Y 2 +X 4", {4, 4, 4, 4, 4, 4, 4, 4})).pixels[0];
  };
  CHECK((first("") == Light(0.5F, 0.25F, 0.5F)).all());
  CHECK((first(kFormat + "EXPOSURE= 2\nEXPOSURE=4.0\n") == Light(0.0625F, 0.03125F, 0.0625F)).all());
  CHECK((first("COLORCORR=0.5 1 2\n" + kFormat) == Light(1.0F, 0.25F, 0.25F)).all());
  CHECK((first(kFormat + "GAMMA=2\n") - Light(0.25F, 0.0625F, 0.25F)).abs().maxCoeff() < 1e-7F);
  CHECK(
      (first("# made by\nrpict -vp 1 2 3 -x=4\nSOFTWARE=any\nVIEW= -vtv\nPIXASPECT=1\nPRIMARIES=0.64 0.33\n" +
             kFormat) == Light(0.5F, 0.25F, 0.5F))
          .all());
  // Lines as Windows ends them.
  CHECK((first("FORMAT=32-bit_rle_rgbe\r\n\r") == Light(0.5F, 0.25F, 0.5F)).all());
}

TEST_CASE("what a Radiance picture is not is told by name") {
  const auto told = [](const std::string& header, const std::string& resolution = "-Y 2 +X 4") {
    const auto image = readText(fourByTwo(header, resolution, kRows));
    return image ? std::string() : image.problem().line();
  };
  CHECK(told("FORMAT=32-bit_rle_xyze\n").find("XYZ") != std::string::npos);
  CHECK(told("FORMAT=ascii\n").find("format") != std::string::npos);
  CHECK(told(kFormat + "EXPOSURE=much\n").find("EXPOSURE") != std::string::npos);
  CHECK(told(kFormat + "EXPOSURE=0\n").find("EXPOSURE") != std::string::npos);
  CHECK(told(kFormat + "GAMMA=-3\n").find("GAMMA") != std::string::npos);
  CHECK(told(kFormat, "-Y 4 +X 2").find("2 x 4") != std::string::npos);
  for (const char* resolution : {"-Y 2", "-Y 2 +Y 4", "-Z 2 +X 4", "-Y 2 +X", "-Y -2 +X 4", "-Y 2 +X 4 more",
                                 "", "-Y 99999999999999999999 +X 4"}) {
    INFO(resolution);
    CHECK(told(kFormat, resolution).find("damaged") != std::string::npos);
  }
}

TEST_CASE("a damaged Radiance picture ends in a time that its size bounds") {
  const auto start = std::chrono::steady_clock::now();
  for (const RadianceRuns runs : {RadianceRuns::none, RadianceRuns::old, RadianceRuns::modern}) {
    const std::string whole = radiancePicture(16, runs);
    for (std::size_t length = 0; length < whole.size(); ++length)
      CHECK_FALSE(readText(whole.substr(0, length)).ok());
    for (std::uint64_t trial = 0; trial < 3000; ++trial) {
      std::string spoiled = whole;
      for (std::uint64_t n = 0; n < 4; ++n) {
        const double at = sim::uniformAt(trial, 2 * n);
        spoiled[static_cast<std::size_t>(at * static_cast<double>(whole.size()))] =
            static_cast<char>(256.0 * sim::uniformAt(trial, 2 * n + 1));
      }
      static_cast<void>(readText(spoiled));
    }
  }
  // Thirteen thousand readings of a few kilobytes: a second, and many times that with sanitizers or a busy
  // machine.
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(60));
}

/// In a process of its own, as readEnvironment() does it, but slow.
sim::Result<EnvironmentImage> readSlowly(const std::filesystem::path& path,
                                         const modeling::Attendance& attendance, double patience) {
  const auto sleep = [] {
    std::this_thread::sleep_for(std::chrono::seconds(30));
    return sim::ByteWriter();
  };
  const auto answer = modeling::readApart(path.filename().string(), sleep, {.seconds = patience}, attendance);
  if (!answer) return answer.problem();
  return sim::Problem{"", "a sleeper answers nothing", ""};
}

TEST_CASE("a reader of images that is slow is told of, can be given up, and is ended when its time is over") {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  std::string told;
  modeling::Attendance attendance;
  attendance.tell = [&](const std::string& words) { told = words; };
  attendance.gaveUp = [&] { return !told.empty(); };
  const auto givenUp = readSlowly("sky.hdr", attendance, 20.0);
  REQUIRE_FALSE(givenUp);
  CHECK(told.starts_with("reading sky.hdr, "));
  CHECK(givenUp.problem().what.find("given up") != std::string::npos);
  const auto tooSlow = readSlowly("sky.hdr", {}, 0.2);
  REQUIRE_FALSE(tooSlow);
  CHECK(tooSlow.problem().what.find("longer than") != std::string::npos);
  CHECK(seconds() < 15.0);  // both together: half of what the sleeper wants
}

TEST_CASE("an image of the environment whose time is over is a Problem with the file's name and a remedy") {
  const auto path = std::filesystem::temp_directory_path() / "smithereens-radiance.hdr";
  std::ofstream(path, std::ios::binary) << radiancePicture(16, RadianceRuns::modern);
  const auto image = ui::readEnvironment(path);
  REQUIRE(image);
  CHECK(image->height == 16);
  const auto late = ui::readEnvironment(path, {.seconds = -1.0});
  // It may answer before it is looked at the first time.
  if (!late) {
    CHECK(late.problem().place == path.string());
    CHECK(late.problem().what.find("longer than") != std::string::npos);
    CHECK(late.problem().remedy.find("mesh") == std::string::npos);
  }
  std::filesystem::remove(path);
}

}  // namespace
