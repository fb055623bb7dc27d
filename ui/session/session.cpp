#include "ui/session/session.h"

namespace ui {
namespace {

/// As often as a screen is drawn.
constexpr int kTickMilliseconds = 16;

}  // namespace

Session::Session(std::filesystem::path takesFolder, QObject* parent)
    : QObject(parent),
      selection_(document_),
      takes_(document_, std::move(takesFolder)),
      preview_(std::make_shared<const Preview>()) {
  connect(&document_, &Document::sceneChanged, this, &Session::rebuild);
  connect(&document_, &Document::replaced, this, &Session::replace);
  connect(&playback_, &Playback::frameChanged, this, &Session::showFrame);
  connect(&playback_, &Playback::stateChanged, this, [this] { frameChosen_ |= playback_.direction() != 0; });
  connect(&takes_, &TakeList::currentChanged, this, &Session::showCurrentTake);
  connect(&takes_, &TakeList::fileRead, this,
          [this](const std::shared_ptr<Footage>& footage) { loader_.gatherNotes(footage); });
  connect(&takes_, &TakeList::removing, this, [this](const Take& take) {
    if (hasRun() && run()->footage == take.footage) run_.worker().stop();
  });
  connect(&takes_, &TakeList::problemFound, this, &Session::report);
  connect(&timer_, &QTimer::timeout, this, &Session::tick);
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.start(kTickMilliseconds);
}

/// All threads are asked to end before any is waited for.
Session::~Session() {
  loader_.requestStop();
  builder_.requestStop();
  run_.worker().requestStop();
}

void Session::rebuild() {
  frameChosen_ = false;
  builder_.request(document_.scene(), document_.folder());
  takes_.judge();
}

void Session::replace() {
  run_.forget();
  following_ = false;
  playback_.setFootage(nullptr);
  takes_.clear();
}

void Session::tick() {
  followWaiting();
  followPreview();
  if (run_.poll()) followView();
  ticking_ = true;
  playback_.tick(!frameAsked_);
  ticking_ = false;
  showLoaded();
}

void Session::followPreview() {
  std::shared_ptr<const Preview> preview = builder_.newest();
  if (preview == preview_) return;
  const bool moves = !movesAlike(preview->scene, preview_->scene);
  preview_ = std::move(preview);
  emit previewChanged();
  // Who edits what the lattice is made of wants to see it, not a frame of a take that is out of date; who
  // chose a frame since then wants that, however long building took.
  const bool chosen = frameChosen_ && (shown_.recorded || frameAsked_);
  if (!chosen && (!shown_.recorded || (moves && !hasRun()))) showEdited();
}

void Session::followWaiting() {
  std::string words = builder_.waitingFor();
  if (words == waitingFor_) return;
  waitingFor_ = std::move(words);
  emit waitingChanged();
}

void Session::followView() {
  const std::shared_ptr<const RunView> told = run_.view();
  const RunView& view = *told;
  if (run_.isTold()) {
    if (std::optional<Take> take = run_.newTake()) {
      listing_ = true;  // the new take's start is not what the person asked to see
      takes_.add(std::move(*take));
      listing_ = false;
    }
    recordPerformed();
    if (view.phase == RunPhase::failed && view.problem) emit problemFound(*view.problem);
    if (following_ && view.newest)
      show({view.footage->network(), view.newest, view.footage->scene(), true, true});
    if (view.phase == RunPhase::done || view.phase == RunPhase::failed) {
      if (following_) playback_.toLast();
      following_ = false;
      letGoOfOthers();
    }
  }
  emit runChanged();
}

void Session::recordPerformed() {
  const std::span<const Performed> performed = run_.newlyPerformed();
  if (performed.empty()) return;
  if (recording_) {
    document_.edit(
        tr("Perform"),
        [&](modeling::Scene& scene) {
          for (const Performed& each : performed) replay(each, scene);
        },
        QStringLiteral("perform %1").arg(run()->run));
  }
  takes_.judge();
}

void Session::show(Shown shown) {
  shown_ = std::move(shown);
  emit shownChanged();
}

void Session::showEdited() {
  following_ = false;
  frameChosen_ = false;
  frameAsked_.reset();
  playback_.stop();
  Shown shown;
  shown.scene = std::shared_ptr<const modeling::Scene>(preview_, &preview_->scene);
  if (const auto& drawn = preview_->built ? preview_->built : preview_->unglued) {
    shown.network = std::shared_ptr<const sim::Network>(drawn, &drawn->network);
    shown.moment = preview_->rest;
  }
  show(std::move(shown));
}

void Session::followRun() {
  if (!hasRun()) return;
  following_ = true;
  playback_.stop();
  followView();
}

void Session::showCurrentTake() {
  const std::shared_ptr<Footage> footage = takes_.currentFootage();
  if (!listing_) following_ = false;
  frameAsked_.reset();
  playback_.setFootage(footage);
  letGoOfOthers();
  if (listing_) return;
  if (footage) {
    showFrame();
  } else {
    showEdited();
  }
}

/// Takes that are neither on the timeline nor being recorded stay on the disk only.
void Session::letGoOfOthers() {
  for (const Take& take : takes_) {
    const bool recorded = hasRun() && run()->footage == take.footage;
    if (take.footage != playback_.footage() && !recorded) take.footage->letGo();
  }
}

void Session::showFrame() {
  const std::shared_ptr<Footage>& footage = playback_.footage();
  if (!footage || footage->frameCount() == 0 || listing_) return;
  following_ = false;
  frameChosen_ |= !ticking_;
  const std::size_t frame = playback_.frame();
  if (sim::SnapshotPointer moment = footage->held(frame)) {
    frameAsked_.reset();
    show({footage->network(), std::move(moment), footage->scene(), true, false});
    return;
  }
  frameAsked_ = frame;
  loader_.request(footage, frame);
}

std::optional<Session::AwaitedFrame> Session::awaitedFrame() const {
  if (!frameAsked_ || !playback_.footage()) return std::nullopt;
  return AwaitedFrame{playback_.footage(), *frameAsked_};
}

void Session::showLoaded() {
  std::optional<FrameLoader::Loaded> loaded = loader_.take();
  // What was asked for before something else was shown comes too late.
  if (!loaded || loaded->footage != playback_.footage() || !frameAsked_) return;
  if (frameAsked_ == loaded->frame) frameAsked_.reset();
  if (loaded->problem) {
    emit problemFound(*loaded->problem);
    playback_.stop();
    return;
  }
  if (following_) return;
  show({loaded->footage->network(), loaded->moment, loaded->footage->scene(), true, false});
}

void Session::playOrPause() {
  if (hasRun()) {
    const bool paused = run()->phase == RunPhase::paused;
    run_.worker().setPaused(!paused);
    if (paused) followRun();
    return;
  }
  if (playback_.direction() != 0) {
    playback_.stop();
    return;
  }
  if (takes_.current() && !takes_[*takes_.current()].stale) {
    playback_.play(1);
    return;
  }
  simulate();
}

void Session::begin(RunPlan plan, std::optional<double> continuedAt) {
  following_ = true;
  playback_.stop();
  document_.endGesture();
  TakeLabel label;
  label.name = takes_.freshName();
  label.continuedAt = continuedAt;
  plan.folder = document_.folder();
  plan.take = takes_.newFile();
  run_.start(std::move(plan), std::move(label));
  emit runChanged();
}

void Session::simulate() {
  if (document_.scene().parts.empty()) {
    report({"", "there is nothing to simulate", "add a part first"});
    return;
  }
  RunPlan plan;
  plan.scene = document_.scene();
  if (preview_->built && preview_->scene == plan.scene) plan.built = preview_->built;
  begin(std::move(plan), std::nullopt);
}

void Session::continueFromFrame(bool changed) {
  const std::shared_ptr<Footage>& footage = playback_.footage();
  if (!footage || footage->frameCount() == 0) return;
  RunPlan plan;
  plan.scene = changed ? document_.scene() : *footage->scene();
  plan.continuation = RunPlan::Continuation{footage, playback_.frame(), changed};
  const double at = footage->note(playback_.frame()).time;
  begin(std::move(plan), at);
}

void Session::perform(const modeling::TargetName& target, std::vector<modeling::SceneTrackKey> keys) {
  if (hasRun()) run_.worker().perform(target, std::move(keys));
}

void Session::performCollider(const modeling::SceneCollider& prototype,
                              std::vector<modeling::SceneTrackKey> path) {
  if (hasRun()) run_.worker().performCollider(prototype, std::move(path));
}

}  // namespace ui
