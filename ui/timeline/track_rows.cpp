#include "ui/timeline/track_rows.h"

#include <QActionGroup>
#include <QHelpEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/session/session.h"
#include "ui/timeline/key_popup.h"
#include "ui/timeline/time_axis.h"
#include "ui/timeline/time_bar.h"
#include "ui/timeline/time_painting.h"
#include "ui/timeline/track_painting.h"

namespace ui {
namespace {

constexpr double kDragStart = 3.0;  ///< px: a press becomes a drag after so much
constexpr double kTwisty = 26.0;    ///< px: left of it a click opens and closes a row

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
  connect(&session_.document(), &Document::sceneChanged, this, &TrackRows::followTracks);
  connect(&session_.document(), &Document::replaced, this, [this] { known_.clear(); });
  connect(&session_.selection(), &Selection::changed, this, qOverload<>(&QWidget::update));
  connect(&axis_, &TimeAxis::changed, this, [this] {
    shownCursor_ = bar_.xOf(bar_.cursorTime());
    update();
  });
  connect(&session_, &Session::shownChanged, this, &TrackRows::moveCursor);
  followTracks();
}

const Tracks& TrackRows::tracks() const {
  return session_.document().scene().tracks;
}

TrackLayout TrackRows::trackLayout() const {
  std::optional<TrackLayout::Steady> steady;
  if (grabbed_) steady.emplace(TrackLayout::Steady{grabbed_->handle.place.track, grabbed_->before});
  return {tracks(), expanded_, axis_, static_cast<double>(width()), steady};
}

QSize TrackRows::sizeHint() const {
  return {400, static_cast<int>(trackLayout().height())};
}

QPointF TrackRows::pointOf(const KeyPlace& place, std::size_t component) const {
  return trackLayout().pointOf({place, component});
}

/// Tracks come and go by undo, by other panels and by what is performed in a run, also while the mouse holds
/// one.
void TrackRows::followTracks() {
  std::set<std::size_t> expanded;
  for (const std::size_t track : expanded_) {
    if (const auto place = followedTrack(known_, tracks(), track)) expanded.insert(*place);
  }
  expanded_ = std::move(expanded);
  if (selected_) selected_ = followedKey(known_, tracks(), *selected_);
  if (grabbed_) {
    KeyPlace& held = grabbed_->handle.place;
    const std::optional<std::size_t> track = followedTrack(known_, tracks(), held.track);
    // A drag begins from where the key was: keys that came or went meanwhile leave it without a beginning.
    if (track && tracks()[*track].keys.size() == grabbed_->before.keys.size()) {
      held.track = *track;
    } else {
      grabbed_.reset();
    }
  }
  known_ = tracks();
  fit();
}

void TrackRows::fit() {
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

void TrackRows::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  const TrackLayout shown = trackLayout();
  paintTracks(painter,
              {shown, session_.selection(), selected_, bar_.cursorTime(), shownCursor_, size(), font()},
              event->rect());
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
  const std::optional<std::size_t> track = trackLayout().trackAt(at.y());
  if (!track || event->button() == Qt::MiddleButton) return;
  selectTrack(*track);
  selected_.reset();
  if (const std::optional<KeyHandle> handle = trackLayout().handleAt(at)) {
    selected_ = handle->place;
    if (event->button() == Qt::LeftButton) {
      grabbed_ = Grabbed{*handle, at, tracks()[*track], false};
      ++gestures_;
    }
  } else if (at.x() < kTwisty && event->button() == Qt::LeftButton) {
    setExpanded(*track, !isExpanded(*track));
  }
  update();
}

void TrackRows::mouseMoveEvent(QMouseEvent* event) {
  // A release that another window got is seen by the buttons.
  if (grabbed_ && event->buttons() == Qt::NoButton) {
    grabbed_.reset();
    session_.document().endGesture();
  }
  if (!grabbed_) {
    setCursor(trackLayout().handleAt(event->position()) ? Qt::SizeAllCursor : Qt::ArrowCursor);
    return;
  }
  const QPointF moved = event->position() - grabbed_->pressedAt;
  if (!grabbed_->moved && moved.manhattanLength() < kDragStart) return;
  grabbed_->moved = true;
  dragTo(event->position(), event->modifiers());
}

void TrackRows::dragTo(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  const Grabbed grabbed = *grabbed_;
  const auto [track, key] = grabbed.handle.place;
  const modeling::SceneTrackKey& before = grabbed.before.keys[key];
  double time = before.time + (at.x() - grabbed.pressedAt.x()) * axis_.secondsPerPixel();
  const double fps = session_.document().scene().output.fps;
  if (modifiers.testFlag(Qt::ControlModifier)) time = std::round(time * fps) / fps;
  sim::Vec3 value = modeling::asVector(before.value);
  // Along one axis only where Shift says so: the one along which it was moved more.
  const QPointF moved = at - grabbed.pressedAt;
  const bool one = modifiers.testFlag(Qt::ShiftModifier);
  const bool upright = std::abs(moved.y()) > std::abs(moved.x());
  if (one && upright) time = before.time;
  if (isExpanded(track) && !(one && !upright)) {
    const TrackLayout shown = trackLayout();
    const double change = shown.valueAtY(track, at.y()) - shown.valueAtY(track, grabbed.pressedAt.y());
    double& component = value[static_cast<Eigen::Index>(grabbed.handle.component)];
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
  modeling::TrackValue value = valueAt(found, time);
  if (isExpanded(track) && !found.target.isVector())
    value = std::max(trackLayout().valueAtY(track, at.y()), leastOf(found.target));
  std::size_t place = 0;
  editTrack(tr("Add Key"), track, [&](modeling::SceneTrack& edited) { place = addKey(edited, time, value); });
  selected_ = KeyPlace{track, place};
  update();
}

void TrackRows::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const QPointF at = event->position();
  const std::optional<std::size_t> track = trackLayout().trackAt(at.y());
  if (!track) return;
  grabbed_.reset();
  if (at.x() < kTimelineHeader) {
    setExpanded(*track, !isExpanded(*track));
  } else if (const std::optional<KeyHandle> handle = trackLayout().handleAt(at)) {
    typeKey(handle->place);
  } else {
    addKeyAt(*track, at);
  }
}

void TrackRows::typeKey(const KeyPlace& place) {
  auto* popup = new KeyPopup(session_.document(), place, this);
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
        tr("Move Key"), grabbed.handle.place.track,
        [&](modeling::SceneTrack& edited) { edited = grabbed.before; },
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
  const std::optional<std::size_t> found = trackLayout().trackAt(at.y());
  if (!found) return;
  const std::size_t track = *found;
  QMenu menu(this);
  // What it offers is about this track and this key: it closes where tracks change under it.
  connect(&session_.document(), &Document::sceneChanged, &menu, [this, &menu, before = tracks()] {
    if (tracks() != before) menu.close();
  });
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
  QToolTip::showText(help->globalPos(), tipAt(QPointF(help->pos())), this);
  return true;
}

QString TrackRows::tipAt(const QPointF& at) const {
  const TrackLayout shown = trackLayout();
  if (const std::optional<KeyHandle> handle = shown.handleAt(at)) {
    const auto [track, key] = handle->place;
    return tr("%1 s. Drag to move it in time%2; double-click to type; Delete takes it away.")
        .arg(tracks()[track].keys[key].time, 0, 'f', 4)
        .arg(isExpanded(track) ? tr(" and value") : QString());
  }
  if (shown.trackAt(at.y()) && at.x() >= kTimelineHeader)
    return tr("Double-click: add a key. Ctrl and wheel: zoom the time.");
  return {};
}

}  // namespace ui
