#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "modeling/scene/scene.h"
#include "sim/dynamics/simulation.h"
#include "sim/take/take.h"

/// A run and what it leaves on the disk.
namespace modeling {

/// The text of a scene as it stands in a take: complete in itself, without presets.
std::string recordedText(const Scene& scene);
/// What stands at the head of a take of the scene.
sim::TakeHeader takeHeaderOf(const Scene& scene);
/// Begins the take of a run of the scene from the start. The file is replaced. A Problem where it cannot be
/// written.
sim::Result<std::unique_ptr<sim::TakeWriter>> createTake(const std::filesystem::path& path,
                                                         const Scene& scene, const sim::Network& network);

/// Records a run, frame by frame. Whoever owns the simulation advances it and asks for frames when they are
/// due: at the first step at or after k / framesPerSecond, frame 0 at the start. No step is two frames. The
/// end is a frame too, whether or not it falls on one, so that it can be resumed.
///
/// Where frames and checkpoints fall has no influence on the motion and follows from the simulation's time
/// alone, so that a resumed run goes on as the unbroken one would have. Not thread-safe.
class Recording {
 public:
  struct Plan {
    double framesPerSecond = 24.0;
    double until = 0.0;  ///< s: when the run ends
  };
  /// What one call of record() wrote.
  struct Frame {
    sim::SnapshotPointer moment;          ///< null where there is no take to write to
    std::vector<sim::BreakEvent> breaks;  ///< since the frame before
  };

  /// Records a run that begins: its first frame is due at once and gets a checkpoint, so that every take can
  /// be resumed. `take` may be null; then breaks are counted and nothing is written. Keeps a reference to the
  /// simulation.
  static Recording ofNewRun(sim::Simulation& simulation, std::unique_ptr<sim::TakeWriter> take, Plan plan);
  /// Records a run that goes on: the simulation's present state is the take's last frame, which has a
  /// checkpoint.
  static Recording ofContinuedRun(sim::Simulation& simulation, std::unique_ptr<sim::TakeWriter> take,
                                  Plan plan);

  const Plan& plan() const { return plan_; }
  /// s: when the next frame is due; the end of the run where that comes first.
  double nextFrameTime() const;
  bool hasEnded() const;
  /// The present moment is the last frame.
  bool isRecorded() const { return recordedStep_ == simulation_.stepCount(); }

  /// Makes the present moment a frame. A Problem where it cannot be written: then nothing is lost, and it can
  /// be asked for again. A checkpoint that could not be written is no Problem: the frame stands, and the
  /// checkpoint is tried again with the next frame.
  sim::Result<Frame> record();
  /// The scene was added to while it ran (perform.h). Written before the next frame.
  void setScene(std::shared_ptr<const Scene> scene) { unwrittenScene_ = std::move(scene); }
  /// Breaks that stand in the take already, before a continued run goes on.
  void countEarlier(const std::vector<sim::BreakEvent>& breaks) { count(breaks); }

  /// Ends the take with the last frame's checkpoint, where that is missing, and how the run ended. Nothing
  /// can be recorded afterwards.
  sim::Status finish(const std::string& outcome);
  /// Ends the take with the Problem that stopped the run.
  sim::Status fail(const sim::Problem& problem);

  /// Advances to the end, records and finishes. `watcher` is called after each step and has to be quick. The
  /// Problem is what stopped the run, a blow-up or a take that cannot be written; the take then ends with its
  /// words.
  sim::Status run(const std::function<void(const sim::Simulation&)>& watcher);

  std::optional<double> firstBreak() const { return firstBreak_; }  ///< s
  std::uint64_t breaks() const { return breaks_; }
  /// Nodes that were left out of frames because they had not moved.
  std::uint64_t nodesLeftOut() const { return take_ ? take_->nodesLeftOut() : nodesLeftOut_; }

 private:
  Recording(sim::Simulation& simulation, std::unique_ptr<sim::TakeWriter> take, Plan plan)
      : simulation_(simulation), take_(std::move(take)), plan_(plan) {}
  sim::Status advanceToEnd(const std::function<void(const sim::Simulation&)>& watcher);
  sim::Status writePerformed();
  void writeCheckpoint();
  sim::Status close(const std::string& outcome);
  void count(const std::vector<sim::BreakEvent>& breaks);

  sim::Simulation& simulation_;
  std::unique_ptr<sim::TakeWriter> take_;
  Plan plan_;
  std::optional<std::uint64_t> recordedStep_;  ///< the step of the last frame
  std::uint64_t framesSinceCheckpoint_ = 0;
  std::vector<sim::BreakEvent> unrecorded_;      ///< since the last frame that was written
  std::shared_ptr<const Scene> unwrittenScene_;  ///< null: the take has the newest
  std::optional<double> firstBreak_;             ///< s
  std::uint64_t breaks_ = 0;
  std::uint64_t nodesLeftOut_ = 0;  ///< of a take that has ended
};

}  // namespace modeling
