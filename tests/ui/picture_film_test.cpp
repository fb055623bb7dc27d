#include <cmath>

#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "ui/picture/film.h"

namespace {

using ui::Exposure;
using ui::Film;
using ui::Light;
using ui::Vec3f;

constexpr int kSide = 32;
constexpr int kSamples = 16;

/// A wall on the left half and a floor on the right, lit by 1 and by `rightLight`, with noise of deviation
/// 0.3 a sample.
Film noisyCorner(float rightLight) {
  Film film{kSide, kSide, std::vector<ui::FilmPixel>(kSide * kSide)};
  for (int i = 0; i < kSide * kSide; ++i) {
    const bool left = i % kSide < kSide / 2;
    const auto across = static_cast<float>(i % kSide - kSide / 2);
    const auto down = static_cast<float>(i / kSide);
    Exposure sample;
    sample.colour = Light::Constant(0.5F);
    sample.normal = left ? Vec3f::UnitX() : Vec3f::UnitZ();
    sample.point = left ? Vec3f(0.0F, down, -across) : Vec3f(across, down, 0.0F);
    for (int s = 0; s < kSamples; ++s) {
      const double noise = 0.3 * sim::normalAt(5, static_cast<std::uint64_t>(i * kSamples + s));
      sample.indirect = Light::Constant((left ? 1.0F : rightLight) + static_cast<float>(noise));
      film.pixels[static_cast<std::size_t>(i)].add(sample);
    }
    film.pixels[static_cast<std::size_t>(i)].finish();
  }
  return film;
}

/// Mean and deviation from `expected` of the indirect brightness in columns [from, to).
std::pair<double, double> statistics(const Film& film, int from, int to, double expected) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (int i = 0; i < kSide * kSide; ++i) {
    if (i % kSide < from || i % kSide >= to) continue;
    const double value = ui::brightness(film.pixels[static_cast<std::size_t>(i)].mean.indirect);
    sum += value;
    squares += (value - expected) * (value - expected);
    count += 1.0;
  }
  return {sum / count, std::sqrt(squares / count)};
}

TEST_CASE("smoothing takes most of the noise and leaves the light") {
  Film film = noisyCorner(1.0F);
  const double before = statistics(film, 0, kSide, 1.0).second;
  CHECK(before == Approx(0.3 / std::sqrt(kSamples)).epsilon(0.1));
  ui::smoothIndirect(film);
  const auto [mean, after] = statistics(film, 0, kSide, 1.0);
  CHECK(after < 0.35 * before);
  // The mean of 1024 pixels of 16 samples has a deviation of 0.0023.
  CHECK(mean == Approx(1.0).margin(0.01));
}

TEST_CASE("smoothing carries no light around a corner") {
  Film film = noisyCorner(0.2F);
  ui::smoothIndirect(film);
  CHECK(statistics(film, kSide / 2 - 1, kSide / 2, 1.0).first == Approx(1.0).margin(0.03));
  CHECK(statistics(film, kSide / 2, kSide / 2 + 1, 0.2).first == Approx(0.2).margin(0.03));
}

TEST_CASE("a pixel's light is that of its samples") {
  ui::FilmPixel pixel;
  Exposure bright, dark;
  bright.colour = Light::Constant(0.8F);
  bright.indirect = Light::Constant(2.0F);
  bright.rest = Light::Constant(0.1F);
  dark.rest = Light::Constant(0.5F);
  pixel.add(bright);
  pixel.add(dark);
  pixel.finish();
  CHECK(pixel.mean.light()[0] == Approx((0.1 + 1.6 + 0.5) / 2.0));
}

}  // namespace
