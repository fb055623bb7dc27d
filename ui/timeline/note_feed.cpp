#include "ui/timeline/note_feed.h"

#include <algorithm>

#include "ui/session/session.h"

namespace ui {
namespace {

/// How often one looks what has been found out about a take that was opened.
constexpr int kRefreshMilliseconds = 300;

}  // namespace

NoteFeed::NoteFeed(Session& session, QObject* parent) : QObject(parent), session_(session) {
  connect(&session_, &Session::runChanged, this, &NoteFeed::look);
  connect(&session_.playback(), &Playback::stateChanged, this, &NoteFeed::look);
  connect(&timer_, &QTimer::timeout, this, &NoteFeed::refresh);
  timer_.setInterval(kRefreshMilliseconds);
  look();
}

void NoteFeed::look() {
  const std::shared_ptr<Footage>& footage = session_.playback().footage();
  if (footage != footage_) {
    footage_ = footage;
    readAll();
    return;
  }
  if (!footage_ || footage_->frameCount() <= notes_.size()) return;
  const std::size_t from = notes_.size();
  for (FrameNote& note : footage_->notes(from)) {
    mostBreaks_ = std::max(mostBreaks_, note.breaks);
    notes_.push_back(note);
  }
  notedCount_ = footage_->notedCount();
  emit grown(from);
}

void NoteFeed::refresh() {
  if (footage_ && footage_->notedCount() != notedCount_) readAll();
}

void NoteFeed::readAll() {
  notedCount_ = footage_ ? footage_->notedCount() : 0;
  notes_ = footage_ ? footage_->notes() : std::vector<FrameNote>();
  mostBreaks_ = 0;
  for (const FrameNote& note : notes_) mostBreaks_ = std::max(mostBreaks_, note.breaks);
  if (notedCount_ < notes_.size()) {
    timer_.start();
  } else {
    timer_.stop();
  }
  emit reset();
}

}  // namespace ui
