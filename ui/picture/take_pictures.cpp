#include "ui/picture/take_pictures.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

#include "modeling/exchange/take_scene.h"

namespace ui {

namespace {

/// So many frames of a sequence are looked at to find a camera for all.
constexpr std::size_t kFramesLookedAt = 12;

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

/// The median of each coordinate: far splinters do not pull it away.
sim::Vec3 middleOf(const std::vector<sim::Vec3>& positions) {
  sim::Vec3 middle = sim::Vec3::Zero();
  std::vector<double> values(positions.size());
  const auto half = static_cast<std::ptrdiff_t>(positions.size() / 2);
  for (int axis = 0; axis < 3 && !positions.empty(); ++axis) {
    std::transform(positions.begin(), positions.end(), values.begin(),
                   [axis](const auto& p) { return p[axis]; });
    std::nth_element(values.begin(), values.begin() + half, values.end());
    middle[axis] = values[static_cast<std::size_t>(half)];
  }
  return middle;
}

sim::Result<Box> boxOfFrames(const sim::TakeReader& take, std::size_t first, std::size_t last) {
  Box box;
  const std::size_t looks = std::min(kFramesLookedAt, last - first + 1);
  for (std::size_t look = 0; look < looks; ++look) {
    const std::size_t index = looks == 1 ? first : first + look * (last - first) / (looks - 1);
    const auto frame = take.frame(index);
    if (!frame) return frame.problem();
    box.extend(boxOfMost(**frame));
  }
  return box;
}

}  // namespace

Box boxOfMost(const sim::Snapshot& moment) {
  struct Piece {
    Box box;
    std::size_t nodeCount = 0;
    double distance = 0.0;
  };
  std::map<sim::FragmentId, Piece> pieces;
  for (std::size_t node = 0; node < moment.positions.size(); ++node) {
    Piece& piece = pieces[moment.fragmentOfNode[node]];
    piece.box.extend(moment.positions[node]);
    ++piece.nodeCount;
  }
  const sim::Vec3 middle = middleOf(moment.positions);
  std::vector<Piece> byDistance;
  for (auto& [id, piece] : pieces) {
    piece.distance = (piece.box.center() - middle).norm();
    byDistance.push_back(piece);
  }
  std::stable_sort(byDistance.begin(), byDistance.end(),
                   [](const Piece& a, const Piece& b) { return a.distance < b.distance; });
  Box box;
  double framed = 0.0;
  for (const Piece& piece : byDistance) {
    if (framed >= kFramedShare * static_cast<double>(moment.positions.size())) break;
    box.extend(piece.box);
    framed += static_cast<double>(piece.nodeCount);
  }
  return box.isEmpty() ? Box(sim::Vec3::Constant(-1.0), sim::Vec3::Constant(1.0)) : box;
}

TakePictures::TakePictures(const sim::TakeReader& take, modeling::Scene scene, sim::LooseNodes looseNodes)
    : take_(&take), surfaceBuilder_(take.network(), looseNodes), scene_(std::move(scene)) {}

sim::Result<TakePictures> TakePictures::create(const sim::TakeReader& take, std::size_t first,
                                               std::size_t last, double aspect, sim::LooseNodes looseNodes) {
  auto scene = modeling::sceneOf(take);
  if (!scene) return scene.problem();
  const auto box = boxOfFrames(take, first, last);
  if (!box) return box.problem();
  TakePictures pictures(take, std::move(*scene), looseNodes);
  pictures.subject_ = *box;
  if (const auto& camera = pictures.scene_.view.camera) {
    pictures.camera_ = {camera->position, camera->target, camera->fieldOfView * kRadiansPerDegree};
  } else {
    pictures.camera_ = frameBox(*box, aspect);
  }
  return pictures;
}

sim::Result<PictureScene> TakePictures::sceneOf(std::size_t frame) {
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
