#include "ui/timeline/track_rows.h"

#include <QActionGroup>
#include <QHelpEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/session/session.h"
#include "ui/timeline/key_popup.h"
#include "ui/timeline/time_axis.h"
#include "ui/timeline/time_bar.h"
#include "ui/timeline/time_painting.h"

namespace ui {
namespace {

/// px: a key is caught from so far, and a press becomes a drag after so much.
constexpr double kReach = 7.0;
constexpr double kDragStart = 3.0;
constexpr double kRowMargin = 14.0;

QString textOf(sim::Interpolation interpolation) {
  switch (interpolation) {
    case sim::Interpolation::step:
      return TrackRows::tr("Step: Hold until the Next Key");
    case sim::Interpolation::linear:
      return TrackRows::tr("Linear: Straight to the Next Key");
    case sim::Interpolation::smooth:
      return TrackRows::tr("Smooth: Ease at Both Keys");
  }
  return {};
}

}  // namespace

TrackRows::TrackRows(Session& session, TimeAxis& axis, TimeBar& bar, QWidget* parent)
    : QWidget(parent), session_(session), axis_(axis), bar_(bar) {
  setObjectName(QStringLiteral("trackRows"));
  setMouseTracking(true);
  setFocusPolicy(Qt::ClickFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Tracks"));
  connect(&session_.document(), &Document::sceneChanged, this, &TrackRows::fit);
  connect(&session_.selection(), &Selection::changed, this, qOverload<>(&QWidget::update));
  connect(&axis_, &TimeAxis::changed, this, [this] {
    shownCursor_ = bar_.xOf(bar_.cursorTime());
    update();
  });
  connect(&session_, &Session::shownChanged, this, &TrackRows::moveCursor);
  fit();
}

const std::vector<modeling::SceneTrack>& TrackRows::tracks() const {
  return session_.document().scene().tracks;
}

QSize TrackRows::sizeHint() const {
  const std::size_t count = tracks().size();
  return {400, count == 0 ? kRowHeight : static_cast<int>(rowOf(count - 1).bottom())};
}

void TrackRows::fit() {
  const std::size_t count = tracks().size();
  std::erase_if(expanded_, [&](std::size_t track) { return track >= count; });
  if (selected_ && (selected_->track >= count || selected_->key >= tracks()[selected_->track].keys.size()))
    selected_.reset();
  if (const int wanted = sizeHint().height(); wanted != height()) {
    setFixedHeight(wanted);
    emit heightChanged();
  }
  update();
}

void TrackRows::setExpanded(std::size_t track, bool expanded) {
  if (expanded) {
    expanded_.insert(track);
  } else {
    expanded_.erase(track);
  }
  fit();
}

QRectF TrackRows::rowOf(std::size_t track) const {
  double top = 0.0;
  for (std::size_t before = 0; before < track; ++before)
    top += isExpanded(before) ? kExpandedHeight : kRowHeight;
  return {0.0, top, static_cast<double>(width()),
          static_cast<double>(isExpanded(track) ? kExpandedHeight : kRowHeight)};
}

std::optional<std::size_t> TrackRows::trackAt(double y) const {
  for (std::size_t track = 0; track < tracks().size(); ++track) {
    const QRectF row = rowOf(track);
    if (y >= row.top() && y < row.bottom()) return track;
  }
  return std::nullopt;
}

TrackRows::Span TrackRows::spanOf(const modeling::SceneTrack& track) const {
  Span span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const modeling::SceneTrackKey& key : track.keys) {
    const sim::Vec3 value = asVector(key.value);
    for (std::size_t c = 0; c < componentsOf(track.target); ++c) {
      span.least = std::min(span.least, value[static_cast<Eigen::Index>(c)]);
      span.most = std::max(span.most, value[static_cast<Eigen::Index>(c)]);
    }
  }
  if (span.most - span.least < 1e-9 * std::max(std::abs(span.most), 1.0)) {
    const double room = std::max(0.5 * std::abs(span.most), 0.5);
    return {span.least - room, span.most + room};
  }
  return span;
}

/// While a key is dragged the scale stands still, so that the key stays under the pointer.
double TrackRows::yOf(std::size_t track, double value) const {
  const QRectF row = rowOf(track);
  if (!isExpanded(track)) return row.center().y();
  const bool held = grabbed_ && grabbed_->place.track == track;
  const Span span = spanOf(held ? grabbed_->before : tracks()[track]);
  const double share = (value - span.least) / (span.most - span.least);
  return row.bottom() - kRowMargin - share * (row.height() - 2.0 * kRowMargin);
}

double TrackRows::valueAtY(std::size_t track, double y) const {
  const QRectF row = rowOf(track);
  const bool held = grabbed_ && grabbed_->place.track == track;
  const Span span = spanOf(held ? grabbed_->before : tracks()[track]);
  const double share = (row.bottom() - kRowMargin - y) / (row.height() - 2.0 * kRowMargin);
  return span.least + share * (span.most - span.least);
}

QPointF TrackRows::pointOf(const KeyPlace& place, std::size_t component) const {
  const modeling::SceneTrackKey& key = tracks().at(place.track).keys.at(place.key);
  return {kTimelineHeader + axis_.xOf(key.time),
          yOf(place.track, asVector(key.value)[static_cast<Eigen::Index>(component)])};
}

std::optional<TrackRows::Grabbed> TrackRows::keyAt(const QPointF& at) const {
  const std::optional<std::size_t> track = trackAt(at.y());
  if (!track || at.x() < kTimelineHeader) return std::nullopt;
  std::optional<Grabbed> nearest;
  double distance = kReach;
  const modeling::SceneTrack& found = tracks()[*track];
  for (std::size_t key = 0; key < found.keys.size(); ++key) {
    const std::size_t components = isExpanded(*track) ? componentsOf(found.target) : 1;
    for (std::size_t c = 0; c < components; ++c) {
      const QPointF apart = pointOf({*track, key}, c) - at;
      const double length = std::max(std::abs(apart.x()), std::abs(apart.y()));
      if (length > distance) continue;
      distance = length;
      nearest = Grabbed{{*track, key}, c, at, found, false};
    }
  }
  return nearest;
}

void TrackRows::editTrack(const QString& name, std::size_t track,
                          const std::function<void(modeling::SceneTrack&)>& change, const QString& gesture) {
  session_.document().edit(
      name, [&](modeling::Scene& scene) { change(scene.tracks.at(track)); }, gesture);
}

void TrackRows::selectTrack(std::size_t track) {
  session_.selection().select({ItemKind::track, track});
}

void TrackRows::mousePressEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  const std::optional<std::size_t> track = trackAt(at.y());
  if (!track || event->button() == Qt::MiddleButton) return;
  selectTrack(*track);
  selected_.reset();
  if (std::optional<Grabbed> key = keyAt(at)) {
    selected_ = key->place;
    if (event->button() == Qt::LeftButton) {
      grabbed_ = std::move(key);
      ++gestures_;
    }
  } else if (at.x() < 26.0 && event->button() == Qt::LeftButton) {
    setExpanded(*track, !isExpanded(*track));
  }
  update();
}

void TrackRows::mouseMoveEvent(QMouseEvent* event) {
  if (!grabbed_) {
    setCursor(keyAt(event->position()) ? Qt::SizeAllCursor : Qt::ArrowCursor);
    return;
  }
  const QPointF moved = event->position() - grabbed_->pressedAt;
  if (!grabbed_->moved && moved.manhattanLength() < kDragStart) return;
  grabbed_->moved = true;
  dragTo(event->position(), event->modifiers());
}

void TrackRows::dragTo(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  const Grabbed grabbed = *grabbed_;
  const auto [track, key] = grabbed.place;
  const modeling::SceneTrackKey& before = grabbed.before.keys[key];
  double time = before.time + (at.x() - grabbed.pressedAt.x()) * axis_.secondsPerPixel();
  const double fps = session_.document().scene().output.fps;
  if (modifiers.testFlag(Qt::ControlModifier)) time = std::round(time * fps) / fps;
  sim::Vec3 value = asVector(before.value);
  // Along one axis only where Shift says so: the one along which it was moved more.
  const QPointF moved = at - grabbed.pressedAt;
  const bool one = modifiers.testFlag(Qt::ShiftModifier);
  const bool upright = std::abs(moved.y()) > std::abs(moved.x());
  if (one && upright) time = before.time;
  if (isExpanded(track) && !(one && !upright)) {
    const double change = valueAtY(track, at.y()) - valueAtY(track, grabbed.pressedAt.y());
    double& component = value[static_cast<Eigen::Index>(grabbed.component)];
    component += change;
    component = std::max(component, leastOf(grabbed.before.target));
  }
  editTrack(
      tr("Move Key"), track,
      [&](modeling::SceneTrack& edited) {
        moveKey(edited, key, time);
        edited.keys[key].value = asValue(edited.target, value);
      },
      QStringLiteral("move key %1").arg(gestures_));
}

void TrackRows::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !grabbed_) return;
  grabbed_.reset();
  session_.document().endGesture();
  update();
}

void TrackRows::addKeyAt(std::size_t track, const QPointF& at) {
  const double time = std::max(axis_.timeAt(at.x() - kTimelineHeader), 0.0);
  const modeling::SceneTrack& found = tracks().at(track);
  TrackValue value = valueAt(found, time);
  if (isExpanded(track) && !found.target.isVector())
    value = std::max(valueAtY(track, at.y()), leastOf(found.target));
  std::size_t place = 0;
  editTrack(tr("Add Key"), track, [&](modeling::SceneTrack& edited) { place = addKey(edited, time, value); });
  selected_ = KeyPlace{track, place};
  update();
}

void TrackRows::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const QPointF at = event->position();
  const std::optional<std::size_t> track = trackAt(at.y());
  if (!track) return;
  grabbed_.reset();
  if (at.x() < kTimelineHeader) {
    setExpanded(*track, !isExpanded(*track));
  } else if (const std::optional<Grabbed> key = keyAt(at)) {
    typeKey(key->place);
  } else {
    addKeyAt(*track, at);
  }
}

void TrackRows::typeKey(const KeyPlace& place) {
  auto* popup = new KeyPopup(session_.document(), place.track, place.key, this);
  popup->open(mapToGlobal(pointOf(place).toPoint()));
}

void TrackRows::removeSelected() {
  if (!selected_) return;
  const KeyPlace place = *selected_;
  selected_.reset();
  session_.document().edit(tr("Delete Key"),
                           [&](modeling::Scene& scene) { removeKey(scene, place.track, place.key); });
}

void TrackRows::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) {
    removeSelected();
  } else if (event->key() == Qt::Key_Return && selected_) {
    typeKey(*selected_);
  } else if (event->key() == Qt::Key_Escape && grabbed_) {
    const Grabbed grabbed = *std::exchange(grabbed_, std::nullopt);
    editTrack(
        tr("Move Key"), grabbed.place.track, [&](modeling::SceneTrack& edited) { edited = grabbed.before; },
        QStringLiteral("move key %1").arg(gestures_));
    session_.document().endGesture();
  } else {
    QWidget::keyPressEvent(event);
  }
}

void TrackRows::wheelEvent(QWheelEvent* event) {
  // With Ctrl the time is zoomed; else the list of tracks scrolls.
  if (!event->modifiers().testFlag(Qt::ControlModifier)) {
    event->ignore();
    return;
  }
  axis_.zoom(std::pow(0.8, event->angleDelta().y() / 120.0), event->position().x() - kTimelineHeader);
}

void TrackRows::contextMenuEvent(QContextMenuEvent* event) {
  const QPointF at(event->pos());
  const std::optional<std::size_t> found = trackAt(at.y());
  if (!found) return;
  const std::size_t track = *found;
  QMenu menu(this);
  auto* group = new QActionGroup(&menu);
  for (const auto kind : {sim::Interpolation::step, sim::Interpolation::linear, sim::Interpolation::smooth}) {
    QAction* action = menu.addAction(textOf(kind));
    action->setCheckable(true);
    action->setChecked(tracks()[track].interpolation == kind);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, track, kind] {
      editTrack(tr("Change Interpolation"), track,
                [kind](modeling::SceneTrack& edited) { edited.interpolation = kind; });
    });
  }
  menu.addSeparator();
  if (at.x() >= kTimelineHeader && !selected_)
    connect(menu.addAction(tr("Add Key Here")), &QAction::triggered, this,
            [this, track, at] { addKeyAt(track, at); });
  if (selected_) {
    connect(menu.addAction(tr("Type Its Time and Value...")), &QAction::triggered, this,
            [this] { typeKey(*selected_); });
    connect(menu.addAction(tr("Delete Key")), &QAction::triggered, this, &TrackRows::removeSelected);
  }
  connect(menu.addAction(tr("Delete Track")), &QAction::triggered, this, [this, track] {
    session_.document().edit(tr("Delete Track"), [track](modeling::Scene& scene) {
      scene.tracks.erase(scene.tracks.begin() + static_cast<std::ptrdiff_t>(track));
    });
  });
  menu.exec(event->globalPos());
}

void TrackRows::moveCursor() {
  const double x = bar_.xOf(bar_.cursorTime());
  if (std::abs(x - shownCursor_) < 0.25) return;
  for (const double at : {shownCursor_, x}) update(QRectF(at - 2.0, 0.0, 4.0, height()).toAlignedRect());
  shownCursor_ = x;
  update(QRect(0, 0, kTimelineHeader, height()));
}

bool TrackRows::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && selected_) {
    // While a key is selected these are meant for it.
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Delete || key == Qt::Key_Backspace || key == Qt::Key_Return) event->accept();
  }
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QString tip;
  if (const std::optional<Grabbed> key = keyAt(QPointF(help->pos()))) {
    const modeling::SceneTrackKey& found = tracks()[key->place.track].keys[key->place.key];
    tip = tr("%1 s. Drag to move it in time%2; double-click to type; Delete takes it away.")
              .arg(found.time, 0, 'f', 4)
              .arg(isExpanded(key->place.track) ? tr(" and value") : QString());
  } else if (trackAt(help->pos().y()) && help->pos().x() >= kTimelineHeader) {
    tip = tr("Double-click: add a key. Ctrl and wheel: zoom the time.");
  }
  QToolTip::showText(help->globalPos(), tip, this);
  return true;
}

}  // namespace ui
