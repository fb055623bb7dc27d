#include "ui/session/picture_job.h"

#include <algorithm>

#include "modeling/exchange/export.h"
#include "ui/picture/video.h"

namespace ui {
namespace {

/// The first look is quick; later ones are rarer, as smoothing the picture for them costs a pass or so.
int nextLook(int samples) {
  return std::max(samples + 1, samples + samples / 2);
}

/// Draws what is ordered, for the worker's job.
template <class Job>
class Drawing {
 public:
  Drawing(const PictureJob::Order& order, Job& job) : order_(order), job_(job) {}

  sim::Status drawAll() {
    const double aspect = static_cast<double>(order_.settings.width) / std::max(1, order_.settings.height);
    modeling::Attendance attendance;
    attendance.tell = [this](const std::string& words) {
      job_.value.doing = words;
      job_.publish();
    };
    attendance.gaveUp = [this] { return job_.cancelled(); };
    auto pictures =
        TakePictures::create(order_.frames, order_.first, order_.last, aspect, order_.choices, attendance);
    job_.value.doing.clear();
    if (!pictures) return pictures.problem();
    if (isVideoPath(order_.out)) return drawVideo(*pictures);
    return drawFrames(*pictures, order_.out);
  }

 private:
  /// The frames are kept where the film cannot be made of them.
  sim::Status drawVideo(TakePictures& pictures) {
    const std::filesystem::path folder = order_.out.string() + ".frames";
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return sim::Problem{folder.string(), "the folder cannot be made", "choose another place"};
    if (auto status = drawFrames(pictures, folder / "frame.png"); !status) return status;
    auto status = writeVideo({(folder / "frame.%04d.png").string(), order_.first, frameCount(),
                              order_.framesPerSecond, order_.out});
    if (status) std::filesystem::remove_all(folder, error);
    return status;
  }

  sim::Status drawFrames(TakePictures& pictures, const std::filesystem::path& out) {
    const bool numbered = !out.empty() && (frameCount() > 1 || isVideoPath(order_.out));
    for (std::size_t frame = order_.first; frame <= order_.last; ++frame) {
      const std::filesystem::path path = numbered ? modeling::numberedPath(out, frame) : out;
      if (auto status = drawFrame(pictures, frame, path); !status) return status;
    }
    return sim::Done{};
  }

  sim::Status drawFrame(TakePictures& pictures, std::size_t frame, const std::filesystem::path& path) {
    auto scene = pictures.sceneOf(frame);
    if (!scene) return scene.problem();
    if (order_.camera) scene->camera = *order_.camera;
    if (order_.camera && order_.choices.aperture) scene->camera.aperture = *order_.choices.aperture;
    const auto frames = static_cast<double>(frameCount());
    const auto before = static_cast<double>(frame - order_.first);
    PictureSettings settings = order_.settings;
    settings.progress = [&](double share) {
      job_.value.share = (before + share) / frames;
      job_.publish();
      return !job_.cancelled();
    };
    const auto run = PictureRun::create(*scene, settings);
    if (!run) return run.problem();
    while ((*run)->samples() < settings.samples) {
      if (!(*run)->advanceTo(nextLook((*run)->samples()))) return sim::Problem{"", "stopped", ""};
      job_.value.image = std::make_shared<const Image>((*run)->image());
      job_.value.frame = frame;
      job_.value.share = (before + static_cast<double>((*run)->samples()) / settings.samples) / frames;
      job_.publish();
    }
    return path.empty() ? sim::Status(sim::Done{}) : writePng(path, (*run)->image(), order_.depth);
  }

  std::size_t frameCount() const { return order_.last - order_.first + 1; }

  const PictureJob::Order& order_;
  Job& job_;
};

}  // namespace

PictureJob::PictureJob(Order order)
    : worker_([](const Order& wanted, auto& job) { return Drawing(wanted, job).drawAll(); }) {
  worker_.request(std::move(order));
}

PictureJob::View PictureJob::view() const {
  const auto answer = worker_.newest();
  View view = answer->value;
  view.ended = answer->ended;
  view.problem = answer->problem;
  return view;
}

}  // namespace ui
