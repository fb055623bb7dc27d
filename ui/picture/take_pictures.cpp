#include "ui/picture/take_pictures.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

#include "modeling/exchange/take_scene.h"
#include "modeling/scene/tracks.h"
#include "sim/surface/level_surface.h"

namespace ui {

namespace {

/// So many frames of a sequence are looked at to find a camera for all.
constexpr std::size_t kFramesLookedAt = 12;

/// So fine that no face of the level surface shows in a picture; 50 MB while it is made.
constexpr sim::LevelGrid kLevelGrid{.mostCubes = 4'000'000, .cubesInReach = 7.0};

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

sim::Result<Box> boxOfFrames(const PictureFrames& frames, std::size_t first, std::size_t last) {
  Box box;
  const std::size_t looks = std::min(kFramesLookedAt, last - first + 1);
  for (std::size_t look = 0; look < looks; ++look) {
    const std::size_t index = looks == 1 ? first : first + look * (last - first) / (looks - 1);
    const auto frame = frames.frame(index);
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
    Piece& piece = pieces[moment.broken->fragmentOfNode[node]];
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

sim::Result<PictureFrames> framesOf(const sim::TakeReader& take, const std::vector<std::string>& settings) {
  auto scene = modeling::sceneOf(take, settings);
  if (!scene) return scene.problem();
  PictureFrames frames;
  // The take keeps it.
  frames.network = std::shared_ptr<const sim::Network>(std::shared_ptr<void>(), &take.network());
  frames.scene = std::move(*scene);
  frames.framesPerSecond = take.header().framesPerSecond;
  frames.frame = [&take](std::size_t frame) { return take.frame(frame); };
  return frames;
}

TakePictures::TakePictures(PictureFrames frames, const PictureChoices& choices)
    : frames_(std::move(frames)), choices_(choices), surfaceBuilder_(*frames_.network, choices.looseNodes) {}

sim::Result<TakePictures> TakePictures::create(PictureFrames frames, std::size_t first, std::size_t last,
                                               double aspect, const PictureChoices& choices,
                                               const modeling::Attendance& attendance) {
  const auto box = boxOfFrames(frames, first, last);
  if (!box) return box.problem();
  if (auto status = modeling::checkPictureStyle(frames.scene.view.picture); !status) return status.problem();
  auto environment = EnvironmentMap::load(frames.scene.view.picture.environment, frames.folder,
                                          frames.readEnvironment, attendance);
  if (!environment) return environment.problem();
  TakePictures pictures(std::move(frames), choices);
  pictures.environment_ = std::move(*environment);
  pictures.subject_ = *box;
  if (const auto& camera = pictures.frames_.scene.view.camera) {
    pictures.camera_ = {camera->position, camera->target, camera->fieldOfView * kRadiansPerDegree,
                        camera->aperture, camera->focus.value_or(0.0)};
  } else {
    pictures.camera_ = frameBox(*box, aspect);
  }
  if (choices.aperture) pictures.camera_.aperture = *choices.aperture;
  return pictures;
}

sim::Result<PictureScene> TakePictures::sceneOf(std::size_t frame) {
  const auto found = frames_.frame(frame);
  if (!found) return found.problem();
  const sim::Snapshot& moment = **found;
  PictureScene picture;
  picture.style = frames_.scene.view.picture;
  picture.environment = environment_;
  const bool level = picture.style.surface == modeling::PictureSurface::level;
  const sim::SurfaceTopology none;
  const sim::SurfaceTopology& topology = level ? none : surfaceBuilder_.topology(moment.broken);
  picture.surface = level ? sim::levelSurfaceOf(*frames_.network, moment, kLevelGrid)
                          : sim::placeSurface(topology, moment.positions);
  picture.looks = modeling::looksOf(frames_.scene, *frames_.network);
  picture.colliders = modeling::collidersAt(frames_.scene, moment.time);
  picture.camera = camera_;
  picture.subject = subject_;
  if (choices_.shutter > 0.0) {
    // Straight on from how it moves at the frame: what it hits meanwhile is in the next.
    const double open = choices_.shutter / frames_.framesPerSecond;
    std::vector<sim::Vec3> positions = moment.positions;
    for (std::size_t node = 0; node < positions.size(); ++node)
      positions[node] += open * moment.velocities[node];
    if (level) {
      picture.endPoints = picture.surface.points;
      for (std::size_t point = 0; point < picture.endPoints.size(); ++point)
        picture.endPoints[point] += open * moment.velocities[picture.surface.nodeOfPoint[point]];
      picture.endNormals = picture.surface.normals;
    } else {
      picture.endPoints = sim::placePoints(topology, positions);
      picture.endNormals = sim::placeNormals(topology, picture.endPoints);
    }
    picture.endColliders = modeling::collidersAt(frames_.scene, moment.time + open);
    if (picture.endColliders.size() != picture.colliders.size()) picture.endColliders = picture.colliders;
  }
  return picture;
}

}  // namespace ui
