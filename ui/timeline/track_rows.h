#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <set>

#include "ui/timeline/track_following.h"

namespace ui {

class Session;
class TimeAxis;
class TimeBar;

/// The tracks of the scene as rows under the take, with their keys, which are added, dragged and taken away
/// here. A drag is one step of the history.
class TrackRows : public QWidget {
  Q_OBJECT

 public:
  TrackRows(Session& session, TimeAxis& axis, TimeBar& bar, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  const std::optional<KeyPlace>& selectedKey() const { return selected_; }
  bool isExpanded(std::size_t track) const { return expanded_.contains(track); }
  void setExpanded(std::size_t track, bool expanded);
  /// Where the diamond of a key is; of one component of its value.
  QPointF pointOf(const KeyPlace& place, std::size_t component = 0) const;

 signals:
  void heightChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Grabbed {
    KeyHandle handle;
    QPointF pressedAt;
    modeling::SceneTrack before;  ///< its track, as it was when it was pressed
    bool moved = false;
  };

  const Tracks& tracks() const;
  TrackLayout trackLayout() const;
  void followTracks();
  void editTrack(const QString& name, std::size_t track,
                 const std::function<void(modeling::SceneTrack&)>& change, const QString& gesture = {});
  void dragTo(const QPointF& at, Qt::KeyboardModifiers modifiers);
  void addKeyAt(std::size_t track, const QPointF& at);
  void removeSelected();
  void typeKey(const KeyPlace& place);
  void fit();
  void selectTrack(std::size_t track);
  void moveCursor();
  QString tipAt(const QPointF& at) const;

  Session& session_;
  TimeAxis& axis_;
  TimeBar& bar_;
  Tracks known_;  ///< those that all places below are in
  std::set<std::size_t> expanded_;
  std::optional<KeyPlace> selected_;
  std::optional<Grabbed> grabbed_;
  int gestures_ = 0;
  double shownCursor_ = 0.0;  ///< px
};

}  // namespace ui
