#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/session/builder.h"
#include "ui/session/current_run.h"
#include "ui/session/frame_loader.h"
#include "ui/session/playback.h"
#include "ui/session/shown.h"
#include "ui/session/take_list.h"

namespace ui {

/// Everything behind the window: the document, what is built of it, the run, the takes and the moment shown.
/// Lives in the window's thread; a timer looks at what the other threads have ready.
class Session : public QObject {
  Q_OBJECT

 public:
  /// Takes are recorded in `takesFolder`, which is made when needed.
  explicit Session(std::filesystem::path takesFolder, QObject* parent = nullptr);
  ~Session() override;

  Document& document() { return document_; }
  Selection& selection() { return selection_; }
  Playback& playback() { return playback_; }
  TakeList& takes() { return takes_; }
  const TakeList& takes() const { return takes_; }

  /// The scene as built last; never null. Older than the scene while isBuilding().
  const std::shared_ptr<const Preview>& preview() const { return preview_; }
  bool isBuilding() const { return builder_.isBusy() || builder_.newest() != preview_; }
  /// What building takes long for, such as "reading cup.fbx, 3 s"; empty: nothing.
  const std::string& waitingFor() const { return waitingFor_; }
  /// Reads no file any longer: what is being built ends with a Problem.
  void giveUpReading() { builder_.giveUp(); }
  /// The run as it was told last; never null.
  const std::shared_ptr<const RunView>& run() const { return run_.view(); }
  /// It runs, or is about to.
  bool isRunning() const { return run_.isPreparingOrRunning(); }
  /// Running or paused.
  bool hasRun() const { return run_.isRunningOrPaused(); }
  const Shown& shown() const { return shown_; }

  /// What the space bar does: pauses or goes on with a run, plays or stops a take that is up to date, else
  /// simulates.
  void playOrPause();
  /// From the start, as a new take.
  void simulate();
  /// From the frame that is shown, as a new take beside the old: with the scene as it is now where `changed`,
  /// else as the take was run.
  void continueFromFrame(bool changed);
  void pauseRun(bool paused) { run_.worker().setPaused(paused); }
  void stepRun() { run_.worker().stepOnce(); }
  void stepRunToFrame() { run_.worker().stepFrame(); }
  void stopRun() { run_.worker().stop(); }
  /// Back to the scene as edited.
  void showEdited();
  /// The frame that is to be shown next; nothing where what is shown is what was asked for last.
  struct AwaitedFrame {
    std::shared_ptr<Footage> footage;
    std::size_t frame = 0;
  };
  std::optional<AwaitedFrame> awaitedFrame() const;
  /// The window follows the run; else it stays on the frame of the cursor.
  bool followsRun() const { return following_; }
  void followRun();

  void setPace(const Pace& pace) { run_.worker().setPace(pace); }

  /// What is performed becomes keys of the scene's tracks.
  bool records() const { return recording_; }
  void setRecords(bool records) { recording_ = records; }
  /// While there is a run, from its next step on, from which the times of the keys count; each value holds
  /// until the next. Nothing happens where there is no run.
  void perform(const modeling::TargetName& target, std::vector<modeling::SceneTrackKey> keys);
  void performCollider(const modeling::SceneCollider& prototype, std::vector<modeling::SceneTrackKey> path);

  /// Something to tell the person that no place of its own is made for.
  void report(const sim::Problem& problem) { emit problemFound(problem); }

 signals:
  void previewChanged();
  void waitingChanged();
  void runChanged();
  void shownChanged();
  void problemFound(const sim::Problem& problem);

 private:
  void rebuild();
  void replace();
  void tick();
  void followPreview();
  void followWaiting();
  void followView();
  void recordPerformed();
  void showCurrentTake();
  void letGoOfOthers();
  void showFrame();
  void showLoaded();
  void show(Shown shown);
  void begin(RunPlan plan, std::optional<double> continuedAt);

  Document document_;
  Selection selection_;
  Playback playback_;
  TakeList takes_;
  std::shared_ptr<const Preview> preview_;
  std::string waitingFor_;
  Shown shown_;
  bool following_ = false;
  bool recording_ = true;
  bool listing_ = false;                   ///< the take of a run is being put into the list
  bool ticking_ = false;                   ///< what the cursor does now it does by itself
  bool frameChosen_ = false;               ///< by the person, after the last edit
  std::optional<std::size_t> frameAsked_;  ///< of the loader
  QTimer timer_;
  // Last: their threads end first.
  FrameLoader loader_;
  Builder builder_;
  CurrentRun run_;
};

}  // namespace ui
