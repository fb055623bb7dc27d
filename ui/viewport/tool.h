#pragma once

#include <QCursor>
#include <QPointF>
#include <QString>
#include <Qt>

#include "ui/viewport/overlay.h"
#include "ui/viewport/pick.h"

namespace ui {

class Viewport;

/// A press, move or release of the pointer, in logical pixels of the viewport.
struct PointerEvent {
  QPointF position;
  Qt::MouseButtons buttons;
  Qt::KeyboardModifiers modifiers;
};

/// One way of using the pointer in the viewport; the viewport has one at a time and gives it the left button
/// (and what of hovering and keys it wants), while navigation stays the viewport's. Changes the scene through
/// Document::edit() only, a drag as one gesture.
class Tool {
 public:
  virtual ~Tool() = default;

  /// What to do next, for the status bar.
  virtual QString hint() const { return {}; }
  virtual QCursor cursor() const { return Qt::ArrowCursor; }
  /// True: taken. False: the viewport selects as it does without a tool.
  virtual bool press(Viewport& viewport, const PointerEvent& event) = 0;
  virtual void move(Viewport& viewport, const PointerEvent& event) = 0;
  virtual void release(Viewport& viewport, const PointerEvent& event) = 0;
  /// Without a button.
  virtual void hover(Viewport& /*viewport*/, const PointerEvent& /*event*/) {}
  /// Esc: ends what is under way as if it had not begun. True: there was something.
  virtual bool cancel(Viewport& /*viewport*/) { return false; }
  /// The keyboard goes to something else: what was begun by a key is done.
  virtual void leave(Viewport& /*viewport*/) {}
  /// True: taken.
  virtual bool key(Viewport& /*viewport*/, int /*key*/, Qt::KeyboardModifiers /*modifiers*/) { return false; }
  /// It takes the key as text, though it is a shortcut elsewhere.
  virtual bool wantsKey(int /*key*/, Qt::KeyboardModifiers /*modifiers*/) const { return false; }
  virtual void draw(const Viewport& viewport, Overlay& overlay) = 0;
};

}  // namespace ui
