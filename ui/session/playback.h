#pragma once

#include <QObject>
#include <cstddef>
#include <functional>
#include <optional>

#include "ui/session/footage.h"

namespace ui {

/// The cursor of the timeline, and how it moves by itself. Knows times and frames, not what is on them.
class Playback : public QObject {
  Q_OBJECT

 public:
  enum class Mode {
    realTime,    ///< keeps to the clock and leaves frames out where it must
    everyFrame,  ///< shows each frame, however long that takes
  };
  /// s, from < to.
  struct Range {
    double from = 0.0;
    double to = 0.0;
  };

  /// s, ever rising.
  using Clock = std::function<double()>;

  explicit Playback(QObject* parent = nullptr);
  Playback(Clock clock, QObject* parent) : QObject(parent), clock_(std::move(clock)) {}

  /// The take that is played; null: none. The cursor goes to its start.
  void setFootage(std::shared_ptr<Footage> footage);
  const std::shared_ptr<Footage>& footage() const { return footage_; }

  std::size_t frame() const { return frame_; }
  /// s: of the cursor, which in real time moves between frames.
  double time() const { return time_; }
  void seek(std::size_t frame);
  void seekTime(double time);
  void stepBy(int frames);
  void toFirst();
  void toLast();
  /// To the first frame in which something is broken; nothing happens where no bond has broken.
  void toFirstBreak();

  /// 1: forwards, -1: backwards, 0: stands.
  int direction() const { return direction_; }
  void play(int direction);
  void stop() { play(0); }

  Mode mode() const { return mode_; }
  void setMode(Mode mode) { mode_ = mode; }
  /// Seconds of the take in one of the clock: below 1 is slow motion.
  double speed() const { return speed_; }
  void setSpeed(double speed) { speed_ = speed; }
  bool loops() const { return loops_; }
  void setLoops(bool loops) { loops_ = loops; }
  const std::optional<Range>& loopRange() const { return range_; }
  void setLoopRange(std::optional<Range> range);

  /// Moves the cursor on by the time that has passed. `shown`: the frame asked for last is on the screen.
  void tick(bool shown);

 signals:
  /// The cursor is on another frame, on one of another take, or was put where it stands once more.
  void frameChanged();
  void stateChanged();

 private:
  Range range() const;

  std::shared_ptr<Footage> footage_;
  std::size_t frame_ = 0;
  double time_ = 0.0;
  int direction_ = 0;
  Mode mode_ = Mode::realTime;
  double speed_ = 1.0;
  bool loops_ = false;
  std::optional<Range> range_;
  Clock clock_;
  double tickedAt_ = 0.0;  ///< s, of the clock
};

}  // namespace ui
