#include "ui/session/playback.h"

#include <algorithm>

namespace ui {

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

void Playback::moveTo(double time, std::size_t frame) {
  time_ = time;
  if (frame == frame_) return;
  frame_ = frame;
  emit frameChanged();
}

void Playback::seek(std::size_t frame) {
  if (!footage_ || footage_->frameCount() == 0) return;
  const std::size_t last = footage_->frameCount() - 1;
  const std::size_t wanted = std::min(frame, last);
  moveTo(footage_->note(wanted).time, wanted);
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
  if (const std::optional<double> time = footage_->firstBreak()) seekTime(*time);
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
    clock_.start();
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
    time += direction_ * speed_ * 1e-9 * static_cast<double>(clock_.nsecsElapsed());
    clock_.start();
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
  moveTo(time, footage_->frameAt(time));
}

}  // namespace ui
