#pragma once

#include <QDateTime>
#include <QImage>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/session/builder.h"
#include "ui/session/frame_loader.h"
#include "ui/session/playback.h"
#include "ui/session/shown.h"
#include "ui/session/worker.h"

namespace ui {

/// What is known of a take beside its recording.
struct TakeLabel {
  QString name;
  QString note;
  std::optional<double> continuedAt;  ///< s: where it left the take it was continued from
  QDateTime made;
};

/// A take in the window's list.
struct Take : TakeLabel {
  std::shared_ptr<Footage> footage;
  QImage thumbnail;
  bool stale = false;  ///< the scene has been changed since
  bool own = false;    ///< recorded by the program, which keeps and deletes its file; else somebody's file
};

/// A take that a program which was killed left behind.
struct LeftTake {
  std::filesystem::path file;
  QString name;  ///< empty: none is known
  QString note;
};

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

  /// The scene as built last; never null. Older than the scene while isBuilding().
  const std::shared_ptr<const Preview>& preview() const { return preview_; }
  bool isBuilding() const { return builder_.isBusy(); }
  /// The run as it was told last; never null.
  const std::shared_ptr<const RunView>& run() const { return run_; }
  bool isRunning() const;
  /// Running or paused.
  bool hasRun() const;
  const Shown& shown() const { return shown_; }

  const std::vector<Take>& takes() const { return takes_; }
  /// Which take is on the timeline.
  std::optional<std::size_t> currentTake() const { return currentTake_; }
  void selectTake(std::size_t take);
  void renameTake(std::size_t take, const QString& name);
  void noteTake(std::size_t take, const QString& note);
  void setThumbnail(std::size_t take, const QImage& picture);
  /// Takes it off the list; its file is deleted where it is the program's own.
  void removeTake(std::size_t take);
  /// Some take was recorded by the program itself.
  bool hasOwnTakes() const;
  /// A Problem where the file is no take. Makes it the current one.
  sim::Status openTake(const std::filesystem::path& file);
  /// Puts a take of the program's own into the list, and leaves the timeline as it is.
  sim::Status listTake(const std::filesystem::path& file, const TakeLabel& label, const QImage& thumbnail);
  /// Takes over files of a run that was cut short; those that cannot be read are left out.
  void adoptTakes(const std::vector<LeftTake>& takes);
  /// Copies its file. Asks for a take that is finished.
  sim::Status saveTake(std::size_t take, const std::filesystem::path& file) const;

  /// What the space bar does: pauses or goes on with a run, plays or stops a take that is up to date, else
  /// simulates.
  void playOrPause();
  /// From the start, as a new take.
  void simulate();
  /// From the frame that is shown, as a new take beside the old: with the scene as it is now where `changed`,
  /// else as the take was run.
  void continueFromFrame(bool changed);
  void pauseRun(bool paused) { worker_.setPaused(paused); }
  void stepRun() { worker_.stepOnce(); }
  void stepRunToFrame() { worker_.stepFrame(); }
  void stopRun() { worker_.stop(); }
  /// Back to the scene as edited.
  void showEdited();
  /// The window follows the run; else it stays on the frame of the cursor.
  bool followsRun() const { return following_; }
  void followRun();

  void setPace(const Pace& pace) { worker_.setPace(pace); }

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
  void runChanged();
  void takesChanged();
  /// One of the program's own; its file is being deleted.
  void takeRemoved(const std::filesystem::path& file);
  void shownChanged();
  void problemFound(const sim::Problem& problem);

 private:
  void rebuild();
  void tick();
  void takeView(const std::shared_ptr<const RunView>& view);
  void recordPerformed(const RunView& view);
  void showFrame();
  void showLoaded();
  void show(Shown shown);
  void judgeTakes();
  sim::Status addTake(const std::filesystem::path& file, Take take);
  std::filesystem::path newTakeFile();
  void begin(RunPlan plan, const QString& name);
  QString freshTakeName() const;

  std::filesystem::path takesFolder_;
  Document document_;
  Selection selection_;
  Playback playback_;
  std::shared_ptr<const Preview> preview_;
  std::shared_ptr<const RunView> run_;
  std::vector<Take> takes_;
  std::optional<std::size_t> currentTake_;
  Shown shown_;
  bool following_ = false;
  bool recording_ = true;
  std::uint64_t currentRun_ = 0;   ///< the one last started
  std::size_t performedSeen_ = 0;  ///< of the current run
  bool takeListed_ = false;        ///< of the current run
  bool listing_ = false;           ///< this very moment
  QString nextTakeName_;
  std::optional<double> nextContinuedAt_;
  std::optional<std::size_t> frameAsked_;  ///< of the loader
  std::optional<std::size_t> frameShown_;  ///< of the current take
  QTimer timer_;
  // Last: their threads end first.
  FrameLoader loader_;
  Builder builder_;
  Worker worker_;
};

}  // namespace ui
