#include "ui/viewport/transform_tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/theme/theme.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

const QString kGesture = QStringLiteral("transform");
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kMoveSnap = 1.0;  ///< cm
constexpr double kTurnSnap = 15.0 / kDegrees;
constexpr double kScaleSnap = 0.1;
/// Smaller factors, or ones of the other sign, would turn the lattice inside out.
constexpr double kSmallestFactor = 0.01;

double snapped(double value, double step, bool snaps) {
  return snaps ? step * std::round(value / step) : value;
}

std::optional<sim::Vec3> meet(const Ray& ray, const sim::Vec3& point, const sim::Vec3& normal) {
  const double steepness = ray.direction.dot(normal);
  if (std::abs(steepness) < 1e-6) return std::nullopt;
  return ray.origin + (point - ray.origin).dot(normal) / steepness * ray.direction;
}

/// Where along an axis the line of sight comes nearest.
std::optional<double> alongAxis(const Ray& ray, const sim::Vec3& pivot, const sim::Vec3& axis) {
  const double slant = ray.direction.dot(axis);
  const double determinant = 1.0 - slant * slant;
  if (determinant < 1e-6) return std::nullopt;
  const sim::Vec3 between = pivot - ray.origin;
  return (between.dot(ray.direction) * slant - between.dot(axis)) / determinant;
}

}  // namespace

std::optional<TransformGizmo> TransformTool::gizmo(const Viewport& viewport) const {
  Session& session = viewport.session();
  const TransformStart start(session.document().scene(), session.selection().items());
  if (start.isEmpty()) return std::nullopt;
  // Where it is seen, as long as what is seen is what is edited; else where it will be.
  const Eigen::AlignedBox3d box = viewport.selectionBox();
  const bool seen = !session.shown().recorded && !box.isEmpty();
  const Eigen::Quaterniond axes =
      mode_ == TransformMode::scale ? start.orientation() : Eigen::Quaterniond::Identity();
  return TransformGizmo(mode_, seen ? sim::Vec3(box.center()) : start.middle(), axes);
}

bool TransformTool::begin(Viewport& viewport, const TransformHold& hold, const QPointF& at, bool grabbed) {
  const auto handles = gizmo(viewport);
  if (!handles) return false;
  Session& session = viewport.session();
  session.document().endGesture();
  const TransformStart start(session.document().scene(), session.selection().items());
  drag_ =
      Drag{start, session.selection().items(), start, *handles, hold, at, at, grabbed, snaps_, {}, 0.0, {}};
  unfollow();
  following_ = {
      connect(&session.document(), &Document::sceneChanged, this, [this, &session] { followScene(session); }),
      connect(&session.document(), &Document::replaced, this, [this] {
        drag_.reset();
        lit_.reset();
      })};
  update(viewport);
  return true;
}

/// What is held is let go where it is gone, or was put elsewhere by an undo or another scene.
void TransformTool::followScene(Session& session) {
  if (!drag_ || applying_) return;
  if (TransformStart(session.document().scene(), drag_->items) == drag_->present) return;
  session.document().endGesture();
  drag_.reset();
  lit_.reset();
}

void TransformTool::unfollow() {
  for (const QMetaObject::Connection& connection : following_) disconnect(connection);
}

void TransformTool::leave(Viewport& viewport) {
  if (drag_ && drag_->grabbed) end(viewport);
}

bool TransformTool::grab(Viewport& viewport, const QPointF& pointer) {
  if (drag_) cancel(viewport);
  return begin(viewport, {}, pointer, true);
}

QString TransformTool::hint() const {
  switch (mode_) {
    case TransformMode::move:
      return tr(
          "Drag a handle, or press G and move the pointer. X, Y, Z: along an axis; numbers: cm; Ctrl: "
          "whole cm; Enter or click: done; Esc: back");
    case TransformMode::rotate:
      return tr(
          "Drag a ring, or press R and move the pointer. X, Y, Z: about an axis; numbers: degrees; Ctrl: "
          "steps of 15°; Enter or click: done; Esc: back");
    case TransformMode::scale:
      break;
  }
  return tr(
      "Drag a handle, or press S and move the pointer. X, Y, Z: along an axis; numbers: factor; Ctrl: "
      "steps of 0.1; Enter or click: done; Esc: back");
}

bool TransformTool::press(Viewport& viewport, const PointerEvent& event) {
  if (drag_) {
    end(viewport);
    return true;
  }
  // On a recorded moment there are no handles: what they move is not seen.
  const auto handles = gizmo(viewport);
  if (!handles || viewport.session().shown().recorded) return false;
  const auto handle = handles->at(event.position, viewport.camera(), viewport.viewSize());
  return handle && begin(viewport, *handle, event.position, false);
}

void TransformTool::follow(Viewport& viewport, const PointerEvent& event) {
  addTurn(viewport, drag_->at, event.position);
  drag_->at = event.position;
  drag_->snaps = event.modifiers.testFlag(Qt::ControlModifier) != snaps_;
  update(viewport);
}

void TransformTool::move(Viewport& viewport, const PointerEvent& event) {
  if (drag_) follow(viewport, event);
}

void TransformTool::release(Viewport& viewport, const PointerEvent&) {
  if (drag_ && !drag_->grabbed) end(viewport);
}

void TransformTool::hover(Viewport& viewport, const PointerEvent& event) {
  if (drag_) {
    follow(viewport, event);
    return;
  }
  const auto handles = gizmo(viewport);
  lit_ = handles ? handles->at(event.position, viewport.camera(), viewport.viewSize()) : std::nullopt;
}

bool TransformTool::cancel(Viewport& viewport) {
  if (!drag_) return false;
  apply(viewport, Transform{});
  end(viewport);
  return true;
}

void TransformTool::end(Viewport& viewport) {
  viewport.session().document().endGesture();
  unfollow();
  drag_.reset();
  lit_.reset();
}

bool TransformTool::wantsKey(int key, Qt::KeyboardModifiers modifiers) const {
  if (!drag_ || modifiers.testFlag(Qt::AltModifier) || modifiers.testFlag(Qt::MetaModifier)) return false;
  return (key >= Qt::Key_0 && key <= Qt::Key_9) || key == Qt::Key_Period || key == Qt::Key_Comma ||
         key == Qt::Key_Minus || key == Qt::Key_Backspace || key == Qt::Key_X || key == Qt::Key_Y ||
         key == Qt::Key_Z || key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Escape ||
         key == Qt::Key_Space;
}

bool TransformTool::key(Viewport& viewport, int key, Qt::KeyboardModifiers modifiers) {
  if (!wantsKey(key, modifiers) || key == Qt::Key_Escape) return false;
  QString& typed = drag_->typed;
  if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space) {
    end(viewport);
    return true;
  }
  if (key >= Qt::Key_X && key <= Qt::Key_Z) {
    const auto kind = modifiers.testFlag(Qt::ShiftModifier) && mode_ != TransformMode::rotate
                          ? TransformHold::Kind::plane
                          : TransformHold::Kind::axis;
    const TransformHold hold{kind, key - Qt::Key_X};
    drag_->hold = hold == drag_->hold ? TransformHold{} : hold;
  } else if (key == Qt::Key_Backspace) {
    typed.chop(1);
  } else if (key == Qt::Key_Minus) {
    // Like a key of a pocket calculator: it may be thought of last.
    typed = typed.startsWith('-') ? typed.mid(1) : '-' + typed;
  } else if (key == Qt::Key_Period || key == Qt::Key_Comma) {
    if (!typed.contains('.')) typed += '.';
  } else {
    typed += QChar(key);
  }
  update(viewport);
  return true;
}

sim::Vec3 TransformTool::pointerOffset(const Viewport& viewport) const {
  const Ray from = viewport.rayThrough(drag_->from);
  const Ray to = viewport.rayThrough(drag_->at);
  const sim::Vec3 pivot = drag_->gizmo.pivot();
  if (drag_->hold.kind == TransformHold::Kind::axis) {
    const sim::Vec3 axis = drag_->gizmo.direction(drag_->hold.axis);
    const auto start = alongAxis(from, pivot, axis);
    const auto now = alongAxis(to, pivot, axis);
    return start && now ? sim::Vec3((*now - *start) * axis) : sim::Vec3(sim::Vec3::Zero());
  }
  const sim::Vec3 normal = drag_->hold.kind == TransformHold::Kind::plane
                               ? drag_->gizmo.direction(drag_->hold.axis)
                               : viewport.camera().forward();
  const auto start = meet(from, pivot, normal);
  const auto now = meet(to, pivot, normal);
  return start && now ? sim::Vec3(*now - *start) : sim::Vec3(sim::Vec3::Zero());
}

double TransformTool::pointerFactor(const Viewport& viewport) const {
  const auto middle = viewport.project(drag_->gizmo.pivot());
  if (!middle) return 1.0;
  const QPointF start = drag_->from - *middle;
  const QPointF now = drag_->at - *middle;
  // A start in the very middle, as by the handle there, has no length to compare with: 100 pixels double.
  const double length = std::hypot(start.x(), start.y());
  if (length < 16.0) return std::exp(0.007 * (drag_->at.x() - drag_->from.x()));
  return QPointF::dotProduct(now, start) / (length * length);
}

sim::Vec3 TransformTool::turnAxis(const Viewport& viewport) const {
  return drag_->hold.kind == TransformHold::Kind::free ? sim::Vec3(-viewport.camera().forward())
                                                       : drag_->gizmo.direction(drag_->hold.axis);
}

void TransformTool::addTurn(const Viewport& viewport, const QPointF& from, const QPointF& to) {
  const auto middle = viewport.project(drag_->gizmo.pivot());
  if (!middle) return;
  const QPointF before = from - *middle;
  const QPointF after = to - *middle;
  const double turn =
      std::atan2(before.x() * after.y() - before.y() * after.x(), QPointF::dotProduct(before, after));
  // The picture's y points down: what turns right-handed about an axis towards the eye goes anticlockwise.
  const double side = turnAxis(viewport).dot(viewport.camera().forward()) < 0.0 ? -1.0 : 1.0;
  drag_->turned += side * turn;
}

Transform TransformTool::transformOf(const Viewport& viewport) const {
  using Kind = TransformHold::Kind;
  const Drag& drag = *drag_;
  Transform transform;
  transform.mode = mode_;
  transform.pivot = drag.gizmo.pivot();
  bool isNumber = false;
  const double typed = drag.typed.toDouble(&isNumber);
  const int axis = drag.hold.axis;
  if (mode_ == TransformMode::move) {
    transform.offset = pointerOffset(viewport);
    for (int i = 0; i < 3; ++i) transform.offset[i] = snapped(transform.offset[i], kMoveSnap, drag.snaps);
    if (isNumber) transform.offset = typed * drag.gizmo.direction(drag.hold.kind == Kind::axis ? axis : 0);
  } else if (mode_ == TransformMode::rotate) {
    transform.axis = turnAxis(viewport);
    transform.angle = isNumber ? typed / kDegrees : snapped(drag.turned, kTurnSnap, drag.snaps);
  } else {
    const double wanted = isNumber ? typed : snapped(pointerFactor(viewport), kScaleSnap, drag.snaps);
    const double factor = std::max(wanted, kSmallestFactor);
    transform.factors = sim::Vec3::Constant(factor);
    if (drag.hold.kind == Kind::axis)
      transform.factors = sim::Vec3::Ones() + (factor - 1.0) * sim::Vec3::Unit(axis);
    if (drag.hold.kind == Kind::plane) transform.factors[axis] = 1.0;
  }
  return transform;
}

QString TransformTool::nameOfEdit() const {
  switch (mode_) {
    case TransformMode::move:
      return tr("Move");
    case TransformMode::rotate:
      return tr("Rotate");
    case TransformMode::scale:
      break;
  }
  return tr("Scale");
}

void TransformTool::apply(Viewport& viewport, const Transform& transform) {
  const TransformStart start = drag_->start;
  Document& document = viewport.session().document();
  applying_ = true;
  document.edit(
      nameOfEdit(), [&](modeling::Scene& scene) { start.apply(transform, scene); }, kGesture);
  applying_ = false;
  if (drag_) drag_->present = TransformStart(document.scene(), drag_->items);
}

void TransformTool::update(Viewport& viewport) {
  drag_->result = transformOf(viewport);
  apply(viewport, Transform(drag_->result));
  viewport.update();
}

QString TransformTool::readout() const {
  const Drag& drag = *drag_;
  static const QString kAxes = QStringLiteral("XYZ");
  QString held;
  if (drag.hold.kind == TransformHold::Kind::axis) held = QStringLiteral(" ") + kAxes[drag.hold.axis];
  if (drag.hold.kind == TransformHold::Kind::plane) {
    held = QStringLiteral(" ");
    for (int axis = 0; axis < 3; ++axis) {
      if (axis != drag.hold.axis) held += kAxes[axis];
    }
  }
  QString value;
  if (mode_ == TransformMode::move) {
    const sim::Vec3& offset = drag.result.offset;
    value = drag.hold.kind == TransformHold::Kind::axis
                ? tr("%1 cm").arg(offset.dot(drag.gizmo.direction(drag.hold.axis)), 0, 'f', 2)
                : tr("%1, %2, %3 cm")
                      .arg(offset.x(), 0, 'f', 2)
                      .arg(offset.y(), 0, 'f', 2)
                      .arg(offset.z(), 0, 'f', 2);
  } else if (mode_ == TransformMode::rotate) {
    value = tr("%1°").arg(kDegrees * drag.result.angle, 0, 'f', 1);
  } else {
    value = tr("× %1").arg(drag.hold.kind == TransformHold::Kind::axis ? drag.result.factors[drag.hold.axis]
                                                                       : drag.result.factors.maxCoeff(),
                           0, 'f', 2);
  }
  return nameOfEdit() + held + QStringLiteral("  ") + value;
}

void TransformTool::draw(const Viewport& viewport, Overlay& overlay) {
  if (!drag_) {
    const auto handles = gizmo(viewport);
    if (handles && !viewport.session().shown().recorded)
      handles->draw(viewport.camera(), viewport.viewSize(), lit_, overlay);
    return;
  }
  const sim::Vec3 pivot = drag_->gizmo.pivot() + drag_->result.offset;
  const double reach = 1e3 * viewport.camera().pixelSize(pivot, viewport.viewSize());
  for (int axis = 0; axis < 3; ++axis) {
    const bool kept = drag_->hold.kind == TransformHold::Kind::axis && drag_->hold.axis == axis;
    const bool inPlane = drag_->hold.kind == TransformHold::Kind::plane && drag_->hold.axis != axis;
    if (!kept && !inPlane) continue;
    const sim::Vec3 along = reach * drag_->gizmo.direction(axis);
    overlay.line(pivot - along, pivot + along, TransformGizmo::colourOf(axis), 1.5);
  }
  overlay.point(pivot, Theme::instance().colours().accent, 7.0);
  overlay.text(pivot, readout(), Theme::instance().colours().text);
}

}  // namespace ui
