#include "ui/session/playback.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace ui {
namespace {

double secondsOfClock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Playback::Playback(QObject* parent) : Playback(secondsOfClock, parent) {}

void Playback::setFootage(std::shared_ptr<Footage> footage) {
  if (footage == footage_) return;
  footage_ = std::move(footage);
  direction_ = 0;
  range_.reset();
  frame_ = 0;
  time_ = 0.0;
  emit stateChanged();
  emit frameChanged();
}

void Playback::seek(std::size_t frame) {
  if (!footage_ || footage_->frameCount() == 0) return;
  const std::size_t last = footage_->frameCount() - 1;
  const std::size_t wanted = std::min(frame, last);
  time_ = footage_->note(wanted).time;
  frame_ = wanted;
  emit frameChanged();
}

void Playback::seekTime(double time) {
  if (footage_ && footage_->frameCount() > 0) seek(footage_->frameAt(time));
}

void Playback::stepBy(int frames) {
  const auto wanted = static_cast<std::ptrdiff_t>(frame_) + frames;
  seek(static_cast<std::size_t>(std::max<std::ptrdiff_t>(wanted, 0)));
}

void Playback::toFirst() {
  seek(0);
}

void Playback::toLast() {
  if (footage_ && footage_->frameCount() > 0) seek(footage_->frameCount() - 1);
}

void Playback::toFirstBreak() {
  if (!footage_) return;
  const std::optional<double> time = footage_->firstBreak();
  if (!time) return;
  const std::size_t before = footage_->frameAt(*time);
  seek(footage_->note(before).time < *time ? before + 1 : before);
}

Playback::Range Playback::range() const {
  const double end = footage_ ? footage_->duration() : 0.0;
  if (!range_) return {0.0, end};
  return {std::min(range_->from, end), std::min(range_->to, end)};
}

void Playback::setLoopRange(std::optional<Range> range) {
  range_ = range;
  emit stateChanged();
}

void Playback::play(int direction) {
  if (direction == direction_ || (direction != 0 && !footage_)) return;
  direction_ = direction;
  if (direction != 0) {
    const Range whole = range();
    const bool atEnd = direction > 0 ? time_ >= whole.to : time_ <= whole.from;
    if (atEnd) seekTime(direction > 0 ? whole.from : whole.to);
    tickedAt_ = clock_();
  }
  emit stateChanged();
}

void Playback::tick(bool shown) {
  if (direction_ == 0 || !footage_ || footage_->frameCount() == 0) return;
  const Range whole = range();
  double time = time_;
  if (mode_ == Mode::everyFrame) {
    if (!shown) return;
    const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(frame_) + direction_;
    const bool beyond = next < 0 || next >= static_cast<std::ptrdiff_t>(footage_->frameCount());
    time = beyond ? (direction_ > 0 ? whole.to + 1.0 : whole.from - 1.0)
                  : footage_->note(static_cast<std::size_t>(next)).time;
  } else {
    const double now = clock_();
    time += direction_ * speed_ * (now - std::exchange(tickedAt_, now));
  }
  if (time > whole.to || time < whole.from) {
    const bool forwards = direction_ > 0;
    if (!loops_) {
      play(0);
      seekTime(forwards ? whole.to : whole.from);
      return;
    }
    time = forwards ? whole.from : whole.to;
  }
  time_ = time;
  const std::size_t frame = footage_->frameAt(time);
  if (frame == frame_) return;
  frame_ = frame;
  emit frameChanged();
}

}  // namespace ui
