#pragma once

#include <QWidget>
#include <optional>
#include <set>

#include "ui/timeline/track_edits.h"

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
  /// A key, counted in its track.
  struct KeyPlace {
    std::size_t track = 0;
    std::size_t key = 0;
    bool operator==(const KeyPlace&) const = default;
  };
  const std::optional<KeyPlace>& selectedKey() const { return selected_; }
  bool isExpanded(std::size_t track) const { return expanded_.contains(track); }
  void setExpanded(std::size_t track, bool expanded);
  /// Where the diamond of a key is; of one component of its value.
  QPointF pointOf(const KeyPlace& place, std::size_t component = 0) const;

  /// Of a row that is closed and of one that shows its curve.
  static constexpr int kRowHeight = 28;
  static constexpr int kExpandedHeight = 104;

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
  struct Span {
    double least = 0.0;
    double most = 1.0;
  };
  struct Grabbed {
    KeyPlace place;
    std::size_t component = 0;
    QPointF pressedAt;
    modeling::SceneTrack before;
    bool moved = false;
  };

  const std::vector<modeling::SceneTrack>& tracks() const;
  QRectF rowOf(std::size_t track) const;
  std::optional<std::size_t> trackAt(double y) const;
  Span spanOf(const modeling::SceneTrack& track) const;
  double yOf(std::size_t track, double value) const;
  double valueAtY(std::size_t track, double y) const;
  std::optional<Grabbed> keyAt(const QPointF& at) const;

  void paintHeader(QPainter& painter, std::size_t track);
  void paintCurve(QPainter& painter, std::size_t track);
  void paintKeys(QPainter& painter, std::size_t track);
  void paintScale(QPainter& painter, std::size_t track);

  void editTrack(const QString& name, std::size_t track,
                 const std::function<void(modeling::SceneTrack&)>& change, const QString& gesture = {});
  void dragTo(const QPointF& at, Qt::KeyboardModifiers modifiers);
  void addKeyAt(std::size_t track, const QPointF& at);
  void removeSelected();
  void typeKey(const KeyPlace& place);
  void fit();
  void selectTrack(std::size_t track);
  void moveCursor();

  Session& session_;
  TimeAxis& axis_;
  TimeBar& bar_;
  std::set<std::size_t> expanded_;
  std::optional<KeyPlace> selected_;
  std::optional<Grabbed> grabbed_;
  int gestures_ = 0;
  double shownCursor_ = 0.0;  ///< px
};

}  // namespace ui
