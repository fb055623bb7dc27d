#include "ui/timeline/play_actions.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QTabBar>

#include "ui/session/session.h"
#include "ui/theme/theme.h"

namespace ui {

PlayActions::PlayActions(Session& session, QObject* parent) : QObject(parent), session_(session) {
  makeRunActions();
  makePlayActions();
  makeStepActions();
  connect(&session_, &Session::runChanged, this, &PlayActions::show);
  connect(&session_.takes(), &TakeList::changed, this, &PlayActions::show);
  connect(&session_, &Session::shownChanged, this, &PlayActions::show);
  connect(&session_, &Session::previewChanged, this, &PlayActions::show);
  connect(&session_.playback(), &Playback::stateChanged, this, &PlayActions::show);
  show();
}

QAction* PlayActions::make(const QString& text, const QString& icon, const QString& shortcut,
                           const QString& tip) {
  auto* action = new QAction(Theme::icon(icon), text, this);
  QString hint = tip.isEmpty() ? text : tip;
  if (!shortcut.isEmpty()) {
    action->setShortcut(QKeySequence(shortcut));
    hint += QStringLiteral("  (%1)").arg(action->shortcut().toString(QKeySequence::NativeText));
  }
  action->setToolTip(hint);
  return action;
}

void PlayActions::makeRunActions() {
  simulate = make(tr("Simulate"), QStringLiteral("simulate"), QStringLiteral("Ctrl+Space"), {});
  connect(simulate, &QAction::triggered, this, &PlayActions::runOrPause);
  toggle = make(tr("Simulate, Play or Pause"), QStringLiteral("play"), QStringLiteral("Space"), {});
  connect(toggle, &QAction::triggered, &session_, &Session::playOrPause);
  stop = make(tr("Stop"), QStringLiteral("stop"), QStringLiteral("Ctrl+."),
              tr("Stop and keep what is done; once more: back to the scene at rest"));
  connect(stop, &QAction::triggered, this, &PlayActions::end);
  follow = make(tr("Follow the Run"), QStringLiteral("follow"), QStringLiteral("F4"),
                tr("Show the present moment of the run"));
  follow->setCheckable(true);
  connect(follow, &QAction::triggered, &session_, &Session::followRun);
  record = make(tr("Record What Is Performed"), QStringLiteral("record"), QStringLiteral("Shift+R"),
                tr("What is done while it runs becomes keys of the scene's tracks"));
  record->setCheckable(true);
  record->setChecked(session_.records());
  connect(record, &QAction::toggled, this, [this](bool on) { session_.setRecords(on); });
  continueAsWas = make(tr("Continue as It Was"), QStringLiteral("continue-from"), {},
                       tr("A new take that goes on from this frame, with the scene as it was run"));
  connect(continueAsWas, &QAction::triggered, this, [this] { session_.continueFromFrame(false); });
  continueChanged = make(tr("Continue with the Scene as It Is Now"), QStringLiteral("continue-from"),
                         QStringLiteral("Ctrl+Shift+Space"),
                         tr("A new take that goes on from this frame, with the scene as edited since"));
  connect(continueChanged, &QAction::triggered, this, [this] { session_.continueFromFrame(true); });
}

void PlayActions::makePlayActions() {
  play = make(tr("Play"), QStringLiteral("play"), {}, tr("Play the take  (Space)"));
  connect(play, &QAction::triggered, this, [this] { playTowards(1); });
  playBackwards = make(tr("Play Backwards"), QStringLiteral("play-backwards"), QStringLiteral("Shift+Space"),
                       tr("Play the take backwards"));
  connect(playBackwards, &QAction::triggered, this, [this] { playTowards(-1); });
  loop = make(tr("Loop"), QStringLiteral("loop"), QStringLiteral("L"),
              tr("Play over and over; drag along the upper edge of the timeline to choose a range"));
  loop->setCheckable(true);
  connect(loop, &QAction::toggled, this, [this](bool on) { session_.playback().setLoops(on); });
  everyFrame = make(tr("Show Every Frame"), QStringLiteral("every-frame"), QStringLiteral("Shift+E"),
                    tr("Show every frame, however long that takes; else keep to the clock"));
  everyFrame->setCheckable(true);
  connect(everyFrame, &QAction::toggled, this, [this](bool on) {
    session_.playback().setMode(on ? Playback::Mode::everyFrame : Playback::Mode::realTime);
  });
}

void PlayActions::makeStepActions() {
  Playback& playback = session_.playback();
  stepForward = make(tr("Next Frame"), QStringLiteral("step-forward"), QStringLiteral("Right"), {});
  connect(stepForward, &QAction::triggered, this, [this] { step(1); });
  stepBack = make(tr("Previous Frame"), QStringLiteral("step-back"), QStringLiteral("Left"), {});
  connect(stepBack, &QAction::triggered, this, [this] { step(-1); });
  toFirst = make(tr("First Frame"), QStringLiteral("go-first"), QStringLiteral("Shift+Left"), {});
  connect(toFirst, &QAction::triggered, &playback, &Playback::toFirst);
  toLast = make(tr("Last Frame"), QStringLiteral("go-last"), QStringLiteral("Shift+Right"), {});
  connect(toLast, &QAction::triggered, &playback, &Playback::toLast);
  toFirstBreak = make(tr("First Break"), QStringLiteral("first-break"), QStringLiteral("Shift+B"),
                      tr("Go to the moment when the first bond broke"));
  connect(toFirstBreak, &QAction::triggered, &playback, &Playback::toFirstBreak);
  for (QAction* action : {stepForward, stepBack}) action->setAutoRepeat(true);
  for (QAction* action : {simulate, toggle, stop, play, playBackwards, loop}) action->setAutoRepeat(false);
}

void PlayActions::playTowards(int direction) {
  Playback& playback = session_.playback();
  if (session_.followsRun()) playback.toLast();
  playback.play(playback.direction() == direction ? 0 : direction);
}

/// On the present moment of a paused run the next frame has to be made first.
void PlayActions::step(int frames) {
  if (session_.hasRun() && session_.followsRun() && frames > 0) {
    session_.stepRunToFrame();
    return;
  }
  Playback& playback = session_.playback();
  playback.stop();
  if (session_.followsRun()) playback.toLast();
  playback.stepBy(frames);
}

void PlayActions::end() {
  if (session_.hasRun()) {
    session_.stopRun();
  } else if (session_.playback().direction() != 0) {
    session_.playback().stop();
  } else {
    session_.showEdited();
  }
}

void PlayActions::runOrPause() {
  if (!session_.hasRun()) {
    session_.simulate();
    return;
  }
  const bool running = session_.isRunning();
  session_.pauseRun(running);
  if (!running) session_.followRun();
}

void PlayActions::show() {
  const Playback& playback = session_.playback();
  const bool run = session_.hasRun();
  const bool frames = playback.footage() && playback.footage()->frameCount() > 0;
  showSimulate();
  stop->setEnabled(run || playback.direction() != 0 || session_.shown().recorded);
  for (QAction* action : {play, playBackwards, stepForward, stepBack, toFirst, toLast})
    action->setEnabled(frames);
  showDirection();
  toFirstBreak->setEnabled(frames && playback.footage()->firstBreak().has_value());
  loop->setChecked(playback.loops());
  everyFrame->setChecked(playback.mode() == Playback::Mode::everyFrame);
  follow->setVisible(run);
  follow->setChecked(session_.followsRun());
  record->setChecked(session_.records());
  continueAsWas->setEnabled(frames && !session_.followsRun());
  continueChanged->setEnabled(frames && !session_.followsRun());
}

void PlayActions::showDirection() {
  const int direction = session_.playback().direction();
  if (shownDirection_ == direction) return;
  shownDirection_ = direction;
  play->setIcon(Theme::icon(direction > 0 ? QStringLiteral("pause") : QStringLiteral("play")));
  playBackwards->setIcon(
      Theme::icon(direction < 0 ? QStringLiteral("pause") : QStringLiteral("play-backwards")));
}

/// Of a run that is shown sixty times a second little changes: buttons are drawn anew when they do.
void PlayActions::showSimulate() {
  simulate->setEnabled(session_.hasRun() || !session_.document().scene().parts.empty());
  const RunPhase phase = session_.hasRun() ? session_.run()->phase : RunPhase::idle;
  if (shownPhase_ == phase) return;
  shownPhase_ = phase;
  const bool paused = phase == RunPhase::paused;
  const QString shortcut =
      QStringLiteral("  (%1)").arg(simulate->shortcut().toString(QKeySequence::NativeText));
  if (phase == RunPhase::running || phase == RunPhase::preparing) {
    simulate->setText(tr("Pause"));
    simulate->setIcon(Theme::icon(QStringLiteral("pause")));
    simulate->setToolTip(tr("Pause the simulation") + shortcut);
  } else if (paused) {
    simulate->setText(tr("Continue"));
    simulate->setIcon(Theme::icon(QStringLiteral("simulate")));
    simulate->setToolTip(tr("Go on with the simulation") + shortcut);
  } else {
    simulate->setText(tr("Simulate"));
    simulate->setIcon(Theme::icon(QStringLiteral("simulate")));
    simulate->setToolTip(tr("Simulate from the start, as a new take") + shortcut);
  }
}

bool KeysOfFocus::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return QObject::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  // Letters mean nothing in a field of numbers, and are shortcuts there as everywhere.
  const bool letter = key->key() >= Qt::Key_A && key->key() <= Qt::Key_Z;
  const bool plain = (key->modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier;
  if (letter && plain && qobject_cast<QAbstractSpinBox*>(watched) != nullptr) {
    event->ignore();
    return true;
  }
  const bool moves = key->key() == Qt::Key_Left || key->key() == Qt::Key_Right;
  const bool wanted = qobject_cast<QAbstractItemView*>(watched) != nullptr ||
                      qobject_cast<QAbstractSlider*>(watched) != nullptr ||
                      qobject_cast<QAbstractSpinBox*>(watched) != nullptr ||
                      qobject_cast<QComboBox*>(watched) != nullptr ||
                      qobject_cast<QTabBar*>(watched) != nullptr;
  if (!moves || !wanted) return QObject::eventFilter(watched, event);
  event->accept();
  return true;
}

}  // namespace ui
