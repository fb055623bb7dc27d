#pragma once

#include <array>
#include <vector>

#include "ui/picture/linear.h"

namespace ui {

/// Light of one sample or the mean of many: rest + colour * indirect. Indirect light varies slowly over a
/// surface but has most of the noise, so it is kept apart to be smoothed.
struct Exposure {
  Light rest = Light::Zero();
  Light colour = Light::Zero();    ///< share of the indirect light that is reflected
  Light indirect = Light::Zero();  ///< falls on the surface
  Vec3f point = Vec3f::Zero();     ///< of the surface
  Vec3f normal = Vec3f::Zero();    ///< zero where there is no surface

  Light light() const { return rest + colour * indirect; }
};

/// A pixel while samples are added to it, and once it is finished.
class FilmPixel {
 public:
  void add(const Exposure& sample);
  /// Makes sums means; nothing becomes nothing.
  void finish();
  /// The sums, before finish(), as numbers to be kept and set again.
  static constexpr std::size_t kSums = 18;
  std::array<float, kSums> sums() const;
  void setSums(const std::array<float, kSums>& sums);

  Exposure mean;
  float variance = 0.0F;  ///< of the brightness of mean.indirect

 private:
  float brightnessSum_ = 0.0F;
  float squareSum_ = 0.0F;
  float count_ = 0.0F;
};

float brightness(const Light& light);

/// Pixels by rows from the top.
struct Film {
  int width = 0;
  int height = 0;
  std::vector<FilmPixel> pixels;
};

/// Smooths the indirect light of finished pixels over even surfaces, no further than its own noise reaches:
/// what differs from its surroundings by more than that stays (edge-avoiding wavelets, Dammertz et al. 2010,
/// steered by the variance as by Schied et al. 2017). Runs in the current TBB arena.
void smoothIndirect(Film& film);

}  // namespace ui
