#include "ui/session/picture_job.h"

#include <algorithm>
#include <exception>

#include "modeling/exchange/export.h"
#include "ui/picture/video.h"
#include "ui/session/background.h"

namespace ui {

namespace {

/// The first look is quick; later ones are rarer, as smoothing the picture for them costs a pass or so.
int nextLook(int samples) {
  return std::max(samples + 1, samples + samples / 2);
}

}  // namespace

PictureJob::PictureJob(Order order)
    : order_(std::move(order)), runner_([this](const std::stop_token& stop) {
        giveWayToTheWindow();
        sim::Status status = sim::Done{};
        try {
          status = drawAll(stop);
        } catch (const std::exception& exception) {
          status = sim::Problem{"", std::string("the picture failed: ") + exception.what(), ""};
        }
        const std::lock_guard lock(mutex_);
        view_.ended = true;
        if (!status && !stop.stop_requested()) view_.problem = status.problem();
      }) {}

PictureJob::~PictureJob() {
  runner_.request_stop();
}

PictureJob::View PictureJob::view() const {
  const std::lock_guard lock(mutex_);
  return view_;
}

void PictureJob::show(std::shared_ptr<const Image> image, std::size_t frame, double share) {
  const std::lock_guard lock(mutex_);
  view_.image = std::move(image);
  view_.frame = frame;
  view_.share = share;
}

sim::Status PictureJob::drawAll(const std::stop_token& stop) {
  const double aspect = static_cast<double>(order_.settings.width) / std::max(1, order_.settings.height);
  auto pictures = TakePictures::create(order_.frames, order_.first, order_.last, aspect, order_.choices);
  if (!pictures) return pictures.problem();
  const bool isVideo = isVideoPath(order_.out);
  const std::filesystem::path folder = order_.out.string() + ".frames";
  if (isVideo) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return sim::Problem{folder.string(), "the folder cannot be made", "choose another place"};
  }
  for (std::size_t frame = order_.first; frame <= order_.last; ++frame) {
    std::filesystem::path path = order_.out;
    if (isVideo) path = modeling::numberedPath(folder / "frame.png", frame);
    if (!isVideo && !path.empty() && order_.first != order_.last) path = modeling::numberedPath(path, frame);
    if (auto status = drawFrame(*pictures, frame, path, stop); !status) return status;
  }
  if (!isVideo) return sim::Done{};
  auto status = writeVideo({(folder / "frame.%04d.png").string(), order_.first,
                            order_.last - order_.first + 1, order_.framesPerSecond, order_.out});
  if (!status) return status;
  std::error_code kept;
  std::filesystem::remove_all(folder, kept);
  return sim::Done{};
}

sim::Status PictureJob::drawFrame(TakePictures& pictures, std::size_t frame,
                                  const std::filesystem::path& path, const std::stop_token& stop) {
  auto scene = pictures.sceneOf(frame);
  if (!scene) return scene.problem();
  if (order_.camera) scene->camera = *order_.camera;
  if (order_.camera && order_.choices.aperture) scene->camera.aperture = *order_.choices.aperture;
  PictureSettings settings = order_.settings;
  const auto frames = static_cast<double>(order_.last - order_.first + 1);
  const auto before = static_cast<double>(frame - order_.first);
  settings.progress = [&](double share) {
    const std::lock_guard lock(mutex_);
    view_.share = (before + share) / frames;
    return !stop.stop_requested();
  };
  const auto run = PictureRun::create(*scene, settings);
  if (!run) return run.problem();
  while ((*run)->samples() < settings.samples) {
    if (!(*run)->advanceTo(nextLook((*run)->samples()))) return sim::Problem{"", "stopped", ""};
    show(std::make_shared<const Image>((*run)->image()), frame,
         (before + static_cast<double>((*run)->samples()) / settings.samples) / frames);
  }
  return path.empty() ? sim::Status(sim::Done{}) : writePng(path, (*run)->image(), order_.depth);
}

}  // namespace ui
