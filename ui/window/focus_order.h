#pragma once

#include <QWidget>
#include <vector>

class QMainWindow;

namespace ui {

/// What of the panel Tab goes through, as one reads: lines from above, each from the left. Forms are made
/// anew while panels stay, so that the order in which widgets were made says nothing.
std::vector<QWidget*> readingOrder(const QWidget& panel);

/// The places of the window that are seen, each of which has something that can have the focus: bars, what is
/// at the left, in the middle, at the right, and below.
std::vector<QWidget*> placesOf(const QMainWindow& window);

/// Gives the focus to the next in the window, or the one before; false where there is none.
bool moveFocus(const QMainWindow& window, bool forwards);
/// The same from place to place.
void moveFocusToPlace(const QMainWindow& window, bool forwards);

}  // namespace ui
