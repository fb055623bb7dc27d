#include "ui/session/session.h"

#include <QFileInfo>
#include <algorithm>

#include "modeling/scene/scene_file.h"

namespace ui {
namespace {

/// As often as a screen is drawn.
constexpr int kTickMilliseconds = 16;

/// Where the camera stands and what the scene is called changes nothing about its motion.
bool movesAlike(modeling::Scene left, modeling::Scene right) {
  left.view = right.view;
  left.name = right.name;
  return modeling::withoutPresets(std::move(left)) == modeling::withoutPresets(std::move(right));
}

}  // namespace

Session::Session(std::filesystem::path takesFolder, QObject* parent)
    : QObject(parent),
      takesFolder_(std::move(takesFolder)),
      selection_(document_),
      preview_(std::make_shared<const Preview>()),
      run_(std::make_shared<const RunView>()) {
  connect(&document_, &Document::sceneChanged, this, &Session::rebuild);
  connect(&document_, &Document::replaced, this, [this] {
    worker_.stop();
    takes_.clear();
    currentTake_.reset();
    playback_.setFootage(nullptr);
    following_ = false;
    currentRun_ = 0;
    emit takesChanged();
  });
  connect(&playback_, &Playback::frameChanged, this, &Session::showFrame);
  connect(&timer_, &QTimer::timeout, this, &Session::tick);
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.start(kTickMilliseconds);
}

Session::~Session() = default;

bool Session::isRunning() const {
  return run_->run == currentRun_ && (run_->phase == RunPhase::running || run_->phase == RunPhase::preparing);
}

bool Session::hasRun() const {
  return isRunning() || (run_->run == currentRun_ && run_->phase == RunPhase::paused);
}

void Session::rebuild() {
  builder_.request(document_.scene(), document_.folder());
  judgeTakes();
}

void Session::judgeTakes() {
  bool changed = false;
  for (Take& take : takes_) {
    const bool stale = !movesAlike(take.footage->scene(), document_.scene());
    changed |= stale != take.stale;
    take.stale = stale;
  }
  if (changed) emit takesChanged();
}

void Session::tick() {
  if (std::shared_ptr<const Preview> preview = builder_.newest(); preview != preview_) {
    const bool moves = !movesAlike(preview->scene, preview_->scene);
    preview_ = std::move(preview);
    emit previewChanged();
    // Who edits what the lattice is made of wants to see it, not a frame of a take that is out of date.
    if (!shown_.recorded || (moves && !hasRun())) showEdited();
  }
  if (std::shared_ptr<const RunView> view = worker_.view(); view != run_) takeView(view);
  playback_.tick(!frameAsked_);
  showLoaded();
}

void Session::takeView(const std::shared_ptr<const RunView>& view) {
  run_ = view;
  if (view->run == currentRun_) {
    if (view->footage && !takeListed_) {
      takeListed_ = true;
      takes_.push_back({{nextTakeName_, {}, nextContinuedAt_, QDateTime::currentDateTime()},
                        view->footage,
                        {},
                        false,
                        true});
      currentTake_ = takes_.size() - 1;
      listing_ = true;  // the new take's start is not what the person asked to see
      playback_.setFootage(view->footage);
      listing_ = false;
      emit takesChanged();
    }
    recordPerformed(*view);
    if (view->phase == RunPhase::failed && view->problem) emit problemFound(*view->problem);
    if (following_ && view->newest) {
      show({view->footage->network(), view->newest,
            std::make_shared<const modeling::Scene>(view->footage->scene()), true, true});
    }
    if (view->phase == RunPhase::done || view->phase == RunPhase::failed) {
      if (following_) playback_.toLast();
      following_ = false;
    }
  }
  emit runChanged();
}

void Session::recordPerformed(const RunView& view) {
  if (performedSeen_ >= view.performed.size()) return;
  const std::size_t from = std::exchange(performedSeen_, view.performed.size());
  if (recording_) {
    document_.edit(
        tr("Perform"),
        [&](modeling::Scene& scene) {
          for (std::size_t i = from; i < view.performed.size(); ++i) replay(view.performed[i], scene);
        },
        QStringLiteral("perform %1").arg(view.run));
  }
  judgeTakes();
}

void Session::show(Shown shown) {
  shown_ = std::move(shown);
  emit shownChanged();
}

void Session::showEdited() {
  following_ = false;
  playback_.stop();
  Shown shown;
  shown.scene = std::make_shared<const modeling::Scene>(preview_->scene);
  if (preview_->built) {
    shown.network = std::shared_ptr<const sim::Network>(preview_->built, &preview_->built->network);
    shown.moment = preview_->rest;
  }
  frameShown_.reset();
  show(std::move(shown));
}

void Session::followRun() {
  if (!hasRun()) return;
  following_ = true;
  playback_.stop();
  takeView(run_);
}

void Session::showFrame() {
  const std::shared_ptr<Footage>& footage = playback_.footage();
  if (!footage || footage->frameCount() == 0) return;
  if (listing_) return;
  following_ = false;
  const std::size_t frame = playback_.frame();
  if (sim::SnapshotPointer moment = footage->held(frame)) {
    frameAsked_.reset();
    frameShown_ = frame;
    show({footage->network(), std::move(moment), std::make_shared<const modeling::Scene>(footage->scene()),
          true, false});
    return;
  }
  frameAsked_ = frame;
  loader_.request(footage, frame);
}

void Session::showLoaded() {
  std::optional<FrameLoader::Loaded> loaded = loader_.take();
  if (!loaded || loaded->footage != playback_.footage()) return;
  if (frameAsked_ == loaded->frame) frameAsked_.reset();
  if (loaded->problem) {
    emit problemFound(*loaded->problem);
    playback_.stop();
    return;
  }
  if (following_) return;
  frameShown_ = loaded->frame;
  show({loaded->footage->network(), loaded->moment,
        std::make_shared<const modeling::Scene>(loaded->footage->scene()), true, false});
}

void Session::playOrPause() {
  if (hasRun()) {
    worker_.setPaused(run_->phase != RunPhase::paused);
    if (run_->phase == RunPhase::paused) followRun();
    return;
  }
  if (playback_.direction() != 0) {
    playback_.stop();
    return;
  }
  if (currentTake_ && !takes_[*currentTake_].stale) {
    playback_.play(1);
    return;
  }
  simulate();
}

std::filesystem::path Session::newTakeFile() {
  std::error_code error;
  std::filesystem::create_directories(takesFolder_, error);
  const std::string stamp = QDateTime::currentDateTime().toString("yyyyMMdd-hhmmss-zzz").toStdString();
  return takesFolder_ / ("take-" + stamp + ".take");
}

QString Session::freshTakeName() const {
  int number = 1;
  const auto taken = [&](const QString& name) {
    return std::any_of(takes_.begin(), takes_.end(), [&](const Take& take) { return take.name == name; });
  };
  while (taken(tr("Take %1").arg(number))) ++number;
  return tr("Take %1").arg(number);
}

void Session::begin(RunPlan plan, const QString& name) {
  nextTakeName_ = name;
  takeListed_ = false;
  performedSeen_ = 0;
  following_ = true;
  playback_.stop();
  document_.endGesture();
  currentRun_ = worker_.start(std::move(plan));
  auto preparing = std::make_shared<RunView>();
  preparing->run = currentRun_;
  preparing->phase = RunPhase::preparing;
  run_ = std::move(preparing);
  emit runChanged();
}

void Session::simulate() {
  if (document_.scene().parts.empty()) {
    report({"", "there is nothing to simulate", "add a part first"});
    return;
  }
  RunPlan plan;
  plan.scene = document_.scene();
  plan.folder = document_.folder();
  plan.take = newTakeFile();
  if (preview_->built && preview_->scene == plan.scene) plan.built = preview_->built;
  nextContinuedAt_.reset();
  begin(std::move(plan), freshTakeName());
}

void Session::continueFromFrame(bool changed) {
  const std::shared_ptr<Footage>& footage = playback_.footage();
  if (!footage || footage->frameCount() == 0) return;
  RunPlan plan;
  plan.scene = changed ? document_.scene() : footage->scene();
  plan.folder = document_.folder();
  plan.take = newTakeFile();
  plan.continuation = RunPlan::Continuation{footage, playback_.frame(), changed};
  nextContinuedAt_ = footage->note(playback_.frame()).time;
  begin(std::move(plan), freshTakeName());
}

void Session::selectTake(std::size_t take) {
  if (take >= takes_.size() || currentTake_ == take) return;
  currentTake_ = take;
  following_ = false;
  playback_.setFootage(takes_[take].footage);
  showFrame();
  emit takesChanged();
}

void Session::renameTake(std::size_t take, const QString& name) {
  takes_.at(take).name = name;
  emit takesChanged();
}

void Session::noteTake(std::size_t take, const QString& note) {
  takes_.at(take).note = note;
  emit takesChanged();
}

void Session::setThumbnail(std::size_t take, const QImage& picture) {
  takes_.at(take).thumbnail = picture;
  emit takesChanged();
}

void Session::removeTake(std::size_t take) {
  if (take >= takes_.size()) return;
  const std::shared_ptr<Footage> footage = takes_[take].footage;
  if (hasRun() && run_->footage == footage) worker_.stop();
  if (takes_[take].own) {
    emit takeRemoved(footage->file());
    std::error_code error;
    std::filesystem::remove(footage->file(), error);
  }
  takes_.erase(takes_.begin() + static_cast<std::ptrdiff_t>(take));
  if (currentTake_ == take) {
    currentTake_.reset();
    playback_.setFootage(nullptr);
    showEdited();
  } else if (currentTake_ && *currentTake_ > take) {
    --*currentTake_;
  }
  emit takesChanged();
}

sim::Status Session::addTake(const std::filesystem::path& file, Take take) {
  sim::Result<std::shared_ptr<Footage>> footage = Footage::open(file);
  if (!footage) return footage.problem();
  take.footage = *footage;
  takes_.push_back(std::move(take));
  loader_.gatherNotes(*footage);
  judgeTakes();
  return sim::Done{};
}

sim::Status Session::openTake(const std::filesystem::path& file) {
  Take take;
  take.name = QString::fromStdString(file.stem().string());
  take.made = QFileInfo(QString::fromStdString(file.string())).lastModified();
  take.own = file.parent_path() == takesFolder_;
  if (const sim::Status added = addTake(file, std::move(take)); !added) return added;
  selectTake(takes_.size() - 1);
  return sim::Done{};
}

sim::Status Session::listTake(const std::filesystem::path& file, const TakeLabel& label,
                              const QImage& thumbnail) {
  if (const sim::Status added = addTake(file, {label, {}, thumbnail, false, true}); !added) return added;
  emit takesChanged();
  return sim::Done{};
}

bool Session::hasOwnTakes() const {
  return std::any_of(takes_.begin(), takes_.end(), [](const Take& take) { return take.own; });
}

void Session::adoptTakes(const std::vector<LeftTake>& takes) {
  std::error_code error;
  std::filesystem::create_directories(takesFolder_, error);
  for (const LeftTake& left : takes) {
    const std::filesystem::path own = takesFolder_ / left.file.filename();
    std::filesystem::rename(left.file, own, error);
    if (const sim::Status opened = openTake(error ? left.file : own); !opened) {
      report(opened.problem());
      continue;
    }
    takes_.back().note = left.note;
    if (!left.name.isEmpty()) takes_.back().name = left.name;
  }
  if (!takes.empty()) emit takesChanged();
}

sim::Status Session::saveTake(std::size_t take, const std::filesystem::path& file) const {
  const std::filesystem::path& from = takes_.at(take).footage->file();
  std::error_code error;
  std::filesystem::path partial = file;
  partial += ".part";
  std::filesystem::copy_file(from, partial, std::filesystem::copy_options::overwrite_existing, error);
  if (!error) std::filesystem::rename(partial, file, error);
  if (!error) return sim::Done{};
  std::error_code ignored;
  std::filesystem::remove(partial, ignored);
  return sim::Problem{file.string(), "the take could not be saved: " + error.message(),
                      "choose another folder, or make room"};
}

void Session::perform(const modeling::TargetName& target, std::vector<modeling::SceneTrackKey> keys) {
  if (hasRun()) worker_.perform(target, std::move(keys));
}

void Session::performCollider(const modeling::SceneCollider& prototype,
                              std::vector<modeling::SceneTrackKey> path) {
  if (hasRun()) worker_.performCollider(prototype, std::move(path));
}

}  // namespace ui
