#pragma once

#include <QRectF>
#include <QSizeF>
#include <vector>

#include "ui/viewport/pick.h"

/// What clicks and frames in the picture select. With Shift or Ctrl they change what is selected, else they
/// replace it. What is locked is passed over.
namespace ui {

class Session;
class ViewCamera;

/// A click on what lies under the pointer.
void selectPicked(Session& session, const Pick& pick, Qt::KeyboardModifiers modifiers);
/// Shown parts of which a node is in the frame, and colliders whose middle is. The frame is in logical pixels
/// of a view of that size.
std::vector<Item> itemsIn(const QRectF& frame, Session& session, const ViewCamera& camera,
                          const QSizeF& size);
/// A frame that was drawn around these.
void selectFramed(Session& session, std::vector<Item> items, Qt::KeyboardModifiers modifiers);

}  // namespace ui
