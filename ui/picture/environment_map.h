#pragma once

#include <memory>
#include <vector>

#include "modeling/scene/picture_style.h"
#include "ui/picture/environment_file.h"

namespace ui {

/// Light from all around, of an image. The brighter a part of it is, the more often it is asked. Immutable:
/// any thread may ask.
class EnvironmentMap {
 public:
  /// A Problem for an image that has no light. `strength` > 0; `turn` in degrees (EnvironmentLight).
  static sim::Result<std::shared_ptr<const EnvironmentMap>> create(EnvironmentImage image, double strength,
                                                                   double turn);
  /// Reads what `light` names by `read`, `folder` being where it is looked for. Null where it names nothing.
  static sim::Result<std::shared_ptr<const EnvironmentMap>> load(const modeling::EnvironmentLight& light,
                                                                 const std::filesystem::path& folder,
                                                                 const EnvironmentReader& read,
                                                                 const modeling::Attendance& attendance = {});

  /// From a unit direction.
  Light radiance(const Vec3f& direction) const;

  struct Sample {
    Vec3f direction;       ///< unit
    float density = 0.0F;  ///< per steradian
  };
  Sample sample(const std::array<float, 2>& random) const;
  /// With which sample() gives a direction, per steradian.
  float density(const Vec3f& direction) const;

  /// Mean of its radiance over all directions.
  const Light& mean() const { return mean_; }
  /// What a horizontal white surface reflects when nothing stands in the way: a mean, weighted by the cosine.
  const Light& fromAbove() const { return fromAbove_; }

 private:
  EnvironmentMap() = default;
  Light pixel(int x, int y) const;
  Vec3f directionAt(float across, float down) const;
  void measure();
  void spread(float across, float down, float light);
  std::size_t cellAt(float across, float down) const;

  EnvironmentImage image_;
  float turn_ = 0.0F;  ///< share of a full turn
  int columns_ = 0;    ///< of cells, in which samples are spread evenly by longitude and latitude
  int rows_ = 0;
  std::vector<float> shares_;  ///< of each cell
  std::vector<float> upTo_;    ///< of all cells before and with it
  Light mean_ = Light::Zero();
  Light fromAbove_ = Light::Zero();
};

}  // namespace ui
