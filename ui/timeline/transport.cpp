#include "ui/timeline/transport.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QToolButton>
#include <cmath>

#include "ui/session/session.h"
#include "ui/theme/theme.h"
#include "ui/timeline/play_actions.h"

namespace ui {
namespace {

constexpr double kSpeeds[] = {2.0, 1.0, 0.5, 0.25, 0.1, 0.05, 0.02, 0.01};
constexpr int kFieldHeight = 26;
constexpr int kAroundWord = 46;  ///< icon, gap and margins of a button

void separate(QHBoxLayout& row) {
  auto* line = new QFrame;
  line->setFrameShape(QFrame::VLine);
  line->setFixedSize(1, 18);
  line->setStyleSheet(QStringLiteral("background: palette(mid); border: 0;"));
  row.addSpacing(4);
  row.addWidget(line);
  row.addSpacing(4);
}

void openMenu(QToolButton& button, QMenu* menu) {
  button.setMenu(menu);
  button.setPopupMode(QToolButton::InstantPopup);
  button.setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
}

QString speedLabel(double speed) {
  return QStringLiteral("%1\u00d7").arg(QLocale::c().toString(speed, 'g', 3));
}

}  // namespace

QString timeLeft(double seconds) {
  if (!(seconds > 0.0) || !std::isfinite(seconds)) return {};
  if (seconds < 90.0) return Transport::tr("%1 s left").arg(std::ceil(seconds), 0, 'f', 0);
  constexpr double kLongest = 999.0 * 3600.0;
  if (seconds < 5400.0) return Transport::tr("%1 min left").arg(std::round(seconds / 60.0), 0, 'f', 0);
  return Transport::tr("%1 h left").arg(std::min(seconds, kLongest) / 3600.0, 0, 'f', 1);
}

Transport::Transport(Session& session, PlayActions& actions, QWidget* parent)
    : QWidget(parent), session_(session), actions_(actions) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 4);
  row->setSpacing(1);
  makeButtons(*row);
  separate(*row);
  makeFields(*row);
  separate(*row);
  makeSpeed(*row);
  makeProgress(*row);
  connect(&session_, &Session::runChanged, this, &Transport::showRun);
  connect(&session_, &Session::shownChanged, this, &Transport::showMoment);
  connect(&session_.playback(), &Playback::frameChanged, this, &Transport::showMoment);
  connect(&session_.playback(), &Playback::stateChanged, this, &Transport::showMoment);
  showMoment();
  showRun();
}

QToolButton* Transport::button(QHBoxLayout& row, QAction* action) {
  auto* made = new QToolButton(this);
  made->setDefaultAction(action);
  made->setAutoRaise(true);
  made->setIconSize({18, 18});
  made->setFocusPolicy(Qt::TabFocus);
  row.addWidget(made);
  return made;
}

void Transport::addButton(QAction* action, QMenu* menu) {
  QToolButton* made = button(*end_, action);
  if (menu != nullptr) openMenu(*made, menu);
}

void Transport::makeButtons(QHBoxLayout& row) {
  QToolButton* simulate = button(row, actions_.simulate);
  simulate->setObjectName(QStringLiteral("simulate"));
  simulate->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  // What it says changes with the run; where the others stand does not.
  const QFontMetrics metrics(simulate->font());
  int widest = 0;
  for (const QString& word : PlayActions::simulateWords())
    widest = std::max(widest, metrics.horizontalAdvance(word));
  simulate->setFixedWidth(widest + kAroundWord);
  simulate->setFixedHeight(kFieldHeight + 2);
  simulate->setStyleSheet(QStringLiteral(
      "QToolButton { background: palette(button); border: 1px solid palette(mid); padding: 2px 8px; }"
      "QToolButton:hover, QToolButton:focus { border-color: palette(highlight); }"));
  button(row, actions_.stop);
  button(row, actions_.record);
  separate(row);
  for (QAction* action : {actions_.toFirst, actions_.stepBack, actions_.playBackwards, actions_.play,
                          actions_.stepForward, actions_.toLast})
    button(row, action);
  separate(row);
  button(row, actions_.toFirstBreak);
  QToolButton* go = button(row, actions_.continueChanged);
  auto* menu = new QMenu(go);
  menu->addAction(actions_.continueAsWas);
  menu->addAction(actions_.continueChanged);
  openMenu(*go, menu);
  go->setToolTip(tr("Continue from this frame, as a new take"));
}

void Transport::makeFields(QHBoxLayout& row) {
  time_ = new QDoubleSpinBox(this);
  time_->setObjectName(QStringLiteral("time"));
  time_->setDecimals(4);
  time_->setSuffix(tr(" s"));
  time_->setToolTip(tr("Time of the moment shown, in seconds"));
  frame_ = new QSpinBox(this);
  frame_->setObjectName(QStringLiteral("frame"));
  frame_->setToolTip(tr("Frame shown, counted from 0"));
  frameCount_ = new QLabel(this);
  frameCount_->setFont(Theme::numberFont(-0.5));
  frameCount_->setFixedWidth(QFontMetrics(frameCount_->font()).horizontalAdvance(QStringLiteral("/ 999999")));
  for (QAbstractSpinBox* field :
       {static_cast<QAbstractSpinBox*>(time_), static_cast<QAbstractSpinBox*>(frame_)}) {
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setFont(Theme::numberFont(-0.5));
    field->setAlignment(Qt::AlignRight);
    field->setKeyboardTracking(false);
    field->setFixedHeight(kFieldHeight);
    field->setFocusPolicy(Qt::StrongFocus);
  }
  time_->setFixedWidth(92);
  frame_->setFixedWidth(58);
  row.addWidget(time_);
  row.addSpacing(4);
  row.addWidget(frame_);
  row.addSpacing(4);
  row.addWidget(frameCount_);
  connect(time_, &QDoubleSpinBox::valueChanged, this, [this](double time) {
    session_.playback().stop();
    session_.playback().seekTime(time + 0.5e-4);
  });
  connect(frame_, &QSpinBox::valueChanged, this, [this](int frame) {
    session_.playback().stop();
    session_.playback().seek(static_cast<std::size_t>(frame));
  });
}

void Transport::makeSpeed(QHBoxLayout& row) {
  button(row, actions_.loop);
  button(row, actions_.everyFrame);
  speed_ = new QComboBox(this);
  speed_->setObjectName(QStringLiteral("speed"));
  speed_->setToolTip(tr("Speed of playing: seconds of the take in one of the clock"));
  speed_->setFont(Theme::numberFont(-0.5));
  speed_->setFixedHeight(kFieldHeight);
  for (const double speed : kSpeeds) speed_->addItem(speedLabel(speed), speed);
  speed_->setCurrentIndex(1);
  row.addSpacing(4);
  row.addWidget(speed_);
  connect(speed_, &QComboBox::currentIndexChanged, this,
          [this] { session_.playback().setSpeed(speed_->currentData().toDouble()); });
}

void Transport::makeProgress(QHBoxLayout& row) {
  row.addStretch(1);
  follow_ = button(row, actions_.follow);
  left_ = new QLabel(this);
  left_->setFont(Theme::numberFont(-0.5));
  left_->setContentsMargins(6, 0, 6, 0);
  int widest = 0;
  for (const QString& said :
       {tr("preparing"), tr("paused"), timeLeft(89.0), timeLeft(5399.0), timeLeft(3.6e6)})
    widest = std::max(widest, QFontMetrics(left_->font()).horizontalAdvance(said));
  left_->setFixedWidth(widest + 14);
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedSize(120, 6);
  // Their room is theirs, whether they are seen or not.
  for (QWidget* widget :
       {static_cast<QWidget*>(follow_), static_cast<QWidget*>(left_), static_cast<QWidget*>(progress_)}) {
    QSizePolicy policy = widget->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget->setSizePolicy(policy);
  }
  row.addWidget(progress_);
  row.addWidget(left_);
  end_ = new QHBoxLayout;
  end_->setSpacing(1);
  row.addLayout(end_);
}

void Transport::showMoment() {
  const Playback& playback = session_.playback();
  const std::shared_ptr<Footage>& footage = playback.footage();
  const std::size_t count = footage ? footage->frameCount() : 0;
  const bool live = session_.followsRun() && session_.shown().live && session_.shown().moment;
  const QSignalBlocker timeBlocker(time_);
  const QSignalBlocker frameBlocker(frame_);
  const double end = footage ? footage->duration() : 0.0;
  time_->setRange(0.0, std::max(end, session_.run()->until));
  time_->setValue(live        ? session_.shown().moment->time
                  : count > 0 ? footage->note(playback.frame()).time
                              : 0.0);
  frame_->setRange(0, count > 0 ? static_cast<int>(count) - 1 : 0);
  frame_->setValue(static_cast<int>(live ? count - 1 : playback.frame()));
  frameCount_->setText(QStringLiteral("/ %1").arg(count > 0 ? count - 1 : 0));
  time_->setEnabled(count > 0);
  frame_->setEnabled(count > 0);
}

void Transport::showRun() {
  const bool run = session_.hasRun();
  follow_->setVisible(run);
  progress_->setVisible(run);
  left_->setVisible(run);
  if (!run) return;
  const RunView& view = *session_.run();
  if (view.phase == RunPhase::preparing) {
    left_->setText(tr("preparing"));
  } else {
    const QString left = timeLeft(view.secondsLeft);
    left_->setText(view.phase == RunPhase::paused ? tr("paused") : left);
  }
  if (view.newest && view.until > 0.0)
    progress_->setValue(static_cast<int>(1000.0 * view.newest->time / view.until));
}

}  // namespace ui
