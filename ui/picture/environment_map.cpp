#include "ui/picture/environment_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/picture/film.h"

namespace ui {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
/// Cells across: finer ones find no smaller lamps that matter.
constexpr int kMostColumns = 512;
/// Of the mean: what is darker is asked so often all the same, since between cells light is blended.
constexpr float kLeastShare = 0.01F;

/// Image coordinates in [0, 1) of a unit direction.
std::array<float, 2> placeOf(const Vec3f& direction, float turn) {
  const float across = 0.5F + std::atan2(direction.x(), direction.y()) / (2.0F * kPi) + turn;
  return {across - std::floor(across), std::acos(std::clamp(direction.z(), -1.0F, 1.0F)) / kPi};
}

}  // namespace

sim::Result<std::shared_ptr<const EnvironmentMap>> EnvironmentMap::create(EnvironmentImage image,
                                                                          double strength, double turn) {
  std::shared_ptr<EnvironmentMap> map(new EnvironmentMap);
  for (Light& light : image.pixels) light *= static_cast<float>(strength);
  map->image_ = std::move(image);
  map->turn_ = static_cast<float>(turn / 360.0 - std::floor(turn / 360.0));
  map->columns_ = std::min(kMostColumns, map->image_.width);
  map->rows_ = std::max(1, map->columns_ / 2);
  map->measure();
  if (!(map->mean_.sum() > 0.0F))
    return sim::Problem{"", "the image of the environment has no light", "give one that is not black"};
  return std::shared_ptr<const EnvironmentMap>(std::move(map));
}

sim::Result<std::shared_ptr<const EnvironmentMap>> EnvironmentMap::load(
    const modeling::EnvironmentLight& light, const std::filesystem::path& folder,
    const EnvironmentReader& read, const modeling::Attendance& attendance) {
  if (light.image.empty()) return std::shared_ptr<const EnvironmentMap>();
  const std::filesystem::path path = folder / light.image;
  auto image = read(path, attendance);
  if (!image) return image.problem();
  auto map = create(std::move(*image), light.strength, light.turn);
  if (map) return map;
  sim::Problem problem = map.problem();
  problem.place = path.string();
  return problem;
}

Light EnvironmentMap::pixel(int x, int y) const {
  const int wrapped = (x % image_.width + image_.width) % image_.width;
  const int row = std::clamp(y, 0, image_.height - 1);
  return image_.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) +
                       static_cast<std::size_t>(wrapped)];
}

Light EnvironmentMap::radiance(const Vec3f& direction) const {
  const auto [across, down] = placeOf(direction, turn_);
  const float x = across * static_cast<float>(image_.width) - 0.5F;
  const float y = down * static_cast<float>(image_.height) - 0.5F;
  const float left = std::floor(x);
  const float top = std::floor(y);
  const int column = static_cast<int>(left);
  const int row = static_cast<int>(top);
  const Light upper = pixel(column, row) + (x - left) * (pixel(column + 1, row) - pixel(column, row));
  const Light lower =
      pixel(column, row + 1) + (x - left) * (pixel(column + 1, row + 1) - pixel(column, row + 1));
  return upper + (y - top) * (lower - upper);
}

Vec3f EnvironmentMap::directionAt(float across, float down) const {
  const float longitude = 2.0F * kPi * (across - 0.5F - turn_);
  const float level = std::sin(kPi * down);
  return {level * std::sin(longitude), level * std::cos(longitude), std::cos(kPi * down)};
}

/// Shares of cells are the light that comes from them: brightness times solid angle.
void EnvironmentMap::measure() {
  const auto count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  shares_.assign(count, 0.0F);
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  Eigen::Array3d above = Eigen::Array3d::Zero();
  double angles = 0.0;
  for (int y = 0; y < image_.height; ++y) {
    const float down = (static_cast<float>(y) + 0.5F) / static_cast<float>(image_.height);
    const float level = std::sin(kPi * down);
    const float cosine = std::max(0.0F, std::cos(kPi * down));
    for (int x = 0; x < image_.width; ++x) {
      const Light light = pixel(x, y);
      const float across = (static_cast<float>(x) + 0.5F) / static_cast<float>(image_.width);
      spread(across, down, level * brightness(light));
      sum += (level * light).cast<double>();
      above += (level * cosine * light).cast<double>();
      angles += static_cast<double>(level);
    }
  }
  mean_ = (sum / angles).cast<float>();
  // The mean over the sphere, of cos L, is a quarter of that over the hemisphere by cos / pi.
  fromAbove_ = (4.0 * above / angles).cast<float>();
  double total = 0.0;
  for (const float share : shares_) total += static_cast<double>(share);
  const double least = kLeastShare * total / static_cast<double>(count);
  double upTo = 0.0;
  for (float& share : shares_) {
    share = static_cast<float>((static_cast<double>(share) + least) / (total * (1.0 + kLeastShare)));
    upTo += static_cast<double>(share);
    upTo_.push_back(static_cast<float>(upTo));
  }
}

/// Between pixels light is blended, so a lamp shines from the pixels beside it, too.
void EnvironmentMap::spread(float across, float down, float light) {
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      const float beside = across + static_cast<float>(x) / static_cast<float>(image_.width);
      const float below = down + static_cast<float>(y) / static_cast<float>(image_.height);
      const float weight = (x == 0 ? 0.5F : 0.25F) * (y == 0 ? 0.5F : 0.25F);
      shares_[cellAt(beside - std::floor(beside), std::clamp(below, 0.0F, 1.0F))] += weight * light;
    }
  }
}

std::size_t EnvironmentMap::cellAt(float across, float down) const {
  const int column = std::clamp(static_cast<int>(across * static_cast<float>(columns_)), 0, columns_ - 1);
  const int row = std::clamp(static_cast<int>(down * static_cast<float>(rows_)), 0, rows_ - 1);
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

EnvironmentMap::Sample EnvironmentMap::sample(const std::array<float, 2>& random) const {
  // The first number chooses the cell, and where it falls within the cell's share is another.
  const auto found = std::upper_bound(upTo_.begin(), upTo_.end(), random[0]);
  const auto cell = static_cast<std::size_t>(std::min(found, upTo_.end() - 1) - upTo_.begin());
  const float before = cell > 0 ? upTo_[cell - 1] : 0.0F;
  const float within = std::clamp((random[0] - before) / (upTo_[cell] - before), 0.0F, 1.0F);
  const auto column = static_cast<float>(cell % static_cast<std::size_t>(columns_));
  const auto row = static_cast<float>(cell / static_cast<std::size_t>(columns_));
  const float down = (row + random[1]) / static_cast<float>(rows_);
  const Vec3f direction = directionAt((column + within) / static_cast<float>(columns_), down);
  return {direction, density(direction)};
}

float EnvironmentMap::density(const Vec3f& direction) const {
  const auto [across, down] = placeOf(direction, turn_);
  const float level = std::sqrt(std::max(0.0F, 1.0F - direction.z() * direction.z()));
  const auto count = static_cast<float>(shares_.size());
  return shares_[cellAt(across, down)] * count / (2.0F * kPi * kPi * std::max(level, 1e-6F));
}

}  // namespace ui
