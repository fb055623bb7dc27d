#pragma once

#include <QObject>
#include <QStringList>
#include <optional>

#include "ui/session/run.h"

class QAction;

namespace ui {

class Session;

/// What can be done in time: running, playing, stepping. Made once; shown as buttons on the timeline and as
/// entries of the menu.
class PlayActions : public QObject {
  Q_OBJECT

 public:
  explicit PlayActions(Session& session, QObject* parent = nullptr);

  /// What `simulate` is called, whatever there is to do.
  static QStringList simulateWords() { return {tr("Simulate"), tr("Pause"), tr("Continue")}; }

  QAction* simulate = nullptr;  ///< simulate, pause or continue: what there is to do now
  QAction* toggle = nullptr;    ///< the space bar
  QAction* stop = nullptr;
  QAction* play = nullptr;
  QAction* playBackwards = nullptr;
  QAction* stepForward = nullptr;
  QAction* stepBack = nullptr;
  QAction* toFirst = nullptr;
  QAction* toLast = nullptr;
  QAction* toFirstBreak = nullptr;
  QAction* loop = nullptr;
  QAction* everyFrame = nullptr;
  QAction* follow = nullptr;  ///< back to the present of the run
  QAction* continueAsWas = nullptr;
  QAction* continueChanged = nullptr;
  QAction* record = nullptr;

 private:
  void makeRunActions();
  void makePlayActions();
  void makeStepActions();
  QAction* make(const QString& text, const QString& icon, const QString& shortcut, const QString& tip);
  void playTowards(int direction);
  void step(int frames);
  void end();
  void runOrPause();
  void show();
  void showDirection();
  void showSimulate();

  Session& session_;
  int shownDirection_ = 0;
  std::optional<RunPhase> shownPhase_;
};

/// Lets lists, sliders and fields that have the keyboard keep the arrow keys and the space bar, which else
/// belong to the timeline; letters in fields of numbers stay shortcuts.
class KeysOfFocus : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace ui
