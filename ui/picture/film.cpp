#include "ui/picture/film.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/base/parallel.h"

namespace ui {

namespace {

/// Each pass doubles the reach: 2, 4, 8 pixels.
constexpr int kPasses = 3;
constexpr std::array<float, 3> kWavelet{3.0F / 8.0F, 1.0F / 4.0F, 1.0F / 16.0F};

/// Brightness may differ by this many standard deviations before two pixels are taken for different.
constexpr float kNoiseReach = 3.0F;
/// Steepness of the fall with the angle between normals: half at 12 degrees.
constexpr float kNormalPower = 32.0F;
/// A neighbour may lie this share of its distance off the plane of the pixel.
constexpr float kPlaneSlack = 0.15F;

struct Smoothed {
  Light indirect;
  float variance;
};

/// The variance of one pixel is itself uncertain: the mean over its neighbours is steadier.
float steadyVariance(const Film& film, int x, int y) {
  float sum = 0.0F;
  float count = 0.0F;
  for (int row = std::max(0, y - 1); row <= std::min(film.height - 1, y + 1); ++row) {
    for (int column = std::max(0, x - 1); column <= std::min(film.width - 1, x + 1); ++column) {
      sum += film.pixels[static_cast<std::size_t>(row * film.width + column)].variance;
      count += 1.0F;
    }
  }
  return sum / count;
}

float similarity(const FilmPixel& a, const FilmPixel& b, float deviation) {
  const float cosine = a.mean.normal.dot(b.mean.normal);
  if (cosine <= 0.0F) return 0.0F;
  const Vec3f offset = b.mean.point - a.mean.point;
  const float slack = kPlaneSlack * offset.norm() + 1e-6F;
  const float apart = std::abs(a.mean.normal.dot(offset)) / slack;
  const float change = std::abs(brightness(a.mean.indirect) - brightness(b.mean.indirect)) / deviation;
  return std::pow(cosine, kNormalPower) * std::exp(-apart * apart - change);
}

Smoothed smoothedPixel(const Film& film, int x, int y, int step) {
  const FilmPixel& centre = film.pixels[static_cast<std::size_t>(y * film.width + x)];
  const float deviation = kNoiseReach * std::sqrt(steadyVariance(film, x, y)) + 1e-6F;
  Light sum = Light::Zero();
  float variance = 0.0F;
  float weights = 0.0F;
  for (int down = -2; down <= 2; ++down) {
    for (int across = -2; across <= 2; ++across) {
      const int column = x + across * step;
      const int row = y + down * step;
      if (column < 0 || column >= film.width || row < 0 || row >= film.height) continue;
      const FilmPixel& pixel = film.pixels[static_cast<std::size_t>(row * film.width + column)];
      const bool self = across == 0 && down == 0;
      const float weight = kWavelet[static_cast<std::size_t>(std::abs(across))] *
                           kWavelet[static_cast<std::size_t>(std::abs(down))] *
                           (self ? 1.0F : similarity(centre, pixel, deviation));
      sum += weight * pixel.mean.indirect;
      variance += weight * weight * pixel.variance;
      weights += weight;
    }
  }
  return {sum / weights, variance / (weights * weights)};
}

}  // namespace

float brightness(const Light& light) {
  return 0.2126F * light[0] + 0.7152F * light[1] + 0.0722F * light[2];
}

void FilmPixel::add(const Exposure& sample) {
  mean.rest += sample.rest;
  mean.colour += sample.colour;
  mean.indirect += sample.colour * sample.indirect;
  mean.point += sample.point;
  mean.normal += sample.normal;
  const float value = brightness(sample.indirect);
  brightnessSum_ += value;
  squareSum_ += value * value;
  count_ += 1.0F;
}

std::array<float, FilmPixel::kSums> FilmPixel::sums() const {
  std::array<float, kSums> sums{};
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    sums[at] = mean.rest[i];
    sums[3 + at] = mean.colour[i];
    sums[6 + at] = mean.indirect[i];
    sums[9 + at] = mean.point[i];
    sums[12 + at] = mean.normal[i];
  }
  sums[15] = brightnessSum_;
  sums[16] = squareSum_;
  sums[17] = count_;
  return sums;
}

void FilmPixel::setSums(const std::array<float, kSums>& sums) {
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    mean.rest[i] = sums[at];
    mean.colour[i] = sums[3 + at];
    mean.indirect[i] = sums[6 + at];
    mean.point[i] = sums[9 + at];
    mean.normal[i] = sums[12 + at];
  }
  brightnessSum_ = sums[15];
  squareSum_ = sums[16];
  count_ = sums[17];
}

void FilmPixel::finish() {
  if (count_ <= 0.0F) return;
  mean.indirect = (mean.colour > 0.0F).select(mean.indirect / mean.colour.max(1e-12F), 0.0F);
  mean.rest /= count_;
  mean.colour /= count_;
  mean.point /= count_;
  if (const float length = mean.normal.norm(); length > 0.0F) mean.normal /= length;
  const float average = brightnessSum_ / count_;
  variance = std::max(0.0F, squareSum_ / count_ - average * average) / count_;
}

void smoothIndirect(Film& film) {
  std::vector<Smoothed> smoothed(film.pixels.size());
  for (int pass = 0; pass < kPasses; ++pass) {
    sim::parallelFor(static_cast<std::size_t>(film.height), [&](std::size_t row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < film.width; ++x) {
        smoothed[static_cast<std::size_t>(y * film.width + x)] = smoothedPixel(film, x, y, 1 << pass);
      }
    });
    for (std::size_t i = 0; i < smoothed.size(); ++i) {
      film.pixels[i].mean.indirect = smoothed[i].indirect;
      film.pixels[i].variance = smoothed[i].variance;
    }
  }
}

}  // namespace ui
