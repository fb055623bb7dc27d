#pragma once

#include <QObject>
#include <QTimer>
#include <vector>

#include "ui/session/footage.h"

namespace ui {

class Session;

/// What is known of the frames of the take on the timeline, kept up to date while frames are added and while
/// a take that was opened is looked through. What is drawn along the time is drawn from this.
class NoteFeed : public QObject {
  Q_OBJECT

 public:
  explicit NoteFeed(Session& session, QObject* parent = nullptr);

  const std::vector<FrameNote>& notes() const { return notes_; }
  /// Bonds broken in one frame, at most.
  std::uint32_t mostBreaks() const { return mostBreaks_; }

 signals:
  /// All of it is new.
  void reset();
  /// There are more frames, from this one on.
  void grown(std::size_t from);

 private:
  void look();
  void refresh();
  void readAll();

  Session& session_;
  std::shared_ptr<Footage> footage_;
  std::vector<FrameNote> notes_;
  std::size_t notedCount_ = 0;
  std::uint32_t mostBreaks_ = 0;
  QTimer timer_;  ///< runs while notes are incomplete
};

}  // namespace ui
