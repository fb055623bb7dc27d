#include "tests/fuzz/sample_images.h"

#include <array>
#include <fstream>
#include <vector>

#include <ImfRgbaFile.h>

#include "ui/picture/image.h"

namespace tests {
namespace {

constexpr int kHeight = 16;

using Rgbe = std::array<unsigned char, 4>;

/// Steps of four pixels, so that there are runs, and rows that differ.
Rgbe pixelAt(int x, int y) {
  return {static_cast<unsigned char>(128 + (x / 4) % 64), static_cast<unsigned char>(40 + y), 200, 129};
}

void append(std::string& bytes, const Rgbe& pixel) {
  for (const unsigned char number : pixel) bytes += static_cast<char>(number);
}

void appendOldRuns(std::string& bytes, const std::vector<Rgbe>& row) {
  for (std::size_t x = 0; x < row.size();) {
    std::size_t same = 1;
    while (x + same < row.size() && row[x + same] == row[x]) ++same;
    append(bytes, row[x]);
    if (same > 1) append(bytes, {1, 1, 1, static_cast<unsigned char>(same - 1)});
    x += same;
  }
}

void appendModernRuns(std::string& bytes, const std::vector<Rgbe>& row) {
  append(bytes,
         {2, 2, static_cast<unsigned char>(row.size() / 256), static_cast<unsigned char>(row.size() % 256)});
  for (std::size_t channel = 0; channel < 4; ++channel) {
    for (std::size_t x = 0; x < row.size();) {
      std::size_t same = 1;
      while (x + same < row.size() && same < 127 && row[x + same][channel] == row[x][channel]) ++same;
      bytes += static_cast<char>(same > 1 ? 128 + same : same);
      bytes += static_cast<char>(row[x][channel]);
      x += same;
    }
  }
}

void writeExr(const std::filesystem::path& path) {
  const std::vector<Imf::Rgba> pixels(2 * kHeight * kHeight, Imf::Rgba(0.5F, 1.0F, 2.0F, 1.0F));
  Imf::RgbaOutputFile file(path.c_str(), 2 * kHeight, kHeight, Imf::WRITE_RGBA);
  file.setFrameBuffer(pixels.data(), 1, 2 * kHeight);
  file.writePixels(kHeight);
}

}  // namespace

std::string radiancePicture(int height, RadianceRuns runs) {
  std::string bytes = "#?RADIANCE\n# a sky\nEXPOSURE=1.0\nFORMAT=32-bit_rle_rgbe\n\n-Y " +
                      std::to_string(height) + " +X " + std::to_string(2 * height) + "\n";
  std::vector<Rgbe> row(static_cast<std::size_t>(2 * height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < 2 * height; ++x) row[static_cast<std::size_t>(x)] = pixelAt(x, y);
    if (runs == RadianceRuns::old) appendOldRuns(bytes, row);
    if (runs == RadianceRuns::modern) appendModernRuns(bytes, row);
    if (runs != RadianceRuns::none) continue;
    for (const Rgbe& pixel : row) append(bytes, pixel);
  }
  return bytes;
}

void writeSampleImages(const std::filesystem::path& folder) {
  const auto write = [&](const char* name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  };
  write("flat.hdr", radiancePicture(kHeight, RadianceRuns::none));
  write("runs.hdr", radiancePicture(kHeight, RadianceRuns::modern));
  write("old-runs.hdr", radiancePicture(kHeight, RadianceRuns::old));
  writeExr(folder / "sky.exr");
  ui::Image image{.width = 2 * kHeight, .height = kHeight, .samples = {}};
  for (int i = 0; i < 6 * kHeight * kHeight; ++i) image.samples.push_back(static_cast<std::uint16_t>(37 * i));
  static_cast<void>(ui::writePng(folder / "sky.png", image));
}

}  // namespace tests
