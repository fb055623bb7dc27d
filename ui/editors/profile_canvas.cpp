#include "ui/editors/profile_canvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>

#include "ui/editors/problem_text.h"
#include "ui/editors/profile_drawing.h"
#include "ui/kinds/bezier_edit.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

using modeling::Vec2;

constexpr double kGrabDistance = 9.0;   ///< pixels
constexpr double kCurveDistance = 7.0;  ///< pixels
constexpr double kSnapDistance = 9.0;   ///< pixels
constexpr double kDragDistance = 3.0;   ///< pixels: less is a click

constexpr std::array kSides{ProfileSide::outside, ProfileSide::inside};

double distance(const QPointF& a, const QPointF& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

}  // namespace

ProfileCanvas::ProfileCanvas(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("profile-canvas"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void ProfileCanvas::setModel(std::optional<ProfileModel> model) {
  const bool appears = model && !model_;
  model_ = std::move(model);
  if (!model_) framed_ = false;
  // Another shape than the one that is held came from elsewhere, such as an undo.
  if (drag_ != Drag::pan) letGo();
  ControlSet left;
  for (const ControlId& control : selected_)
    if (model_ && model_->has(control)) left.insert(control);
  hovered_.reset();
  hoveredCurve_.reset();
  setSelected(left);
  if (appears) frame();
  update();
}

void ProfileCanvas::letGo() {
  drag_ = Drag::none;
  dragBase_.reset();
  grabbed_.reset();
  snapMark_.reset();
  boxBase_.clear();
}

void ProfileCanvas::setSelected(ControlSet controls) {
  selected_ = std::move(controls);
  update();
  emit selectionChanged();
}

void ProfileCanvas::setMode(Mode mode) {
  if (mode == mode_) return;
  mode_ = mode;
  hoveredCurve_.reset();
  update();
  emit modeChanged();
}

void ProfileCanvas::frame() {
  if (!model_ || !isVisible()) return;
  Eigen::AlignedBox2d box;
  for (const ProfileSide side : kSides)
    for (const Vec2& point : controlsOf(model_->chain(side))) box.extend(point);
  view_.frame(box, size());
  framed_ = true;
  update();
}

void ProfileCanvas::apply(const QString& name, const std::function<sim::Status(ProfileModel&)>& change) {
  if (!model_) return;
  ProfileModel changed = *model_;
  const sim::Status done = change(changed);
  if (!done) {
    emit refused(textOf(done.problem()));
    return;
  }
  emit refused({});
  model_ = std::move(changed);
  std::erase_if(selected_, [this](const ControlId& control) { return !model_->has(control); });
  emit edited(name, model_->shape(), {});
  update();
}

void ProfileCanvas::deleteSelected() {
  const ControlSet controls = selected_;
  apply(tr("Delete profile points"), [&](ProfileModel& model) { return model.remove(controls); });
  if (model_) setSelected({});
}

void ProfileCanvas::smoothSelected() {
  apply(tr("Smooth profile points"), [&](ProfileModel& model) {
    model.makeSmooth(selected_);
    return sim::Done{};
  });
}

void ProfileCanvas::cornerSelected() {
  apply(tr("Corners of profile"), [&](ProfileModel& model) {
    model.makeCorner(selected_);
    return sim::Done{};
  });
}

void ProfileCanvas::straightenSelected() {
  apply(tr("Straighten profile"), [&](ProfileModel& model) {
    model.straighten(selected_);
    return sim::Done{};
  });
}

bool ProfileCanvas::showsHandle(const ControlId& handle) const {
  if (!model_->has(handle) || handle.isPoint()) return false;
  const ControlId point = handle.point();
  const ControlId partner{handle.side, 2 * point.index - handle.index};
  // The facing handle of the same segment bends it as well.
  const ControlId facing{handle.side, handle.index % 3 == 1 ? handle.index + 1 : handle.index - 1};
  const auto isSelected = [&](const ControlId& control) { return selected_.contains(control); };
  return isSelected(handle) || isSelected(point) || isSelected(partner) || isSelected(facing) ||
         isSelected(facing.point());
}

std::vector<ControlId> ProfileCanvas::shownControls() const {
  std::vector<ControlId> shown;
  for (const ProfileSide side : {ProfileSide::inside, ProfileSide::outside})
    for (std::size_t i = 0; i < model_->controlCount(side); ++i)
      if (const ControlId control{side, i}; control.isPoint() || showsHandle(control))
        shown.push_back(control);
  // Points are drawn over handles, and grabbed before them unless they are selected already.
  std::stable_partition(shown.begin(), shown.end(),
                        [](const ControlId& control) { return !control.isPoint(); });
  return shown;
}

std::optional<ControlId> ProfileCanvas::controlAt(const QPointF& pixel) const {
  if (!model_) return std::nullopt;
  std::optional<ControlId> best;
  double nearest = kGrabDistance;
  const std::vector<ControlId> shown = shownControls();
  for (auto control = shown.rbegin(); control != shown.rend(); ++control) {
    const double here = distance(view_.toPixel(model_->position(*control)), pixel);
    if (here >= nearest) continue;
    nearest = here;
    best = *control;
  }
  return best;
}

std::optional<ProfileCanvas::CurvePlace> ProfileCanvas::curveAt(const QPointF& pixel) const {
  if (!model_) return std::nullopt;
  std::optional<CurvePlace> best;
  double nearest = kCurveDistance;
  for (const ProfileSide side : kSides) {
    const NearestPlace place =
        nearestPlace(model_->chain(side), [&](const Vec2& at) { return distance(view_.toPixel(at), pixel); });
    if (place.distance >= nearest || place.t <= 0.0 || place.t >= 1.0) continue;
    nearest = place.distance;
    best = CurvePlace{side, place.segment, place.t};
  }
  return best;
}

Vec2 ProfileCanvas::snapped(const Vec2& at) {
  snapMark_.reset();
  const QPointF pixel = view_.toPixel(at);
  for (const ProfileSide side : kSides)
    for (const std::size_t index : {std::size_t{0}, model_->controlCount(side) - 1}) {
      const ControlId end{side, index};
      if (selected_.contains(end) || (grabbed_ && grabbed_->side == side)) continue;
      const Vec2 there = model_->position(end);
      if (distance(view_.toPixel(there), pixel) < kSnapDistance) return *(snapMark_ = there);
      // Level with the other profile's end, which makes a level rim.
      const double level = view_.toPixel(there).y();
      if (grabbed_ && model_->isEnd(*grabbed_) && std::abs(level - pixel.y()) < 0.5 * kSnapDistance)
        return *(snapMark_ = Vec2(std::round(at.x() / view_.fineGrid()) * view_.fineGrid(), there.y()));
    }
  const double grid = view_.fineGrid();
  Vec2 result(std::round(at.x() / grid) * grid, std::round(at.y() / grid) * grid);
  if (std::abs(view_.toPixel({0.0, 0.0}).x() - pixel.x()) < kSnapDistance) {
    result.x() = 0.0;
    snapMark_ = result;
  }
  return result;
}

void ProfileCanvas::insertAt(const CurvePlace& place) {
  ControlId added;
  apply(tr("Insert profile point"), [&](ProfileModel& model) {
    added = model.insert(place.side, place.segment, place.t);
    return sim::Done{};
  });
  setSelected({added});
  hoveredCurve_.reset();
}

void ProfileCanvas::mousePressEvent(QMouseEvent* event) {
  pressed_ = pointer_ = event->position();
  if (event->button() == Qt::MiddleButton) {
    drag_ = Drag::pan;
    setCursor(Qt::ClosedHandCursor);
    return;
  }
  if (event->button() != Qt::LeftButton || !model_) return;
  emit refused({});
  grabbed_ = controlAt(pressed_);
  const bool adds = event->modifiers().testFlag(Qt::ShiftModifier);
  if (grabbed_) {
    ControlSet wanted = selected_;
    if (adds && wanted.contains(*grabbed_)) {
      wanted.erase(*grabbed_);
    } else if (adds) {
      wanted.insert(*grabbed_);
    } else if (!wanted.contains(*grabbed_)) {
      wanted = {*grabbed_};
    }
    setSelected(wanted);
    drag_ = Drag::waiting;
    dragBase_ = model_;
    return;
  }
  const std::optional<CurvePlace> place = curveAt(pressed_);
  if (mode_ == Mode::insert && place) {
    insertAt(*place);
    if (!model_ || selected_.empty()) return;
    grabbed_ = *selected_.begin();
    drag_ = Drag::waiting;
    dragBase_ = model_;
    return;
  }
  drag_ = Drag::box;
  boxBase_ = adds ? selected_ : ControlSet{};
  if (!adds) setSelected({});
}

void ProfileCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !model_ || controlAt(event->position())) return;
  if (const auto place = curveAt(event->position())) insertAt(*place);
}

void ProfileCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF moved = event->position() - pointer_;
  // A release that another window got is seen by the buttons.
  if (event->buttons() == Qt::NoButton) letGo();
  pointer_ = event->position();
  switch (drag_) {
    case Drag::pan:
      view_.pan(moved);
      break;
    case Drag::waiting:
      if (distance(pointer_, pressed_) < kDragDistance) return;
      drag_ = Drag::controls;
      [[fallthrough]];
    case Drag::controls:
      dragControls(pointer_, event->modifiers());
      break;
    case Drag::box:
      selectBox();
      break;
    case Drag::none:
      hovered_ = controlAt(pointer_);
      hoveredCurve_ = hovered_ || mode_ == Mode::select ? std::nullopt : curveAt(pointer_);
      setCursor(hovered_ ? Qt::SizeAllCursor : hoveredCurve_ ? Qt::CrossCursor : Qt::ArrowCursor);
      break;
  }
  update();
}

void ProfileCanvas::dragControls(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  if (!dragBase_ || !grabbed_ || selected_.empty()) return;
  const Vec2 from = dragBase_->position(*grabbed_);
  Vec2 to = from + view_.toPlane(pixel) - view_.toPlane(pressed_);
  if (modifiers.testFlag(Qt::ShiftModifier)) {
    const bool across = std::abs(to.x() - from.x()) > std::abs(to.y() - from.y());
    (across ? to.y() : to.x()) = across ? from.y() : from.x();
  }
  snapMark_.reset();
  if (snaps_ != modifiers.testFlag(Qt::ControlModifier)) to = snapped(to);
  ProfileModel changed = *dragBase_;
  changed.move(selected_, to - from,
               modifiers.testFlag(Qt::AltModifier) ? HandleRule::free : HandleRule::keepSmooth);
  model_ = changed;
  emit edited(selected_.size() > 1 ? tr("Move profile points") : tr("Move profile point"), changed.shape(),
              QStringLiteral("profile drag"));
}

void ProfileCanvas::selectBox() {
  const QRectF box = QRectF(pressed_, pointer_).normalized();
  ControlSet controls = boxBase_;
  for (const ProfileSide side : kSides)
    for (std::size_t i = 0; i < model_->controlCount(side); i += 3)
      if (box.contains(view_.toPixel(model_->position({side, i})))) controls.insert({side, i});
  if (controls != selected_) setSelected(controls);
}

void ProfileCanvas::mouseReleaseEvent(QMouseEvent*) {
  if (drag_ == Drag::controls) emit gestureEnded();
  letGo();
  unsetCursor();
  update();
}

void ProfileCanvas::cancelDrag() {
  if (drag_ == Drag::controls && dragBase_) {
    model_ = dragBase_;
    emit edited(tr("Move profile point"), model_->shape(), QStringLiteral("profile drag"));
    emit gestureEnded();
  }
  letGo();
  update();
}

void ProfileCanvas::wheelEvent(QWheelEvent* event) {
  view_.zoom(std::pow(1.0015, event->angleDelta().y()), event->position());
  update();
}

void ProfileCanvas::nudge(int key, Qt::KeyboardModifiers modifiers) {
  const double step = modifiers.testFlag(Qt::ShiftModifier)     ? view_.coarseGrid()
                      : modifiers.testFlag(Qt::ControlModifier) ? 0.1 * view_.fineGrid()
                                                                : view_.fineGrid();
  const Vec2 way = key == Qt::Key_Left    ? Vec2(-step, 0.0)
                   : key == Qt::Key_Right ? Vec2(step, 0.0)
                   : key == Qt::Key_Up    ? Vec2(0.0, step)
                                          : Vec2(0.0, -step);
  apply(tr("Nudge profile points"), [&](ProfileModel& model) {
    model.move(selected_, way);
    return sim::Done{};
  });
}

bool ProfileCanvas::act(int key) {
  switch (key) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
    case Qt::Key_X:
      deleteSelected();
      return true;
    case Qt::Key_S:
      smoothSelected();
      return true;
    case Qt::Key_C:
      cornerSelected();
      return true;
    case Qt::Key_L:
      straightenSelected();
      return true;
    case Qt::Key_I:
      setMode(mode_ == Mode::insert ? Mode::select : Mode::insert);
      return true;
    case Qt::Key_F:
    case Qt::Key_Home:
      frame();
      return true;
    default:
      return false;
  }
}

void ProfileCanvas::keyPressEvent(QKeyEvent* event) {
  if (!model_) return QWidget::keyPressEvent(event);
  const int key = event->key();
  const bool arrow = key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
  if (key == Qt::Key_Escape) {
    if (drag_ != Drag::none) return cancelDrag();
    if (mode_ == Mode::insert) return setMode(Mode::select);
    return setSelected({});
  }
  if (key == Qt::Key_A && !event->modifiers().testFlag(Qt::ControlModifier)) {
    ControlSet all;
    for (const ProfileSide side : kSides)
      for (std::size_t i = 0; i < model_->controlCount(side); i += 3) all.insert({side, i});
    return setSelected(selected_ == all ? ControlSet{} : all);
  }
  if (arrow && !selected_.empty()) return nudge(key, event->modifiers());
  const bool plain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
  if (!plain || !act(key)) QWidget::keyPressEvent(event);
}

/// Keys that mean something here are not taken for shortcuts of the window.
bool ProfileCanvas::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && model_) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool plain = !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    static constexpr std::array kKeys{Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_X,      Qt::Key_S,
                                      Qt::Key_C,      Qt::Key_L,         Qt::Key_I,      Qt::Key_F,
                                      Qt::Key_Home,   Qt::Key_A,         Qt::Key_Escape, Qt::Key_Left,
                                      Qt::Key_Right,  Qt::Key_Up,        Qt::Key_Down};
    const bool mine = std::find(kKeys.begin(), kKeys.end(), key->key()) != kKeys.end();
    if (mine && plain) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void ProfileCanvas::resizeEvent(QResizeEvent* event) {
  if (!framed_ || event->oldSize().isEmpty()) return frame();
  const QSize change = event->size() - event->oldSize();
  view_.pan({0.5 * change.width(), 0.5 * change.height()});
}

void ProfileCanvas::leaveEvent(QEvent*) {
  hovered_.reset();
  hoveredCurve_.reset();
  update();
}

void ProfileCanvas::paintEvent(QPaintEvent*) {
  if (!framed_) frame();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  ProfileDrawing drawing(painter, view_, size());
  drawing.grid();
  if (!model_) return;
  drawing.wall(*model_);
  for (const ControlId& control : shownControls()) {
    const bool isHovered = hovered_ == control;
    if (control.isPoint()) {
      drawing.point(*model_, control, selected_.contains(control), isHovered);
    } else {
      drawing.handle(*model_, control, selected_.contains(control), isHovered);
    }
  }
  if (hoveredCurve_) {
    const auto& segment = model_->chain(hoveredCurve_->side)[hoveredCurve_->segment];
    drawing.insertion(modeling::evaluate(segment, hoveredCurve_->t));
  }
  if (snapMark_) drawing.snap(*snapMark_);
  if (drag_ == Drag::box) drawing.selectionBox(QRectF(pressed_, pointer_).normalized());
  drawing.legend();
}

}  // namespace ui
