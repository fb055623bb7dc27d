#include "ui/picture/take_pictures.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "modeling/exchange/take_scene.h"

namespace ui {

namespace {

/// So many frames of a sequence are looked at to find a camera for all.
constexpr std::size_t kFramesLookedAt = 12;

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

sim::Result<Box> boxOfFrames(const sim::TakeReader& take, std::size_t first, std::size_t last) {
  Box box;
  const std::size_t looks = std::min(kFramesLookedAt, last - first + 1);
  for (std::size_t look = 0; look < looks; ++look) {
    const std::size_t index = looks == 1 ? first : first + look * (last - first) / (looks - 1);
    const auto frame = take.frame(index);
    if (!frame) return frame.problem();
    box.extend(boxOfMost((*frame)->positions));
  }
  return box;
}

}  // namespace

Box boxOfMost(const std::vector<sim::Vec3>& positions) {
  constexpr double kLeftOut = 0.01;
  if (positions.empty()) return Box(sim::Vec3::Constant(-1.0), sim::Vec3::Constant(1.0));
  const auto rank = static_cast<std::ptrdiff_t>(kLeftOut * static_cast<double>(positions.size()));
  Box box(positions[0]);
  std::vector<double> values(positions.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(positions.begin(), positions.end(), values.begin(),
                   [axis](const auto& p) { return p[axis]; });
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    box.min()[axis] = values[static_cast<std::size_t>(rank)];
    std::nth_element(values.begin(), values.end() - 1 - rank, values.end());
    box.max()[axis] = *(values.end() - 1 - rank);
  }
  return box;
}

TakePictures::TakePictures(const sim::TakeReader& take, modeling::Scene scene)
    : take_(&take), surfaceBuilder_(take.network()), scene_(std::move(scene)) {}

sim::Result<TakePictures> TakePictures::create(const sim::TakeReader& take, std::size_t first,
                                               std::size_t last, double aspect) {
  auto scene = modeling::sceneOf(take);
  if (!scene) return scene.problem();
  const auto box = boxOfFrames(take, first, last);
  if (!box) return box.problem();
  TakePictures pictures(take, std::move(*scene));
  pictures.subject_ = *box;
  if (const auto& camera = pictures.scene_.view.camera) {
    pictures.camera_ = {camera->position, camera->target, camera->fieldOfView * kRadiansPerDegree};
  } else {
    pictures.camera_ = frameBox(*box, aspect);
  }
  return pictures;
}

sim::Result<PictureScene> TakePictures::sceneOf(std::size_t frame) const {
  const auto moment = take_->frame(frame);
  if (!moment) return moment.problem();
  PictureScene picture;
  picture.surface = surfaceBuilder_.build(**moment);
  picture.looks = modeling::looksOf(scene_, take_->network());
  picture.colliders = modeling::collidersAt(scene_, (*moment)->time);
  picture.camera = camera_;
  picture.subject = subject_;
  return picture;
}

}  // namespace ui
