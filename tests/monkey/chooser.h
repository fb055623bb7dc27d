#pragma once

#include <QPoint>
#include <QWidget>
#include <deque>
#include <random>

#include "tests/monkey/action.h"
#include "ui/window/main_window.h"

namespace monkey {

/// Chooses what to do next, by chance, with an eye for what there is in the window. The same seed chooses the
/// same where the window is the same; a log says what was chosen.
class Chooser {
 public:
  Chooser(ui::MainWindow& window, std::uint64_t seed) : window_(window), random_(seed) {}

  Action next();
  /// Nothing is held by the mouse or half done.
  bool idle() const { return planned_.empty() && !held_; }

 private:
  Action choose();
  Action inPopup(QWidget& popup);
  Action inDialog(QWidget& dialog);
  Action whileHeld();
  Action fromElsewhere();
  Action ofTheRun();
  Action pointer();
  Action key();
  Action typed();
  Action menu();
  void grabByKey();
  QPoint placeIn(QWidget& top);
  QString word(const QStringList& words);
  int number(int below);
  bool chance(double share);
  QString modifiers();

  ui::MainWindow& window_;
  std::mt19937_64 random_;
  std::deque<Action> planned_;
  bool held_ = false;  ///< the left button is down
  QPoint at_;          ///< of the screen
};

}  // namespace monkey
